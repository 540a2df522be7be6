// SPDX-License-Identifier: Apache-2.0
// A GPU made of fibers, in the place of CUDA's runtime: as much of it as cuda/ uses, so that the code for the
// GPU runs, and is checked, where there is none. Each thread of a block is a fiber; threads that exchange
// values wait until all that their mask names have come, and a mask that is wrong stops the program. Streams
// do at once what they are asked for, or record it; recorded graphs can be replayed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
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

namespace emulated_gpu
{

/// What threads of a warp do together.
enum class Exchange { shuffle_xor, shuffle_down, ballot, barrier };

/// Waits until all threads of `mask` have come with the same exchange. \return this thread's part of it
std::uint64_t exchange(Exchange what, unsigned mask, std::uint64_t value, int distance, int width);

/// One block after the other, each thread until it ends.
void run_grid(unsigned blocks, unsigned threads, const std::function<void()>& thread);

/// From the last block and thread to the first: what depends on their order gives other bits then.
void run_backwards(bool backwards);
/// Off: nothing is computed and every download is 0, to count what would be done.
void execute(bool on);

/// A fault of the GPU, to show that it is noticed: sums of lanes in another order.
void misread_lanes(bool on);
/// A GPU that has no memory left.
void refuse_memory(bool on);

/// What was asked for.
struct Asked {
    int kernels = 0;           ///< of the graph that was launched last, outside its loops
    int copies = 0;            ///< and fills
    std::vector<int> loops;    ///< kernels in one round of each
    std::size_t to_device = 0; ///< bytes from the host since the last call
    std::size_t to_host = 0;
};
Asked last_asked();

enum class Work { kernel, copy };

} // namespace emulated_gpu

enum cudaError_t {
    cudaSuccess = 0,
    cudaErrorInvalidValue = 1,
    cudaErrorMemoryAllocation = 2,
    cudaErrorStreamCaptureUnsupported = 900
};
const char* cudaGetErrorString(cudaError_t error);
const char* cudaGetErrorName(cudaError_t error);

struct cudaDeviceProp {
    char name[256];
};
enum cudaDeviceAttr { cudaDevAttrComputeCapabilityMajor };
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int number);
cudaError_t cudaGetDeviceCount(int* count);
cudaError_t cudaDriverGetVersion(int* version);
cudaError_t cudaSetDevice(int number);
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int number);

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

cudaError_t cudaMalloc(void** memory, std::size_t bytes);
cudaError_t cudaFree(void* memory);
cudaError_t cudaMemsetAsync(void* memory, int byte, std::size_t bytes, cudaStream_t stream);
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                            cudaStream_t stream);
cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned flags);
cudaError_t cudaStreamDestroy(cudaStream_t stream);
cudaError_t cudaStreamSynchronize(cudaStream_t stream);
cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode mode);
cudaError_t cudaStreamBeginCaptureToGraph(cudaStream_t stream, cudaGraph_t graph, const cudaGraphNode_t* last,
                                          const cudaGraphEdgeData* edges, std::size_t count,
                                          cudaStreamCaptureMode mode);
cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph);
cudaError_t cudaStreamGetCaptureInfo(cudaStream_t stream, cudaStreamCaptureStatus* status,
                                     unsigned long long* id, cudaGraph_t* graph, const cudaGraphNode_t** last,
                                     const cudaGraphEdgeData** edges, std::size_t* count);
cudaError_t cudaStreamUpdateCaptureDependencies(cudaStream_t stream, cudaGraphNode_t* nodes,
                                                const cudaGraphEdgeData* edges, std::size_t count,
                                                unsigned flags);
cudaError_t cudaGraphAddNode(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* last,
                             const cudaGraphEdgeData* edges, std::size_t count,
                             cudaGraphNodeParams* parameters);
cudaError_t cudaGraphConditionalHandleCreate(cudaGraphConditionalHandle* handle, cudaGraph_t graph,
                                             unsigned value, unsigned flags);
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* ready, cudaGraph_t graph, unsigned long long flags);
cudaError_t cudaGraphLaunch(cudaGraphExec_t ready, cudaStream_t stream);
cudaError_t cudaGraphDestroy(cudaGraph_t graph);
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t ready);
void cudaGraphSetConditional(cudaGraphConditionalHandle handle, unsigned value);

namespace emulated_gpu
{

/// Does work, or records it where the stream is being captured.
cudaError_t enqueue(cudaStream_t stream, Work kind, const std::function<void()>& work);

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
