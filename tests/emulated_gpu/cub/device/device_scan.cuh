// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cuda_runtime.h>

namespace cub
{

struct DeviceScan {
    /// Two kernels on a GPU.
    template <class In, class Out>
    static cudaError_t ExclusiveSum(void* temporary, std::size_t& bytes, In in, Out out, int n,
                                    cudaStream_t stream)
    {
        const std::size_t needed = 1024 + static_cast<std::size_t>(n) / 64;
        if (temporary == nullptr) {
            bytes = needed;
            return cudaSuccess;
        }
        if (bytes < needed) {
            return cudaErrorInvalidValue;
        }
        emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, [] {});
        return emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, [in, out, n] {
            auto total = in[0] - in[0];
            for (int i = 0; i < n; ++i) {
                const auto value = in[i];
                out[i] = total;
                total += value;
            }
        });
    }
};

} // namespace cub
