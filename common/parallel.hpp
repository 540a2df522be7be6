// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <thread>

namespace aneurysm
{

/// `jobs`, or as many as there are cores for 0.
inline int thread_count(int jobs)
{
    return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

} // namespace aneurysm
