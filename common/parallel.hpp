// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace aneurysm
{

/// Threads that pay for this process, at least 1: the least of the processors that it may run on, the quota of its
/// control groups (a container's, in whole processors, rounded up), SLURM_CPUS_PER_TASK and OMP_NUM_THREADS.
int paying_threads();

/// `jobs`, or paying_threads() for 0.
int thread_count(int jobs);

/// How many of the wanted threads can work at once: no more than there are processors, nor than the system lets start;
/// the caller's own included, at least 1. Tried out by starting them.
int startable_threads(int wanted);

/// Calls work(k) for each k below `count`, on several threads that take one after the other; where the system gives
/// fewer threads than wanted, on those. The first exception keeps them from taking more, and is thrown here.
/// \param watch  called by the caller's own thread meanwhile, five times a second and at the end
/// \throws std::system_error when not one thread can be started
void in_parallel(
    std::size_t count, int threads, const std::function<void(std::size_t)>& work,
    const std::function<void()>& watch = [] {});

} // namespace aneurysm
