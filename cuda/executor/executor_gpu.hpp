// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "cuda/executor/cuda_api.hpp"
#include "cuda/executor/executor.hpp"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace aneurysm::device
{

inline constexpr int largest_block = 256; ///< threads; leaves each all of its 255 registers

/// The number of this thread in its grid.
__device__ inline unsigned thread_number()
{
    return blockIdx.x * blockDim.x + threadIdx.x;
}
/// This thread as one of its group's eight. Whole groups leave a kernel early, never a part of one.
__device__ inline Lane this_lane()
{
    return {static_cast<int>(threadIdx.x % lane_count),
            0xffU << (threadIdx.x % 32 / lane_count * lane_count)};
}

template <class F>
__global__ void __launch_bounds__(largest_block) run_each(Extent extent, const __grid_constant__ F f)
{
    const auto i = static_cast<Index>(thread_number());
    if (i < extent.size()) {
        f(i);
    }
}
template <class F>
__global__ void __launch_bounds__(largest_block) run_group(Extent extent, const __grid_constant__ F f)
{
    const auto i = static_cast<Index>(thread_number() / lane_count);
    if (i < extent.size()) {
        f(i, this_lane());
    }
}
template <class F>
__global__ void run_once(const __grid_constant__ F f)
{
    f();
}

/// The value of the lane `distance` above this one, word by word.
template <class Value>
__device__ Value from_above(const Value& value, int distance, Lane lane)
{
    static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(unsigned) == 0);
    constexpr int words = sizeof(Value) / sizeof(unsigned);
    unsigned word[words];
    memcpy(word, &value, sizeof(Value));
    for (int k = 0; k < words; ++k) {
        word[k] = __shfl_down_sync(lane.group, word[k], distance, lane_count);
    }
    Value other;
    memcpy(&other, word, sizeof(Value));
    return other;
}
/// reduce_chunk() by a group of threads: the same sums in the same order. In lane 0.
template <class Value, class Map>
__device__ Value reduce_group(const Map& map, Index c, Index n, Lane lane)
{
    Value value = reduce_lane<Value>(map, c, n, lane.id);
    for (int distance = lane_count / 2; distance > 0; distance /= 2) {
        value += from_above(value, distance, lane);
    }
    return value;
}
template <class Value, class Map>
__global__ void __launch_bounds__(largest_block)
    reduce_chunks(Extent extent, const __grid_constant__ Map map, Value* sums)
{
    const Index n = extent.size();
    const auto c = static_cast<Index>(thread_number() / lane_count);
    if (c < chunks(n)) {
        const Value sum = reduce_group<Value>(map, c, n, this_lane());
        if (this_lane().is_first()) {
            sums[c] = sum;
        }
    }
}
template <class Value>
struct Summed {
    const Value* values;

    ANEURYSM_HD Value operator()(Index i) const { return values[i]; }
};
/// The chunks' sums, level by level as CpuExecutor does it, by one block.
template <class Value>
__global__ void __launch_bounds__(largest_block) reduce_levels(Extent extent, Value* scratch, Value* out)
{
    const Index n = extent.size();
    const Index groups = static_cast<Index>(blockDim.x) / lane_count;
    Index parts = chunks(n);
    while (parts > 1) {
        const Index count = parts;
        parts = chunks(count);
        for (Index c = static_cast<Index>(threadIdx.x) / lane_count; c < parts; c += groups) {
            const Value sum = reduce_group<Value>(Summed<Value>{scratch}, c, count, this_lane());
            if (this_lane().is_first()) {
                scratch[count + c] = sum;
            }
        }
        scratch += count;
        __syncthreads();
    }
    if (threadIdx.x == 0) {
        *out = n > 0 ? scratch[0] : Value{};
    }
}

/// in[i], and 0 behind the actual end: what an earlier use left there doesn't matter.
struct Counted {
    Extent extent;
    const Index* in;

    __device__ Index operator()(Index i) const { return i < extent.size() ? in[i] : 0; }
};

/// By bisection: threads that walk from one key to the next would wait for the one with the longest way.
struct FindStart {
    const Index* sorted;
    Index n;
    Index* start;

    ANEURYSM_HD void operator()(Index key) const
    {
        Index low = 0;
        Index high = n;
        while (low < high) {
            const Index middle = low + (high - low) / 2;
            if (sorted[middle] < key) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        start[key] = low;
    }
};

struct CountUp {
    Index* to;

    ANEURYSM_HD void operator()(Index i) const { to[i] = i; }
};

static __global__ void set_condition(cudaGraphConditionalHandle condition, const Index* go)
{
    cudaGraphSetConditional(condition, *go != 0 ? 1U : 0U);
}

/// Runs device code on the first GPU, in one stream. The size of its blocks doesn't change a bit of any
/// result: nothing is shared between two groups of lanes, and sums have their own fixed shape.
class GpuExecutor
{
public:
    static constexpr Backend backend = Backend::cuda;

    /// `block_size`: threads; 0: the default. \throws InputError when it isn't possible, Error without a GPU
    explicit GpuExecutor(int block_size) : block_(block_size > 0 ? block_size : 128)
    {
        if (block_size < 0 || block_ % 32 != 0 || block_ > largest_block) {
            throw InputError("--block-size", std::to_string(block_size) + " is not possible",
                             "allowed: 0 and multiples of 32 up to " + std::to_string(largest_block));
        }
        use_first_gpu();
        main_ = make_stream();
        body_ = make_stream();
        stream_ = main_.get();
    }

    static std::string device() { return gpu_name(); }
    std::size_t bytes() const { return bytes_; } ///< allocated

    void* allocate(std::size_t bytes)
    {
        void* memory = nullptr;
        check(cudaMalloc(&memory, bytes), "cudaMalloc of " + std::to_string(bytes) + " bytes");
        check(cudaMemsetAsync(memory, poison, bytes, stream_), "cudaMemsetAsync");
        bytes_ += bytes;
        return memory;
    }
    void release(void* memory, std::size_t bytes)
    {
        cudaStreamSynchronize(stream_); // what uses it
        cudaFree(memory);
        bytes_ -= bytes;
    }
    template <class T>
    void upload(T* device, const T* host, std::size_t count)
    {
        check(cudaMemcpyAsync(device, host, count * sizeof(T), cudaMemcpyHostToDevice, stream_),
              "cudaMemcpyAsync to the device");
        check(cudaStreamSynchronize(stream_), "cudaStreamSynchronize"); // the caller may reuse its memory
    }
    template <class T>
    void download(T* host, const T* device, std::size_t count) const
    {
        check(cudaMemcpyAsync(host, device, count * sizeof(T), cudaMemcpyDeviceToHost, stream_),
              "cudaMemcpyAsync to the host");
        check(cudaStreamSynchronize(stream_), "cudaStreamSynchronize");
    }
    template <class T>
    void copy(T* to, const T* from, Index count)
    {
        check(cudaMemcpyAsync(to, from, static_cast<std::size_t>(count) * sizeof(T), cudaMemcpyDeviceToDevice,
                              stream_),
              "cudaMemcpyAsync on the device");
    }

    /// f(i) for each i.
    template <class F>
    void for_each(Extent extent, const F& f)
    {
        launch(run_each<F>, blocks_for(extent.capacity, 1), block_, stream_, extent, f);
    }
    /// f(i, lane) for each i and lane.
    template <class F>
    void for_each_group(Extent extent, const F& f)
    {
        launch(run_group<F>, blocks_for(extent.capacity, lane_count), block_, stream_, extent, f);
    }
    template <class F>
    void once(const F& f)
    {
        launch(run_once<F>, 1, 1, stream_, f);
    }

    /// *out = the sum of map(i) by a fixed tree, see reduce_chunk().
    template <class Value, class Map>
    void reduce(Extent extent, const Map& map, Value* scratch, Value* out)
    {
        const unsigned blocks = blocks_for(chunks(extent.capacity), lane_count);
        launch(reduce_chunks<Value, Map>, blocks, block_, stream_, extent, map, scratch);
        launch(reduce_levels<Value>, 1, largest_block, stream_, extent, scratch, out);
    }

    /// out[i] = in[0] + ... + in[i - 1], and the total in out[n].
    void scan(Extent extent, const Index* in, Index* out)
    {
        std::size_t bytes = temporary_bytes_;
        check(scan_all(temporary_.get(), bytes, extent, in, out), "cub::DeviceScan::ExclusiveSum");
    }

    /// The stable order of ascending keys: sorted[s] = keys[order[s]]. Keys are below `end`.
    void sort(Index n, const Index* keys, Index* sorted, Index* order, Index end)
    {
        std::size_t bytes = temporary_bytes_;
        check(sort_all(temporary_.get(), bytes, n, keys, sorted, order, end),
              "cub::DeviceRadixSort::SortPairs");
    }

    /// start[k] = how many of n ascending keys are below k, for k = 0 ... end.
    void find_starts(Index n, const Index* sorted, Index* start, Index end)
    {
        for_each(end + 1, FindStart{sorted, n, start});
    }

    /// body() as long as *go is not 0: decided on the device in what is recorded, else by the host.
    template <class Body>
    void repeat_while(const Index* go, const Body& body)
    {
        if (recording_) {
            record_loop(go, body);
            return;
        }
        const auto goes_on = [this, go] {
            Index value = 0;
            download(&value, go, 1);
            return value != 0;
        };
        while (goes_on()) {
            body();
        }
    }

    /// Runs what body() asks for: the first time as it is, so that nothing is set up while it is recorded;
    /// then recorded as one graph, which later calls replay.
    template <class Body>
    void run_recorded(const Body& body)
    {
        if (!warm_) {
            body();
            warm_ = true;
            return;
        }
        if (!recorded_) {
            record(body);
        }
        check(cudaGraphLaunch(recorded_.get(), stream_), "cudaGraphLaunch");
    }
    void forget_recording()
    {
        recorded_.reset();
        graph_.reset();
    }

    /// Room for sorting n keys below `end`, and for sums of n integers.
    void reserve_sort(Index n, Index end)
    {
        std::size_t for_sort = 0;
        std::size_t for_scan = 0;
        check(sort_all(nullptr, for_sort, n, nullptr, nullptr, nullptr, end),
              "cub::DeviceRadixSort::SortPairs");
        check(scan_all(nullptr, for_scan, n, nullptr, nullptr), "cub::DeviceScan::ExclusiveSum");
        temporary_bytes_ = std::max(for_sort, for_scan);
        temporary_.reset(static_cast<char*>(allocate(temporary_bytes_)));
        places_.reset(static_cast<Index*>(allocate(sizeof(Index) * static_cast<std::size_t>(n))));
        for_each(n, CountUp{places_.get()});
    }

    /// Whether gradients are kept rather than computed in every pass. Each particle has about 40 places in
    /// its list, that is 480 bytes of gradients in float: up to this many particles they stay in the level 2
    /// cache (A100: 40 MB, H100: 50 MB), from there reading them costs more than computing them.
    static bool keeps_gradients(Index particles) { return particles <= 60'000; }

    /// Passes of a graph can't be told apart.
    static void mark(const char*) {}
    static std::vector<std::pair<std::string, double>> take_profile() { return {}; }

private:
    unsigned blocks_for(Index n, int threads_each) const
    {
        const auto threads = static_cast<std::int64_t>(n) * threads_each;
        return static_cast<unsigned>((threads + block_ - 1) / block_);
    }

    cudaError_t scan_all(void* temporary, std::size_t& bytes, Extent extent, const Index* in, Index* out)
    {
        const auto counted =
            thrust::make_transform_iterator(thrust::make_counting_iterator(Index{0}), Counted{extent, in});
        return cub::DeviceScan::ExclusiveSum(temporary, bytes, counted, out, extent.capacity + 1, stream_);
    }
    cudaError_t sort_all(void* temporary, std::size_t& bytes, Index n, const Index* keys, Index* sorted,
                         Index* order, Index end)
    {
        const auto bits = static_cast<int>(std::bit_width(static_cast<unsigned>(end - 1)));
        return cub::DeviceRadixSort::SortPairs(temporary, bytes, keys, sorted, places_.get(), order, n, 0,
                                               bits, stream_);
    }

    template <class Body>
    void record(const Body& body)
    {
        check(cudaStreamBeginCapture(stream_, cudaStreamCaptureModeRelaxed), "cudaStreamBeginCapture");
        recording_ = true;
        body();
        recording_ = false;
        cudaGraph_t graph = nullptr;
        check(cudaStreamEndCapture(stream_, &graph), "cudaStreamEndCapture");
        graph_.reset(graph);
        cudaGraphExec_t recorded = nullptr;
        check(cudaGraphInstantiate(&recorded, graph, 0), "cudaGraphInstantiate");
        recorded_.reset(recorded);
    }
    /// The loop is a node of the graph; its body is recorded from a stream of its own.
    template <class Body>
    void record_loop(const Index* go, const Body& body)
    {
        cudaGraphConditionalHandle condition{};
        check(cudaGraphConditionalHandleCreate(&condition, Capture(stream_).graph, 0, 0),
              "cudaGraphConditionalHandleCreate");
        launch(set_condition, 1, 1, stream_, condition, go);
        cudaGraph_t loop = add_while(stream_, condition);
        check(cudaStreamBeginCaptureToGraph(body_.get(), loop, nullptr, nullptr, 0,
                                            cudaStreamCaptureModeRelaxed),
              "cudaStreamBeginCaptureToGraph");
        stream_ = body_.get();
        body();
        launch(set_condition, 1, 1, stream_, condition, go);
        check(cudaStreamEndCapture(stream_, &loop), "cudaStreamEndCapture");
        stream_ = main_.get();
    }

    int block_;
    std::size_t bytes_ = 0;
    Owned<cudaStream_t> main_;
    Owned<cudaStream_t> body_; ///< only records
    cudaStream_t stream_ = nullptr;
    bool warm_ = false;
    bool recording_ = false;
    Owned<cudaGraph_t> graph_;
    Owned<cudaGraphExec_t> recorded_;
    Owned<char*> temporary_; ///< of sorting and scanning
    std::size_t temporary_bytes_ = 0;
    Owned<Index*> places_; ///< 0, 1, 2, ...
};

} // namespace aneurysm::device
