// SPDX-License-Identifier: Apache-2.0
#include <cuda_runtime.h>

#include <ucontext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct CUgraphNode_st {
    emulated_gpu::Work kind{};
    std::function<void()> work;
    std::unique_ptr<CUgraph_st> body; ///< of a loop
    cudaGraphConditionalHandle condition = 0;
};
struct CUgraph_st {
    std::vector<std::unique_ptr<CUgraphNode_st>> nodes; ///< each waits for the one before it
};
struct CUgraphExec_st {
    CUgraph_st* graph = nullptr;
};
struct CUstream_st {
    CUgraph_st* captured = nullptr;
    cudaGraphNode_t last = nullptr;
};

namespace emulated_gpu
{
namespace
{

bool backwards = false;
bool executing = true;
bool in_kernel = false;
bool misreading = false;
bool refusing = false;
Asked asked;
std::map<cudaGraphConditionalHandle, unsigned> conditions;

[[noreturn]] void stop(const std::string& why)
{
    std::fprintf(stderr, "emulated GPU: %s\n", why.c_str());
    std::abort();
}

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
    const unsigned distance = misreading && asked_for < 3 ? 3 - asked_for : asked_for;
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
        const unsigned t = backwards ? threads - 1 - k : k;
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

void run(const CUgraph_st& graph)
{
    for (const auto& node : graph.nodes) {
        if (!node->body) {
            node->work();
            continue;
        }
        while (conditions.at(node->condition) != 0) {
            run(*node->body);
        }
    }
}

int count(const CUgraph_st& graph)
{
    int kernels = 0;
    for (const auto& node : graph.nodes) {
        if (node->body) {
            asked.loops.push_back(count(*node->body));
        } else {
            ++(node->kind == Work::kernel ? kernels : asked.copies);
        }
    }
    return kernels;
}

} // namespace

void run_backwards(bool on)
{
    backwards = on;
}
void execute(bool on)
{
    executing = on;
}
void misread_lanes(bool on)
{
    misreading = on;
}
void refuse_memory(bool on)
{
    refusing = on;
}
Asked last_asked()
{
    const Asked last = asked;
    asked.to_device = 0;
    asked.to_host = 0;
    return last;
}

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
        blockIdx = dim3(backwards ? blocks - 1 - b : b);
        run_block(threads);
    }
    in_kernel = false;
}

cudaError_t enqueue(cudaStream_t stream, Work kind, const std::function<void()>& work)
{
    if (stream->captured != nullptr) {
        auto node = std::make_unique<CUgraphNode_st>();
        node->kind = kind;
        node->work = work;
        stream->last = node.get();
        stream->captured->nodes.push_back(std::move(node));
    } else if (executing) {
        work();
    }
    return cudaSuccess;
}

} // namespace emulated_gpu

using namespace emulated_gpu;

const char* cudaGetErrorString(cudaError_t error)
{
    return error == cudaSuccess ? "no error" : "an error of the emulated GPU";
}
const char* cudaGetErrorName(cudaError_t error)
{
    return error == cudaSuccess ? "cudaSuccess" : "cudaError";
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int)
{
    std::snprintf(properties->name, sizeof(properties->name), "emulated");
    return cudaSuccess;
}
cudaError_t cudaGetDeviceCount(int* count)
{
    *count = 1;
    return cudaSuccess;
}
cudaError_t cudaDriverGetVersion(int* version)
{
    *version = CUDART_VERSION;
    return cudaSuccess;
}
cudaError_t cudaSetDevice(int)
{
    return cudaSuccess;
}
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr, int)
{
    *value = 9;
    return cudaSuccess;
}

cudaError_t cudaMalloc(void** memory, std::size_t bytes)
{
    *memory = refusing ? nullptr : std::malloc(bytes);
    return *memory != nullptr ? cudaSuccess : cudaErrorMemoryAllocation;
}
cudaError_t cudaFree(void* memory)
{
    std::free(memory);
    return cudaSuccess;
}
cudaError_t cudaMemsetAsync(void* memory, int byte, std::size_t bytes, cudaStream_t stream)
{
    return enqueue(stream, Work::copy, [=] { std::memset(memory, byte, bytes); });
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                            cudaStream_t stream)
{
    if (stream->captured != nullptr && kind != cudaMemcpyDeviceToDevice) {
        return cudaErrorStreamCaptureUnsupported; // a replay would use host memory that is gone
    }
    if (!executing && kind == cudaMemcpyDeviceToHost) {
        std::memset(to, 0, bytes);
    }
    asked.to_device += kind == cudaMemcpyHostToDevice ? bytes : 0;
    asked.to_host += kind == cudaMemcpyDeviceToHost ? bytes : 0;
    return enqueue(stream, Work::copy, [=] { std::memcpy(to, from, bytes); });
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned)
{
    *stream = new CUstream_st;
    return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t stream)
{
    delete stream;
    return cudaSuccess;
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream)
{
    return stream->captured == nullptr ? cudaSuccess : cudaErrorStreamCaptureUnsupported;
}
cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode)
{
    if (stream->captured != nullptr) {
        return cudaErrorInvalidValue;
    }
    stream->captured = new CUgraph_st;
    stream->last = nullptr;
    return cudaSuccess;
}
cudaError_t cudaStreamBeginCaptureToGraph(cudaStream_t stream, cudaGraph_t graph, const cudaGraphNode_t*,
                                          const cudaGraphEdgeData*, std::size_t, cudaStreamCaptureMode)
{
    if (stream->captured != nullptr) {
        return cudaErrorInvalidValue;
    }
    stream->captured = graph;
    stream->last = nullptr;
    return cudaSuccess;
}
cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph)
{
    *graph = stream->captured;
    stream->captured = nullptr;
    return *graph != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
cudaError_t cudaStreamGetCaptureInfo(cudaStream_t stream, cudaStreamCaptureStatus* status,
                                     unsigned long long*, cudaGraph_t* graph, const cudaGraphNode_t** last,
                                     const cudaGraphEdgeData** edges, std::size_t* count)
{
    *status = stream->captured != nullptr ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
    *graph = stream->captured;
    *last = &stream->last;
    *edges = nullptr;
    *count = stream->last != nullptr ? 1 : 0;
    return stream->captured != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
cudaError_t cudaStreamUpdateCaptureDependencies(cudaStream_t stream, cudaGraphNode_t* nodes,
                                                const cudaGraphEdgeData*, std::size_t count, unsigned flags)
{
    const bool sound = stream->captured != nullptr && count == 1 &&
                       flags == cudaStreamSetCaptureDependencies &&
                       stream->captured->nodes.back().get() == *nodes;
    stream->last = *nodes;
    return sound ? cudaSuccess : cudaErrorInvalidValue;
}
cudaError_t cudaGraphAddNode(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* last,
                             const cudaGraphEdgeData*, std::size_t count, cudaGraphNodeParams* parameters)
{
    const bool sound = count == 1 && !graph->nodes.empty() && graph->nodes.back().get() == *last &&
                       parameters->type == cudaGraphNodeTypeConditional &&
                       parameters->conditional.type == cudaGraphCondTypeWhile &&
                       parameters->conditional.size == 1;
    if (!sound) {
        return cudaErrorInvalidValue;
    }
    static cudaGraph_t body = nullptr;
    graph->nodes.push_back(std::make_unique<CUgraphNode_st>());
    *node = graph->nodes.back().get();
    (*node)->body = std::make_unique<CUgraph_st>();
    (*node)->condition = parameters->conditional.handle;
    body = (*node)->body.get();
    parameters->conditional.phGraph_out = &body;
    return cudaSuccess;
}
cudaError_t cudaGraphConditionalHandleCreate(cudaGraphConditionalHandle* handle, cudaGraph_t graph, unsigned,
                                             unsigned)
{
    *handle = conditions.size() + 1;
    conditions[*handle] = 0;
    return graph != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* ready, cudaGraph_t graph, unsigned long long)
{
    *ready = new CUgraphExec_st{graph};
    return cudaSuccess;
}
cudaError_t cudaGraphLaunch(cudaGraphExec_t ready, cudaStream_t stream)
{
    asked.copies = 0;
    asked.loops.clear();
    asked.kernels = count(*ready->graph);
    return enqueue(stream, Work::kernel, [ready] { run(*ready->graph); });
}
cudaError_t cudaGraphDestroy(cudaGraph_t graph)
{
    delete graph;
    return cudaSuccess;
}
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t ready)
{
    delete ready;
    return cudaSuccess;
}
void cudaGraphSetConditional(cudaGraphConditionalHandle handle, unsigned value)
{
    if (!in_kernel) {
        stop("a condition is set outside a kernel");
    }
    conditions.at(handle) = value;
}
