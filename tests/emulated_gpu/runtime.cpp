// SPDX-License-Identifier: Apache-2.0
// The threads of the emulated GPU: each is a fiber that runs until it waits for others.
#include <cuda_runtime.h>

#include <ucontext.h>

#include <algorithm>

namespace emulated_gpu
{
namespace
{

/// A thread of a block.
struct Fiber {
    ucontext_t context{};
    std::vector<char> stack = std::vector<char>(64 * 1024);
    bool done = false;
    bool waits = false;
    Exchange what{};
    unsigned mask = 0;
    std::uint64_t value = 0;
    int distance = 0;
    int width = 0;
    std::uint64_t result = 0;
};

ucontext_t scheduler;
std::vector<std::unique_ptr<Fiber>> fibers; ///< reused from block to block
unsigned running = 0;                       ///< thread
const std::function<void()>* thread_code = nullptr;

void fiber_main()
{
    (*thread_code)();
    fibers[running]->done = true;
    swapcontext(&fibers[running]->context, &scheduler);
}

void start(Fiber& fiber)
{
    fiber.done = false;
    fiber.waits = false;
    getcontext(&fiber.context);
    fiber.context.uc_stack.ss_sp = fiber.stack.data();
    fiber.context.uc_stack.ss_size = fiber.stack.size();
    fiber.context.uc_link = nullptr;
    makecontext(&fiber.context, fiber_main, 0);
}

bool matches(const Fiber& a, const Fiber& b)
{
    return a.waits && !a.done && a.what == b.what && a.mask == b.mask && a.distance == b.distance &&
           a.width == b.width;
}

/// Which lane of its warp a lane gets its value from.
unsigned source(const Fiber& fiber, unsigned lane)
{
    const auto width = static_cast<unsigned>(fiber.width);
    const auto asked_for = static_cast<unsigned>(fiber.distance);
    const unsigned distance = behavior.misreads_lanes && asked_for < 3 ? 3 - asked_for : asked_for;
    const unsigned segment = lane / width * width;
    const unsigned from = fiber.what == Exchange::shuffle_xor ? lane ^ distance : lane + distance;
    return from < segment + width && from >= segment ? from : lane;
}

/// Ends the exchange of thread t's warp when all of its mask have come. \return whether they have
bool complete_exchange(unsigned t)
{
    const Fiber& fiber = *fibers[t];
    const unsigned warp = t / 32 * 32;
    if ((fiber.mask >> (t - warp) & 1U) == 0) {
        stop("thread " + std::to_string(t) + " is not in its own mask");
    }
    std::uint64_t ballot = 0;
    for (unsigned lane = 0; lane < 32; ++lane) {
        if ((fiber.mask >> lane & 1U) != 0) {
            if (warp + lane >= blockDim.x || !matches(*fibers[warp + lane], fiber)) {
                return false;
            }
            ballot |= fibers[warp + lane]->value << lane;
        }
    }
    for (unsigned lane = 0; lane < 32; ++lane) {
        if ((fiber.mask >> lane & 1U) != 0) {
            Fiber& member = *fibers[warp + lane];
            const unsigned from = fiber.what == Exchange::ballot ? lane : source(member, lane);
            if ((fiber.mask >> from & 1U) == 0) {
                stop("lane " + std::to_string(lane) + " reads a lane outside its mask");
            }
            member.result = fiber.what == Exchange::ballot ? ballot : fibers[warp + from]->value;
        }
    }
    for (unsigned lane = 0; lane < 32; ++lane) {
        if ((fiber.mask >> lane & 1U) != 0) {
            fibers[warp + lane]->waits = false;
        }
    }
    return true;
}

bool complete_barrier(unsigned threads)
{
    for (unsigned t = 0; t < threads; ++t) {
        if (!fibers[t]->waits || fibers[t]->what != Exchange::barrier) {
            return false;
        }
    }
    for (unsigned t = 0; t < threads; ++t) {
        fibers[t]->waits = false;
    }
    return true;
}

/// Runs each thread that can go on, once. \return whether one could
bool run_ready(unsigned threads)
{
    bool any = false;
    for (unsigned k = 0; k < threads; ++k) {
        const unsigned t = behavior.runs_backwards ? threads - 1 - k : k;
        Fiber& fiber = *fibers[t];
        if (fiber.done || (fiber.waits && (fiber.what == Exchange::barrier || !complete_exchange(t)))) {
            continue;
        }
        any = true;
        running = t;
        threadIdx = dim3(t);
        swapcontext(&scheduler, &fiber.context);
    }
    return any;
}

void run_block(unsigned threads)
{
    while (fibers.size() < threads) {
        fibers.push_back(std::make_unique<Fiber>());
    }
    for (unsigned t = 0; t < threads; ++t) {
        start(*fibers[t]);
    }
    const auto all_done = [threads] {
        return std::all_of(fibers.begin(), fibers.begin() + threads, [](const auto& f) { return f->done; });
    };
    while (!all_done()) {
        if (!run_ready(threads) && !complete_barrier(threads)) {
            stop("threads wait for others that don't come: a mask or a barrier that not all reach");
        }
    }
}

} // namespace

std::uint64_t exchange(Exchange what, unsigned mask, std::uint64_t value, int distance, int width)
{
    Fiber& fiber = *fibers[running];
    fiber.waits = true;
    fiber.what = what;
    fiber.mask = mask;
    fiber.value = value;
    fiber.distance = distance;
    fiber.width = width;
    swapcontext(&fiber.context, &scheduler);
    return fiber.result;
}

void run_grid(unsigned blocks, unsigned threads, const std::function<void()>& thread)
{
    in_kernel = true;
    thread_code = &thread;
    blockDim = dim3(threads);
    for (unsigned b = 0; b < blocks; ++b) {
        blockIdx = dim3(behavior.runs_backwards ? blocks - 1 - b : b);
        run_block(threads);
    }
    in_kernel = false;
}

} // namespace emulated_gpu
