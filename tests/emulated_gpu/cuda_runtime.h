// SPDX-License-Identifier: Apache-2.0
// A GPU made of fibers, in the place of CUDA's runtime: as much of it as cuda/ uses, so that the code for the
// GPU runs, and is checked, where there is none. Each thread of a block is a fiber; threads that exchange
// values wait until all that their mask names have come, and a mask that is wrong stops the program. Streams
// do at once what they are asked for, or record it; recorded graphs can be replayed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <type_traits>
#include <vector>

#define __host__
#define __device__
#define __global__
#define __grid_constant__
#define __forceinline__ inline __attribute__((always_inline))
#define __launch_bounds__(threads)
#define CUDART_VERSION 13000

struct dim3 {
    unsigned x = 1;
    unsigned y = 1;
    unsigned z = 1;
    dim3(unsigned along_x = 1) : x(along_x) {}
};
inline dim3 threadIdx;
inline dim3 blockIdx;
inline dim3 blockDim;

enum cudaError_t {
    cudaSuccess = 0,
    cudaErrorInvalidValue = 1,
    cudaErrorMemoryAllocation = 2,
    cudaErrorStreamCaptureUnsupported = 900
};
struct cudaDeviceProp {
    char name[256];
};
enum cudaDeviceAttr { cudaDevAttrComputeCapabilityMajor };

struct CUstream_st;
struct CUgraph_st;
struct CUgraphExec_st;
struct CUgraphNode_st;
using cudaStream_t = CUstream_st*;
using cudaGraph_t = CUgraph_st*;
using cudaGraphExec_t = CUgraphExec_st*;
using cudaGraphNode_t = CUgraphNode_st*;
using cudaGraphConditionalHandle = unsigned long long;
struct cudaGraphEdgeData {
};
enum cudaGraphNodeType { cudaGraphNodeTypeConditional = 13 };
enum cudaGraphConditionalNodeType { cudaGraphCondTypeIf, cudaGraphCondTypeWhile };
struct cudaConditionalNodeParams {
    cudaGraphConditionalHandle handle;
    cudaGraphConditionalNodeType type;
    unsigned size;
    cudaGraph_t* phGraph_out;
};
struct cudaGraphNodeParams {
    cudaGraphNodeType type;
    cudaConditionalNodeParams conditional;
};
enum cudaStreamCaptureStatus { cudaStreamCaptureStatusNone, cudaStreamCaptureStatusActive };
enum cudaStreamCaptureMode { cudaStreamCaptureModeRelaxed = 2 };
enum { cudaStreamNonBlocking = 1, cudaStreamSetCaptureDependencies = 1 };
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };

namespace emulated_gpu
{

/// What threads of a warp do together.
enum class Exchange { shuffle_xor, shuffle_down, ballot, barrier };

/// Waits until all threads of `mask` have come with the same exchange. \return this thread's part of it
std::uint64_t exchange(Exchange what, unsigned mask, std::uint64_t value, int distance, int width);

/// One block after the other, each thread until it ends.
void run_grid(unsigned blocks, unsigned threads, const std::function<void()>& thread);

[[noreturn]] inline void stop(const std::string& why)
{
    std::fprintf(stderr, "emulated GPU: %s\n", why.c_str());
    std::abort();
}

/// How the GPU behaves, to show that what depends on it is noticed.
struct Behavior {
    bool runs_backwards = false; ///< from the last block and thread to the first
    bool executes = true; ///< else nothing is computed and every download is 0, to count what would be done
    bool misreads_lanes = false; ///< sums of lanes in another order
    bool refuses_memory = false; ///< as if none were left
};
inline Behavior behavior;

/// What was asked for.
struct Asked {
    int kernels = 0;           ///< of the graph that was launched last, outside its loops
    std::vector<int> loops;    ///< kernels in one round of each
    std::size_t to_device = 0; ///< bytes from the host
    std::size_t to_host = 0;
};
inline Asked asked;

inline bool in_kernel = false;
inline std::map<cudaGraphConditionalHandle, unsigned> conditions;

enum class Work { kernel, copy };

template <class T>
std::uint64_t bits_of(T value)
{
    static_assert(sizeof(T) <= sizeof(std::uint64_t));
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    return bits;
}
template <class T>
T shuffle(Exchange what, unsigned mask, T value, int distance, int width)
{
    const std::uint64_t bits = exchange(what, mask, bits_of(value), distance, width);
    std::memcpy(&value, &bits, sizeof(T));
    return value;
}

} // namespace emulated_gpu

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

inline void run(const CUgraph_st& graph)
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

/// Its kernels outside its loops, whose own are noted.
inline int count_kernels(const CUgraph_st& graph)
{
    int kernels = 0;
    for (const auto& node : graph.nodes) {
        if (node->body) {
            asked.loops.push_back(count_kernels(*node->body));
        } else {
            kernels += node->kind == Work::kernel ? 1 : 0;
        }
    }
    return kernels;
}

/// Does work, or records it where the stream is being captured.
inline cudaError_t enqueue(cudaStream_t stream, Work kind, const std::function<void()>& work)
{
    if (stream->captured != nullptr) {
        auto node = std::make_unique<CUgraphNode_st>();
        node->kind = kind;
        node->work = work;
        stream->last = node.get();
        stream->captured->nodes.push_back(std::move(node));
    } else if (behavior.executes) {
        work();
    }
    return cudaSuccess;
}

} // namespace emulated_gpu

inline const char* cudaGetErrorString(cudaError_t error)
{
    return error == cudaSuccess ? "no error" : "an error of the emulated GPU";
}
inline const char* cudaGetErrorName(cudaError_t error)
{
    return error == cudaSuccess ? "cudaSuccess" : "cudaError";
}
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int)
{
    std::snprintf(properties->name, sizeof(properties->name), "emulated");
    return cudaSuccess;
}
inline cudaError_t cudaGetDeviceCount(int* count)
{
    *count = 1;
    return cudaSuccess;
}
inline cudaError_t cudaDriverGetVersion(int* version)
{
    *version = CUDART_VERSION;
    return cudaSuccess;
}
inline cudaError_t cudaSetDevice(int)
{
    return cudaSuccess;
}
inline cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr, int)
{
    *value = 9;
    return cudaSuccess;
}

inline cudaError_t cudaMalloc(void** memory, std::size_t bytes)
{
    *memory = emulated_gpu::behavior.refuses_memory ? nullptr : std::malloc(bytes);
    return *memory != nullptr ? cudaSuccess : cudaErrorMemoryAllocation;
}
inline cudaError_t cudaFree(void* memory)
{
    std::free(memory);
    return cudaSuccess;
}
inline cudaError_t cudaMemsetAsync(void* memory, int byte, std::size_t bytes, cudaStream_t stream)
{
    return emulated_gpu::enqueue(stream, emulated_gpu::Work::copy, [=] { std::memset(memory, byte, bytes); });
}
inline cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                                   cudaStream_t stream)
{
    if (stream->captured != nullptr && kind != cudaMemcpyDeviceToDevice) {
        return cudaErrorStreamCaptureUnsupported; // a replay would use host memory that is gone
    }
    if (!emulated_gpu::behavior.executes && kind == cudaMemcpyDeviceToHost) {
        std::memset(to, 0, bytes);
    }
    emulated_gpu::asked.to_device += kind == cudaMemcpyHostToDevice ? bytes : 0;
    emulated_gpu::asked.to_host += kind == cudaMemcpyDeviceToHost ? bytes : 0;
    return emulated_gpu::enqueue(stream, emulated_gpu::Work::copy, [=] { std::memcpy(to, from, bytes); });
}

inline cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned)
{
    *stream = new CUstream_st;
    return cudaSuccess;
}
inline cudaError_t cudaStreamDestroy(cudaStream_t stream)
{
    delete stream;
    return cudaSuccess;
}
inline cudaError_t cudaStreamSynchronize(cudaStream_t stream)
{
    return stream->captured == nullptr ? cudaSuccess : cudaErrorStreamCaptureUnsupported;
}
inline cudaError_t cudaStreamBeginCaptureToGraph(cudaStream_t stream, cudaGraph_t graph,
                                                 const cudaGraphNode_t*, const cudaGraphEdgeData*,
                                                 std::size_t, cudaStreamCaptureMode)
{
    if (stream->captured != nullptr) {
        return cudaErrorInvalidValue;
    }
    *stream = {graph, nullptr};
    return cudaSuccess;
}
inline cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode mode)
{
    return cudaStreamBeginCaptureToGraph(stream, stream->captured != nullptr ? nullptr : new CUgraph_st,
                                         nullptr, nullptr, 0, mode);
}
inline cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph)
{
    *graph = stream->captured;
    stream->captured = nullptr;
    return *graph != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
inline cudaError_t cudaStreamGetCaptureInfo(cudaStream_t stream, cudaStreamCaptureStatus* status,
                                            unsigned long long*, cudaGraph_t* graph,
                                            const cudaGraphNode_t** last, const cudaGraphEdgeData** edges,
                                            std::size_t* count)
{
    *status = stream->captured != nullptr ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
    *graph = stream->captured;
    *last = &stream->last;
    *edges = nullptr;
    *count = stream->last != nullptr ? 1 : 0;
    return stream->captured != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
inline cudaError_t cudaStreamUpdateCaptureDependencies(cudaStream_t stream, cudaGraphNode_t* nodes,
                                                       const cudaGraphEdgeData*, std::size_t count,
                                                       unsigned flags)
{
    const bool sound = stream->captured != nullptr && count == 1 &&
                       flags == cudaStreamSetCaptureDependencies &&
                       stream->captured->nodes.back().get() == *nodes;
    stream->last = *nodes;
    return sound ? cudaSuccess : cudaErrorInvalidValue;
}
inline cudaError_t cudaGraphAddNode(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* last,
                                    const cudaGraphEdgeData*, std::size_t count,
                                    cudaGraphNodeParams* parameters)
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
inline cudaError_t cudaGraphConditionalHandleCreate(cudaGraphConditionalHandle* handle, cudaGraph_t graph,
                                                    unsigned, unsigned)
{
    *handle = emulated_gpu::conditions.size() + 1;
    emulated_gpu::conditions[*handle] = 0;
    return graph != nullptr ? cudaSuccess : cudaErrorInvalidValue;
}
inline cudaError_t cudaGraphInstantiate(cudaGraphExec_t* ready, cudaGraph_t graph, unsigned long long)
{
    *ready = new CUgraphExec_st{graph};
    return cudaSuccess;
}
inline cudaError_t cudaGraphLaunch(cudaGraphExec_t ready, cudaStream_t stream)
{
    emulated_gpu::asked.loops.clear();
    emulated_gpu::asked.kernels = emulated_gpu::count_kernels(*ready->graph);
    return emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel,
                                 [ready] { emulated_gpu::run(*ready->graph); });
}
inline cudaError_t cudaGraphDestroy(cudaGraph_t graph)
{
    delete graph;
    return cudaSuccess;
}
inline cudaError_t cudaGraphExecDestroy(cudaGraphExec_t ready)
{
    delete ready;
    return cudaSuccess;
}
inline void cudaGraphSetConditional(cudaGraphConditionalHandle handle, unsigned value)
{
    if (!emulated_gpu::in_kernel) {
        emulated_gpu::stop("a condition is set outside a kernel");
    }
    emulated_gpu::conditions.at(handle) = value;
}

template <class T>
T __shfl_xor_sync(unsigned mask, T value, int distance, int width)
{
    return emulated_gpu::shuffle(emulated_gpu::Exchange::shuffle_xor, mask, value, distance, width);
}
template <class T>
T __shfl_down_sync(unsigned mask, T value, int distance, int width)
{
    return emulated_gpu::shuffle(emulated_gpu::Exchange::shuffle_down, mask, value, distance, width);
}
inline unsigned __ballot_sync(unsigned mask, bool value)
{
    return static_cast<unsigned>(
        emulated_gpu::exchange(emulated_gpu::Exchange::ballot, mask, value ? 1 : 0, 0, 32));
}
inline void __syncthreads()
{
    emulated_gpu::exchange(emulated_gpu::Exchange::barrier, 0, 0, 0, 0);
}
inline int __popc(unsigned bits)
{
    return __builtin_popcount(bits);
}

struct cudaLaunchConfig_t {
    dim3 gridDim;
    dim3 blockDim;
    cudaStream_t stream;
};
template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               const Arguments&... arguments)
{
    const std::tuple<std::decay_t<Parameters>...> copies(arguments...);
    return emulated_gpu::enqueue(config->stream, emulated_gpu::Work::kernel,
                                 [blocks = config->gridDim.x, threads = config->blockDim.x, kernel, copies] {
                                     emulated_gpu::run_grid(blocks, threads,
                                                            [&] { std::apply(kernel, copies); });
                                 });
}
