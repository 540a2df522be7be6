// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace aneurysm
{

/// `jobs`, or as many as there are cores for 0.
int thread_count(int jobs);

/// Calls work(k) for each k below `count`, on several threads that take one after the other. The first
/// exception keeps them from taking more, and is thrown here.
/// \param watch  called by the caller's own thread meanwhile, five times a second and at the end
void in_parallel(
    std::size_t count, int threads, const std::function<void(std::size_t)>& work,
    const std::function<void()>& watch = [] {});

} // namespace aneurysm
