// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "common/parallel.hpp"
#include "cuda/executor/executor.hpp"
#include "cuda/executor/team.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace aneurysm::device
{

/// Runs device code on the host's cores. The number of threads doesn't change a bit of any result: nothing is
/// shared between two calls of a function, and sums have their own fixed shape.
class CpuExecutor
{
public:
    static constexpr Backend backend = Backend::cpu;

    /// `threads` 0: as many as pay. Fewer where the system gives fewer.
    explicit CpuExecutor(int threads)
        : team_(std::make_unique<Team>(startable_threads(thread_count(threads))))
    {
    }

    std::string device() const
    {
        return std::to_string(team_->threads()) + (team_->threads() == 1 ? " CPU thread" : " CPU threads");
    }
    std::size_t bytes() const { return bytes_; } ///< allocated

    void* allocate(std::size_t bytes)
    {
        void* memory = ::operator new(bytes, alignment);
        std::memset(memory, poison, bytes);
        bytes_ += bytes;
        return memory;
    }
    void release(void* memory, std::size_t bytes)
    {
        ::operator delete(memory, alignment);
        bytes_ -= bytes;
    }
    template <class T>
    static void upload(T* device, const T* host, std::size_t count)
    {
        std::copy_n(host, count, device);
    }
    template <class T>
    static void download(T* host, const T* device, std::size_t count)
    {
        std::copy_n(device, count, host);
    }
    template <class T>
    static void copy(T* to, const T* from, Index count)
    {
        std::copy_n(from, count, to);
    }

    /// f(i) for each i.
    template <class F>
    void for_each(Extent extent, const F& f) const
    {
        share(extent.size(), elements_a_chunk, f);
    }
    /// f(i, lane) for each i and lane.
    template <class F>
    void for_each_group(Extent extent, const F& f) const
    {
        share(extent.size(), groups_a_chunk, [&f](Index i) { f(i, Lane{}); });
    }
    template <class F>
    void once(const F& f) const
    {
        f();
    }

    /// *out = the sum of map(i) by a fixed tree, see reduce_chunk().
    template <class Value, class Map>
    void reduce(Extent extent, const Map& map, Value* scratch, Value* out) const
    {
        const Index n = extent.size();
        Index parts = chunks(n);
        share(parts, chunks(elements_a_chunk), [&](Index c) { scratch[c] = reduce_chunk<Value>(map, c, n); });
        while (parts > 1) {
            const Index count = parts;
            parts = chunks(count);
            for (Index c = 0; c < parts; ++c) {
                scratch[count + c] = reduce_chunk<Value>([scratch](Index i) { return scratch[i]; }, c, count);
            }
            scratch += count;
        }
        *out = n > 0 ? scratch[0] : Value{};
    }

    /// out[i] = in[0] + ... + in[i - 1], and the total in out[n].
    static void scan(Extent extent, const Index* in, Index* out)
    {
        const Index n = extent.size();
        Index total = 0;
        for (Index i = 0; i < n; ++i) {
            const Index value = in[i];
            out[i] = total;
            total += value;
        }
        out[n] = total;
    }

    /// The stable order of ascending keys: sorted[s] = keys[order[s]]. Keys are below `end`.
    void sort(Index n, const Index* keys, Index* sorted, Index* order, Index end)
    {
        starts_.assign(static_cast<std::size_t>(end) + 1, 0);
        for (Index i = 0; i < n; ++i) {
            ++starts_[static_cast<std::size_t>(keys[i]) + 1];
        }
        for (std::size_t k = 1; k < starts_.size(); ++k) {
            starts_[k] += starts_[k - 1];
        }
        for (Index i = 0; i < n; ++i) {
            const Index place = starts_[static_cast<std::size_t>(keys[i])]++;
            sorted[place] = keys[i];
            order[place] = i;
        }
    }

    /// start[k] = how many of n ascending keys are below k, for k = 0 ... end.
    void find_starts(Index n, const Index* sorted, Index* start, Index end) const
    {
        for_each(n + 1, [=](Index s) {
            const Index from = s == 0 ? 0 : sorted[s - 1] + 1;
            const Index to = s == n ? end : sorted[s];
            for (Index k = from; k <= to; ++k) {
                start[k] = s;
            }
        });
    }

    /// body() as long as *go is not 0.
    template <class Body>
    static void repeat_while(const Index* go, const Body& body)
    {
        while (*go != 0) {
            body();
        }
    }

    /// Runs what body() asks for; a GPU records it once and replays it.
    template <class Body>
    static void run_recorded(const Body& body)
    {
        body();
    }
    static void forget_recording() {}

    /// Room for sorting n keys below `end`.
    void reserve_sort(Index, Index end) { starts_.resize(static_cast<std::size_t>(end) + 1); }

    /// Whether gradients are kept rather than computed in every pass: reading them is cheaper here. Keeping
    /// only their common factor, a third of the memory, was tried and is slower at 5,520 to 40,296 particles.
    static bool keeps_gradients(Index) { return true; }

    /// Ends the pass of this name; its time runs from the last mark.
    void mark(const char* name)
    {
        const auto now = std::chrono::steady_clock::now();
        seconds_[name] += std::chrono::duration<double>(now - marked_).count();
        marked_ = now;
    }
    std::vector<std::pair<std::string, double>> take_profile()
    {
        std::vector<std::pair<std::string, double>> profile(seconds_.begin(), seconds_.end());
        seconds_.clear();
        marked_ = std::chrono::steady_clock::now();
        return profile;
    }

private:
    static constexpr std::align_val_t alignment{64};
    // Big enough that taking a chunk costs nothing, small enough that nobody waits long for the last one.
    static constexpr Index elements_a_chunk = 1024; ///< at least
    static constexpr Index groups_a_chunk = 128;    ///< at least
    static constexpr Index chunks_a_thread = 16;    ///< of a loop, at most

    /// f(i) for each i below n, at least `least` of them in a chunk.
    template <class F>
    void share(Index n, Index least, const F& f) const
    {
        const Index size = std::max(least, n / (chunks_a_thread * team_->threads()));
        team_->run((n + size - 1) / size, [&](Index c) {
            const Index end = std::min(n, (c + 1) * size);
            for (Index i = c * size; i < end; ++i) {
                f(i);
            }
        });
    }

    std::unique_ptr<Team> team_;
    std::size_t bytes_ = 0;
    std::vector<Index> starts_; ///< of each key's places
    std::map<std::string, double, std::less<>> seconds_;
    std::chrono::steady_clock::time_point marked_ = std::chrono::steady_clock::now();
};

} // namespace aneurysm::device
