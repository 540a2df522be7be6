// SPDX-License-Identifier: Apache-2.0
// CUDA's runtime, with errors that say where they come from, and handles that are given back.
#pragma once

#include "common/error.hpp"

#include <cuda_runtime.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <type_traits>

namespace aneurysm::device
{

/// "GPU 0 (name)", or without a name where it doesn't answer any more.
inline std::string gpu_name()
{
    cudaDeviceProp properties{};
    const bool known = cudaGetDeviceProperties(&properties, 0) == cudaSuccess;
    return known ? "GPU 0 (" + std::string(properties.name) + ")" : "GPU 0";
}

/// \throws Error that names device, call, place and cause when `result` is no success
inline void check(cudaError_t result, const std::string& call, const char* path = __builtin_FILE(),
                  int line = __builtin_LINE())
{
    if (result == cudaSuccess) {
        return;
    }
    std::string file = path;
    file.erase(0, file.rfind('/') + 1);
    const bool memory = result == cudaErrorMemoryAllocation;
    throw Error(gpu_name(),
                call + " failed at " + file + ":" + std::to_string(line) + ": " + cudaGetErrorString(result) +
                    " (" + cudaGetErrorName(result) + ")",
                memory ? "fewer particles, single precision, or a GPU with more free memory"
                       : "if it happens again, --backend cpu gives the same bits");
}

struct GiveBack {
    void operator()(void* memory) const { cudaFree(memory); }
    void operator()(cudaStream_t stream) const { cudaStreamDestroy(stream); }
    void operator()(cudaGraph_t graph) const { cudaGraphDestroy(graph); }
    void operator()(cudaGraphExec_t graph) const { cudaGraphExecDestroy(graph); }
};
/// Something of CUDA's that is given back at the end.
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, GiveBack>;

/// A stream of its own, which neither waits for the default stream nor makes it wait.
inline Owned<cudaStream_t> make_stream()
{
    cudaStream_t stream = nullptr;
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "cudaStreamCreateWithFlags");
    return Owned<cudaStream_t>(stream);
}

/// Asks for a kernel in a stream; a grid without blocks is none. \throws Error that names its functors
template <class... Parameters, class... Arguments>
void launch(void (*kernel)(Parameters...), unsigned blocks, int threads, cudaStream_t stream,
            const Arguments&... arguments)
{
    if (blocks == 0) {
        return;
    }
    cudaLaunchConfig_t config{};
    config.gridDim = dim3(blocks);
    config.blockDim = dim3(static_cast<unsigned>(threads));
    config.stream = stream;
    const cudaError_t result = cudaLaunchKernelEx(&config, kernel, arguments...);
    if (result != cudaSuccess) {
        check(result, __PRETTY_FUNCTION__);
    }
}

/// The first GPU, made this thread's. \throws Error when there is none that can be used
inline void use_first_gpu()
{
    const std::string advice =
        "needed: an NVIDIA GPU of compute capability 8.0 or newer and a driver for CUDA " +
        std::to_string(CUDART_VERSION / 1000) + "." + std::to_string(CUDART_VERSION % 1000 / 10) +
        ", or use --backend cpu";
    // All code at once: what is loaded later could be loaded while a graph is recorded.
    setenv("CUDA_MODULE_LOADING", "EAGER", 0); // NOLINT(concurrency-mt-unsafe)
    int count = 0;
    int driver = 0;
    const cudaError_t found = cudaGetDeviceCount(&count);
    if (found != cudaSuccess || count == 0) {
        const bool none = cudaDriverGetVersion(&driver) != cudaSuccess || driver == 0;
        throw InputError("--backend cuda",
                         std::string("no GPU answers: ") +
                             (none ? "there is no NVIDIA driver" : cudaGetErrorString(found)),
                         advice);
    }
    check(cudaSetDevice(0), "cudaSetDevice");
    int major = 0;
    check(cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, 0), "cudaDeviceGetAttribute");
    if (major < 8) {
        throw Error(gpu_name(), "its compute capability is " + std::to_string(major) + ".x", advice);
    }
}

/// Where a stream that is being captured stands: the graph, and what the next node will wait for.
struct Capture {
    explicit Capture(cudaStream_t stream)
    {
        cudaStreamCaptureStatus status{};
#if CUDART_VERSION >= 13000
        check(cudaStreamGetCaptureInfo(stream, &status, nullptr, &graph, &last, &edges, &count),
              "cudaStreamGetCaptureInfo");
#else
        check(cudaStreamGetCaptureInfo_v3(stream, &status, nullptr, &graph, &last, &edges, &count),
              "cudaStreamGetCaptureInfo");
#endif
    }

    cudaGraph_t graph = nullptr;
    const cudaGraphNode_t* last = nullptr;
    const cudaGraphEdgeData* edges = nullptr;
    std::size_t count = 0;
};

/// A loop as the next node of a stream that is being captured. \return its body, still empty
inline cudaGraph_t add_while(cudaStream_t stream, cudaGraphConditionalHandle condition)
{
    cudaGraphNodeParams loop{};
    loop.type = cudaGraphNodeTypeConditional;
    loop.conditional.handle = condition;
    loop.conditional.type = cudaGraphCondTypeWhile;
    loop.conditional.size = 1;
    cudaGraphNode_t node = nullptr;
    const Capture at(stream);
#if CUDART_VERSION >= 13000
    check(cudaGraphAddNode(&node, at.graph, at.last, at.edges, at.count, &loop), "cudaGraphAddNode");
    check(cudaStreamUpdateCaptureDependencies(stream, &node, nullptr, 1, cudaStreamSetCaptureDependencies),
          "cudaStreamUpdateCaptureDependencies");
#else
    check(cudaGraphAddNode_v2(&node, at.graph, at.last, at.edges, at.count, &loop), "cudaGraphAddNode");
    check(cudaStreamUpdateCaptureDependencies_v2(stream, &node, nullptr, 1, cudaStreamSetCaptureDependencies),
          "cudaStreamUpdateCaptureDependencies");
#endif
    return loop.conditional.phGraph_out[0];
}

} // namespace aneurysm::device
