// SPDX-License-Identifier: Apache-2.0
// Particles in periodic boxes for the sums of section 3.1:
// a cubic lattice with plane waves, and a random cloud.
#pragma once

#include "analytic/blood_flow.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "reference/blood_flow.hpp"
#include "tests/support.hpp"

#include <array>
#include <numbers>
#include <random>
#include <vector>

namespace aneurysm::test
{

inline Vec3 to_vec3(const Eigen::Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Periods of a wave along each edge of the box.
using Mode = std::array<int, 3>;

/// A periodic box of equal particles on a cubic lattice. The spacing is a power of two, so that positions and
/// their differences are exact.
struct PeriodicLattice {
    static constexpr double dx = 1.0 / 64;
    static constexpr double rho = 1050;

    std::array<int, 3> edge; ///< in spacings
    analytic::Medium medium;
    reference::Kernel kernel;
    reference::Bodies bodies;
    reference::Neighbors neighbors;
    std::vector<double> density; ///< rho for each body

    PeriodicLattice(std::array<int, 3> edges, KernelName name, double ratio)
        : edge(edges), medium(at_rest(name, ratio)), kernel(name, ratio * dx),
          bodies(make_bodies(edges, medium.mass)),
          neighbors(bodies, kernel, {edges[0] * dx, edges[1] * dx, edges[2] * dx}),
          density(bodies.size(), rho)
    {
    }

    static analytic::Medium at_rest(KernelName name, double ratio)
    {
        const analytic::Lattice lattice{name, ratio * dx, dx};
        return {lattice, rho / analytic::kernel_sum(lattice).value, rho};
    }

    static reference::Bodies make_bodies(const std::array<int, 3>& edge, double mass)
    {
        reference::Bodies b;
        for (int i = 0; i < edge[0]; ++i) {
            for (int j = 0; j < edge[1]; ++j) {
                for (int k = 0; k < edge[2]; ++k) {
                    b.position.push_back({i * dx, j * dx, k * dx});
                }
            }
        }
        b.velocity.resize(b.size());
        b.mass.assign(b.size(), mass);
        b.role.assign(b.size(), reference::Role::free);
        return b;
    }

    Eigen::Vector3d wave_vector(const Mode& n) const
    {
        return 2 * std::numbers::pi / dx *
               Eigen::Vector3d(double(n[0]) / edge[0], double(n[1]) / edge[1], double(n[2]) / edge[2]);
    }

    /// cos(k.r) or, a quarter of a turn earlier, sin(k.r) at each body;
    /// the phase is reduced before it is rounded.
    std::vector<double> wave(const Mode& n, double turns = 0) const
    {
        std::vector<double> values;
        for (const Vec3& r : bodies.position) {
            const long double phase = std::fmod(turns + n[0] * (r.x / dx) / edge[0], 1.0L) +
                                      std::fmod(n[1] * (r.y / dx) / static_cast<long double>(edge[1]), 1.0L) +
                                      std::fmod(n[2] * (r.z / dx) / static_cast<long double>(edge[2]), 1.0L);
            values.push_back(static_cast<double>(std::cos(2 * std::numbers::pi_v<long double> * phase)));
        }
        return values;
    }
    std::vector<double> sine(const Mode& n) const { return wave(n, -0.25); }
};

/// 0 <= n_z <= n_y <= n_x <= N/2 without 0: the lattice's symmetry gives the rest.
inline std::vector<Mode> modes(int N)
{
    std::vector<Mode> all;
    for (int i = 1; i <= N / 2; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int k = 0; k <= j; ++k) {
                all.push_back({i, j, k});
            }
        }
    }
    return all;
}

inline std::vector<Vec3> times(const std::vector<double>& values, const Eigen::Vector3d& v)
{
    std::vector<Vec3> result(values.size());
    std::ranges::transform(values, result.begin(), [&](double value) { return value * to_vec3(v); });
    return result;
}

/// A jittered lattice of unequal particles with random velocities, pressures and densities, every seventh a
/// ghost; the same for the oracle and for the reference.
struct RandomCloud {
    analytic::Cloud cloud;
    reference::Kernel kernel;
    reference::Bodies bodies;
    reference::Neighbors neighbors;

    explicit RandomCloud(KernelName name, double jitter = 0.4)
        : cloud(make_cloud(name, jitter)), kernel(name, cloud.h), bodies(make_bodies(cloud)),
          neighbors(bodies, kernel, {cloud.period, cloud.period, cloud.period})
    {
    }

    static analytic::Cloud make_cloud(KernelName name, double jitter)
    {
        constexpr int N = 8;
        constexpr double dx = 0.013;
        std::mt19937_64 bits(2439);
        const auto random = [&] { return 2 * std::ldexp(static_cast<double>(bits() >> 11), -53) - 1; };
        const auto random_vector = [&] {
            return Eigen::Vector3d{random(), random(), random()};
        }; // braces: in order
        analytic::Cloud c{name, 1.1 * dx, N * dx, {}, {}, {}, {}, {}, {}};
        for (int n = 0; n < N * N * N; ++n) {
            const std::array<int, 3> cell{n % N, n / N % N, n / (N * N)};
            c.position.emplace_back(dx *
                                    (Eigen::Vector3d(cell[0], cell[1], cell[2]) + jitter * random_vector()));
            c.velocity.emplace_back(random_vector());
            c.mass.push_back(1050 * dx * dx * dx * (1 + 0.1 * random()));
            c.density.push_back(1050 * (1 + 0.05 * random()));
            c.pressure.push_back(500 * (1 + random()));
            c.free.push_back(n % 7 != 3);
        }
        return c;
    }

    static reference::Bodies make_bodies(const analytic::Cloud& c)
    {
        reference::Bodies b;
        for (std::size_t i = 0; i < c.position.size(); ++i) {
            b.position.push_back(to_vec3(c.position[i]));
            b.velocity.push_back(to_vec3(c.velocity[i]));
            b.mass.push_back(c.mass[i]);
            b.role.push_back(c.free[i] ? reference::Role::free : reference::Role::mirror);
        }
        return b;
    }

    /// Whether claim(i) holds for each free body.
    template <class Claim>
    bool for_all(Claim claim) const
    {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies.free(i) && !claim(i)) {
                return false;
            }
        }
        return true;
    }
};

/// Components within the oracle's bound and the candidate's, `times` the oracle's.
inline bool near(const Vec3& value, const analytic::VectorEstimate& expected, double times)
{
    return distance(value, to_vec3(expected.value)) <= (1 + times) * expected.error;
}
inline bool near(double value, const analytic::Estimate& expected, double times)
{
    return std::abs(value - expected.value) <= (1 + times) * expected.error;
}

} // namespace aneurysm::test
