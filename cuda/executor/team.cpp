// SPDX-License-Identifier: Apache-2.0
#include "cuda/executor/team.hpp"

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace aneurysm::device
{
namespace
{
constexpr int spins_before_sleep = 4000; ///< of a worker: 50 microseconds, longer than any pause in a frame
constexpr int spins_before_yield = 200;  ///< of the caller, who waits for chunks that others have begun

void relax()
{
#if defined(__x86_64__) || defined(__i386__)
    _mm_pause();
#endif
}

} // namespace

Team::Team(int threads)
{
    for (int t = 1; t < threads; ++t) {
        workers_.emplace_back([this] { serve(); });
    }
}

Team::~Team()
{
    ending_ = true;
    ++generation_;
    generation_.notify_all();
    for (std::thread& worker : workers_) {
        worker.join();
    }
}

void Team::share(std::int32_t chunks, const void* work, Call call)
{
    const std::uint32_t generation = generation_.load(std::memory_order_relaxed) + 1;
    done_.store(0, std::memory_order_relaxed);
    chunks_.store(chunks, std::memory_order_relaxed);
    work_.store(work, std::memory_order_relaxed);
    call_.store(call, std::memory_order_relaxed);
    ticket_.store(std::uint64_t{generation} << 32U, std::memory_order_release);
    generation_.store(generation, std::memory_order_release);
    generation_.notify_all();
    while (do_one(generation)) {
    }
    for (int spins = 0; done_.load(std::memory_order_acquire) < chunks; ++spins) {
        if (spins < spins_before_yield) {
            relax();
        } else {
            std::this_thread::yield();
        }
    }
}

/// Takes the next chunk of this loop and works on it. False when there is none left.
bool Team::do_one(std::uint32_t generation)
{
    std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    while (true) {
        const std::int32_t chunks = chunks_.load(std::memory_order_relaxed);
        const void* work = work_.load(std::memory_order_relaxed);
        const Call call = call_.load(std::memory_order_relaxed);
        const auto chunk = static_cast<std::int32_t>(ticket & 0xffffffffU);
        if (ticket >> 32U != generation || chunk >= chunks) {
            return false;
        }
        // Success means that what was read above belongs to this loop: it can't have ended in between.
        if (ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel,
                                          std::memory_order_acquire)) {
            call(work, chunk);
            done_.fetch_add(1, std::memory_order_release);
            return true;
        }
    }
}

void Team::serve()
{
    std::uint32_t seen = 0;
    while (true) {
        for (int spins = 0; generation_.load(std::memory_order_acquire) == seen; ++spins) {
            if (spins < spins_before_sleep) {
                relax();
            } else {
                generation_.wait(seen, std::memory_order_acquire);
            }
        }
        seen = generation_.load(std::memory_order_acquire);
        if (ending_) {
            return;
        }
        while (do_one(seen)) {
        }
    }
}

} // namespace aneurysm::device
