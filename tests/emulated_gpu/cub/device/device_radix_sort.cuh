// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cuda_runtime.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace cub
{

struct DeviceRadixSort {
    /// On a GPU a histogram, its sums, and a fill and a kernel for every eight bits.
    template <class Key, class Value>
    static cudaError_t SortPairs(void* temporary, std::size_t& bytes, const Key* keys, Key* sorted,
                                 const Value* values, Value* order, int n, int first_bit, int end_bit,
                                 cudaStream_t stream)
    {
        const std::size_t needed = 1024 + static_cast<std::size_t>(n) * 2 * sizeof(Key);
        if (temporary == nullptr) {
            bytes = needed;
            return cudaSuccess;
        }
        if (bytes < needed) {
            return cudaErrorInvalidValue;
        }
        const auto nothing = [] {};
        emulated_gpu::enqueue(stream, emulated_gpu::Work::copy, nothing);
        emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, nothing);
        emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, nothing);
        for (int bit = first_bit + 8; bit < end_bit; bit += 8) {
            emulated_gpu::enqueue(stream, emulated_gpu::Work::copy, nothing);
            emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, nothing);
        }
        emulated_gpu::enqueue(stream, emulated_gpu::Work::copy, nothing);
        return emulated_gpu::enqueue(stream, emulated_gpu::Work::kernel, [=] {
            const auto mask =
                static_cast<Key>((std::uint64_t{1} << end_bit) - (std::uint64_t{1} << first_bit));
            std::vector<int> places(static_cast<std::size_t>(n));
            std::iota(places.begin(), places.end(), 0);
            std::ranges::stable_sort(places, {}, [&](int i) { return keys[i] & mask; });
            for (int s = 0; s < n; ++s) {
                sorted[s] = keys[places[static_cast<std::size_t>(s)]];
                order[s] = values[places[static_cast<std::size_t>(s)]];
            }
        });
    }
};

} // namespace cub
