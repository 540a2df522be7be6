// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/machine.hpp"

#include "cuda/executor/lanes.hpp"
#include "cuda/executor/team.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace aneurysm::benchmarks
{
namespace
{

using device::Index;
using device::lane_count;

/// Shortest of some runs of f [s].
template <class F>
double best_of(int runs, const F& f)
{
    double best = 1e30;
    for (int r = 0; r < runs; ++r) {
        const auto start = std::chrono::steady_clock::now();
        f();
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
}

/// The 32 nearest of a cubic lattice in storage order, for each of its points: as neighbors lie in memory.
std::vector<Index> lattice_lists(Index particles)
{
    const auto edge = static_cast<Index>(std::cbrt(static_cast<double>(particles)));
    std::vector<Index> offsets;
    for (Index z = -1; z <= 1; ++z) {
        for (Index y = -1; y <= 1; ++y) {
            for (Index x = -1; x <= 1; ++x) {
                offsets.push_back((z * edge + y) * edge + x);
            }
        }
    }
    for (Index x = 2; offsets.size() < 32; ++x) {
        offsets.push_back(x);
    }
    std::vector<Index> lists;
    for (Index i = 0; i < particles; ++i) {
        for (const Index offset : offsets) {
            lists.push_back(std::clamp(i + offset, Index{0}, particles - 1));
        }
    }
    return lists;
}

} // namespace

double copy_bandwidth(int threads)
{
    constexpr std::int32_t chunks = 256;
    constexpr std::size_t chunk = 1U << 17U; // doubles: 1 MiB
    std::vector<double> from(chunks * chunk, 1.0);
    std::vector<double> to(chunks * chunk, 0.0);
    device::Team team(threads);
    const double seconds = best_of(7, [&] {
        team.run(chunks, [&](std::int32_t c) {
            std::copy_n(from.data() + static_cast<std::size_t>(c) * chunk, chunk,
                        to.data() + static_cast<std::size_t>(c) * chunk);
        });
    });
    return 2.0 * static_cast<double>(from.size() * sizeof(double)) / seconds;
}

double bare_pair_seconds(int threads, std::int32_t particles)
{
    constexpr Index neighbors = 32;
    constexpr Index blocks = neighbors / lane_count;
    const std::vector<Index> lists = lattice_lists(particles);
    const auto n = static_cast<std::size_t>(particles);
    const std::vector<float> G(3 * n * neighbors, 0.5F);
    const std::vector<float> p(n, 1.0F);
    std::vector<Vec3T<float>> a(n);
    device::Team team(threads);
    const device::Lane lane{};
    const double seconds = best_of(20, [&] {
        team.run((particles + 127) / 128, [&](std::int32_t c) {
            for (Index i = 128 * c; i < std::min(particles, 128 * (c + 1)); ++i) {
                Vec3T<device::Lanes<float>> sum;
                for (Index b = blocks * i; b < blocks * (i + 1); ++b) {
                    const auto value = gather(p.data(), load(lists.data() + lane_count * b, lane));
                    const float* g = G.data() + 3 * lane_count * b;
                    sum += value * Vec3T<device::Lanes<float>>{load(g, lane), load(g + lane_count, lane),
                                                               load(g + 2 * lane_count, lane)};
                }
                a[static_cast<std::size_t>(i)] = device::sum(sum, lane);
            }
        });
    });
    return seconds / (static_cast<double>(n) * neighbors);
}

} // namespace aneurysm::benchmarks
