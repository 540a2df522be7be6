// SPDX-License-Identifier: Apache-2.0
// What the machine can do at best, measured in the same run as what we do with it.
#pragma once

#include <cstdint>

namespace aneurysm::benchmarks
{

/// Bytes read and written a second by copying 256 MiB with this many threads [B/s].
double copy_bandwidth(int threads);

/// Seconds for one pair of the barest pass over neighbors that there is, in float: eight at once, one
/// gather, a stored gradient, three multiplications and additions. Lists and neighbors as in a sorted
/// lattice of this many particles. [s, of all threads together]
double bare_pair_seconds(int threads, std::int32_t particles);

} // namespace aneurysm::benchmarks
