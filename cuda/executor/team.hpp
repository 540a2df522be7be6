// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstdint>

namespace aneurysm::device
{

/// Threads that share a loop's chunks, by oneTBB. Whoever is free takes the next chunk, so that on a busy
/// machine a thread that doesn't get to run is not waited for; that made OpenMP's loops with two threads
/// several times slower than one.
///
/// A class of our own, which spun between loops, took 3.82 ms for a frame of paper_tc1 in float with two
/// threads where oneTBB takes 3.40 ms, and 6.6 against 6.2 ms beside a busy process (means of three runs in
/// turn of `bench_frames data --benchmark_filter=frames/tc1/cpu/float/threads:2` on two cores).
class Team
{
public:
    /// \param threads with the caller's own, at least 1; more than the machine has cores are not started
    explicit Team(int threads) : arena_(threads) {}

    int threads() const { return arena_.max_concurrency(); }

    /// work(c) for each c in [0, chunks), by any thread. Returns when all are done.
    template <class Work>
    void run(std::int32_t chunks, const Work& work)
    {
        if (threads() == 1 || chunks < 2) {
            for (std::int32_t c = 0; c < chunks; ++c) {
                work(c);
            }
            return;
        }
        arena_.execute([&] { tbb::parallel_for(0, chunks, work, tbb::simple_partitioner{}); });
    }

private:
    tbb::task_arena arena_;
};

} // namespace aneurysm::device
