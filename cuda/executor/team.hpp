// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace aneurysm::device
{

/// Threads that share a loop's chunks. Whoever is free takes the next chunk, and the loop is over when all
/// chunks are done, not when all threads have come: on a busy machine a thread that doesn't get to run is not
/// waited for, which is what makes OpenMP's loops several times slower than one thread there. Workers spin
/// for a moment when they have nothing to do, then sleep.
class Team
{
public:
    /// \param threads with the caller's own, at least 1
    explicit Team(int threads);
    ~Team();
    Team(const Team&) = delete;
    Team(Team&&) = delete;
    Team& operator=(const Team&) = delete;
    Team& operator=(Team&&) = delete;

    int threads() const { return static_cast<int>(workers_.size()) + 1; }

    /// work(c) for each c in [0, chunks), by any thread. Returns when all are done.
    template <class Work>
    void run(std::int32_t chunks, const Work& work)
    {
        if (workers_.empty() || chunks < 2) {
            for (std::int32_t c = 0; c < chunks; ++c) {
                work(c);
            }
            return;
        }
        share(chunks, &work, [](const void* w, std::int32_t c) { (*static_cast<const Work*>(w))(c); });
    }

private:
    using Call = void (*)(const void*, std::int32_t);

    void share(std::int32_t chunks, const void* work, Call call);
    bool do_one(std::uint32_t generation);
    void serve();

    std::vector<std::thread> workers_;
    // The loop at hand. The ticket holds its generation and the next chunk in one word, so that a thread
    // which comes too late can't take a chunk of the next loop for one of this.
    std::atomic<std::uint64_t> ticket_{0};
    std::atomic<std::int32_t> chunks_{0};
    std::atomic<const void*> work_{nullptr};
    std::atomic<Call> call_{nullptr};
    alignas(64) std::atomic<std::int32_t> done_{0};
    alignas(64) std::atomic<std::uint32_t> generation_{0};
    std::atomic<bool> ending_{false};
};

} // namespace aneurysm::device
