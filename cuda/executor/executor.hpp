// SPDX-License-Identifier: Apache-2.0
// What the two executors, cuda/executor_cpu.hpp and cuda/executor_gpu.hpp, have in common. Model code is
// written once, as function objects over plain pointers; an executor runs them for every index:
//
//     for_each(n, f)            f(i)
//     for_each_group(n, f)      f(i, lane): eight lanes share the work for i
//     once(f)                   f()
//     reduce(n, map, s, out)    a sum of fixed shape
//     scan(n, in, out)          exclusive prefix sums of integers
//     sort(n, keys, ...)        stable
//     find_starts(n, keys, ...) where each key begins in the sorted order
//     repeat_while(go, body)    decided on the device
//
// Everything that is asked for is done in that order.
#pragma once

#include "cuda/executor/lanes.hpp"

#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace aneurysm::device
{

/// How many indices to run over: a number that the device holds, with an upper bound that the host knows.
struct Extent {
    Index capacity = 0;
    const Index* actual = nullptr; ///< null: all

    Extent(Index n) : capacity(n) {}
    Extent(Index n, const Index* on_device) : capacity(n), actual(on_device) {}

    ANEURYSM_HD Index size() const { return actual != nullptr ? *actual : capacity; }
};

/// Fresh device memory is filled with this byte: every number in it is NaN, every index invalid.
inline constexpr int poison = 0xff;

/// Values that one group of lanes sums up.
inline constexpr Index chunk = 256;

ANEURYSM_HD constexpr Index chunks(Index n)
{
    return (n + chunk - 1) / chunk;
}

/// What lane `l` adds up of chunk c: every eighth value, in order.
template <class Value, class Map>
ANEURYSM_HD Value reduce_lane(const Map& map, Index c, Index n, Index l)
{
    Value value{};
    const Index end = (c + 1) * chunk < n ? (c + 1) * chunk : n;
    for (Index i = c * chunk + l; i < end; i += lane_count) {
        value += map(i);
    }
    return value;
}

/// The lanes' sums, added up as ((0+4)+(2+6))+((1+5)+(3+7)).
template <class Value>
ANEURYSM_HD Value join_lanes(Value* lanes)
{
    for (Index l = 0; l < lane_count / 2; ++l) {
        lanes[l] += lanes[l + 4];
    }
    lanes[0] += lanes[2];
    lanes[1] += lanes[3];
    lanes[0] += lanes[1];
    return lanes[0];
}

/// The sum of chunk c of the n values map(i): by lanes, which are then joined. Sums of more values are sums
/// of their chunks' sums, in the same way. `Value{}` is the neutral element of its +=.
template <class Value, class Map>
Value reduce_chunk(const Map& map, Index c, Index n)
{
    Value lanes[lane_count] = {};
    const Index end = (c + 1) * chunk < n ? (c + 1) * chunk : n;
    Index i = c * chunk;
    for (; i + lane_count <= end; i += lane_count) {
        for (Index l = 0; l < lane_count; ++l) {
            lanes[l] += map(i + l);
        }
    }
    for (Index l = 0; i + l < end; ++l) {
        lanes[l] += map(i + l);
    }
    return join_lanes(lanes);
}

/// An array in device memory.
template <class T, class Executor>
class Buffer
{
public:
    Buffer() = default;
    Buffer(Executor& executor, Index size)
        : executor_(&executor), size_(size),
          data_(static_cast<T*>(executor.allocate(sizeof(T) * static_cast<std::size_t>(size > 0 ? size : 1))))
    {
    }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Buffer()
    {
        if (data_ != nullptr) {
            executor_->release(data_, bytes());
        }
    }

    T* get() { return data_; }
    const T* get() const { return data_; }
    Index size() const { return size_; }
    std::size_t bytes() const { return sizeof(T) * static_cast<std::size_t>(size_); }

private:
    void swap(Buffer& other)
    {
        std::swap(executor_, other.executor_);
        std::swap(size_, other.size_);
        std::swap(data_, other.data_);
    }

    Executor* executor_ = nullptr;
    Index size_ = 0;
    T* data_ = nullptr;
};

/// Arrays in device memory, which live as long as this.
template <class Executor>
class Memory
{
public:
    explicit Memory(Executor& executor) : executor_(&executor) {}
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory()
    {
        for (const auto& [data, bytes] : arrays_) {
            executor_->release(data, bytes);
        }
    }

    /// Makes `array` point to new memory; what it pointed to is given back. \return where to write to it
    template <class T>
    std::remove_const_t<T>* make(T*& array, Index size)
    {
        using Value = std::remove_const_t<T>;
        auto* old = const_cast<Value*>(array); // NOLINT: it was made here
        if (const auto found = arrays_.find(old); found != arrays_.end()) {
            executor_->release(found->first, found->second);
            arrays_.erase(found);
        }
        const std::size_t bytes = sizeof(T) * static_cast<std::size_t>(size > 0 ? size : 1);
        auto* made = static_cast<Value*>(executor_->allocate(bytes));
        arrays_.emplace(made, bytes);
        array = made;
        return made;
    }
    /// The same, and writes `values` to it.
    template <class T>
    void make(T*& array, const std::vector<std::remove_const_t<T>>& values)
    {
        executor_->upload(make(array, static_cast<Index>(values.size())), values.data(), values.size());
    }

private:
    Executor* executor_;
    std::map<void*, std::size_t> arrays_; ///< bytes of each
};

} // namespace aneurysm::device
