// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (1), (2), (4)-(7) and (15), on a lattice of equal particles, where each sum multiplies a wave
// by its symbol, and for a random cloud, against sums over all pairs.
#include "analytic/kernel_function.hpp"
#include "tests/periodic.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using Eigen::Vector3d;
using reference::Neighbor;
using Neighborhood = std::span<const Neighbor>;

namespace
{

constexpr double fault = 1e-12;
constexpr double mu = 3.7;
const Vector3d v_1(0.3, -0.7, 0.5);

// the reference's sums, as callables
constexpr auto density = [](const auto&... x) { return reference::density(x...); };
constexpr auto density_rate = [](const auto&... x) { return reference::density_rate(x...); };
constexpr auto pressure_force = [](const auto&... x) { return reference::pressure_force(x...); };
constexpr auto viscosity_force = [](const auto&... x) { return reference::viscosity_force(x...); };
constexpr auto interpolate = [](const auto&... x) { return reference::interpolate(x...); };

/// A planted fault: the sum without one of the neighbors.
template <class Function>
auto without_a_neighbor(Function function)
{
    return [=](const reference::Bodies& b, Neighborhood neighbors, const auto&... rest) {
        return function(b, neighbors.subspan(1), rest...);
    };
}

/// Calls holds(lattice) for both kernels and two supports.
template <class Claim>
bool for_all_lattices(Claim holds)
{
    for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        for (const double ratio : {1.0, 1.3}) {
            if (!holds(PeriodicLattice({8, 8, 8}, name, ratio))) {
                return false;
            }
        }
    }
    return true;
}

/// holds(lattice, mode, cosine, sine) for each mode of those boxes.
template <class Claim>
bool for_all_waves(Claim holds)
{
    return for_all_lattices([&](const PeriodicLattice& flow) {
        return std::ranges::all_of(modes(8),
                                   [&](const Mode& n) { return holds(flow, n, flow.wave(n), flow.sine(n)); });
    });
}

template <class Claim>
bool for_both_clouds(Claim holds)
{
    return holds(RandomCloud(KernelName::cubic_spline)) && holds(RandomCloud(KernelName::wendland_c2));
}

} // namespace

// The tolerance of a wave is the oracle's rounding bound at the crest, once for the oracle and twice for the
// reference, whose terms are differences or sums of two values of the wave.

BOOST_AUTO_TEST_CASE(eq02_rate_of_a_wave_is_its_symbol)
{
    const auto holds = [](auto rate) {
        return for_all_waves([&](const PeriodicLattice& flow, const Mode& n, const auto& c, const auto& s) {
            const auto v = times(c, v_1);
            const auto crest = analytic::density_rate(flow.medium, {flow.wave_vector(n), v_1}, 1);
            for (std::size_t i = 0; i < v.size(); ++i) {
                const double found = rate(flow.bodies, flow.neighbors.of(i), std::span<const Vec3>(v), i);
                if (std::abs(found - crest.value * s[i]) > 3 * crest.error) {
                    return false;
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(density_rate));
    BOOST_TEST(!holds(off_by(fault, density_rate)));
    BOOST_TEST(!holds(off_by(-2, density_rate)));
    BOOST_TEST(!holds(without_a_neighbor(density_rate)));
}

BOOST_AUTO_TEST_CASE(eq02_is_the_time_derivative_of_eq05)
{
    const auto holds = [](auto rate) {
        const RandomCloud random(KernelName::wendland_c2);
        const auto& cloud = random.cloud;
        return random.for_all([&](std::size_t i) {
            if (i % 16 != 0) {
                return true;
            }
            const auto later = [&](double t) { return analytic::pair_density_later(cloud, i, t); };
            const auto slope = analytic::differentiate(later, 1e-3 * cloud.h);
            const auto sum = analytic::pair_density_rate(cloud, i);
            const double found =
                rate(random.bodies, random.neighbors.of(i), std::span<const Vec3>(random.bodies.velocity), i);
            // GSL estimates the truncation and rounding of its difference
            return within(found, slope.value, slope.error + sum.error);
        });
    };
    BOOST_TEST(holds(density_rate));
    BOOST_TEST(!holds(off_by(1e-5, density_rate)));
    BOOST_TEST(!holds(off_by(-2, density_rate)));
}

BOOST_AUTO_TEST_CASE(eq02_sums_over_all_pairs_of_a_cloud)
{
    const auto holds = [](auto rate) {
        return for_both_clouds([&](const RandomCloud& random) {
            return random.for_all([&](std::size_t i) {
                const double found = rate(random.bodies, random.neighbors.of(i),
                                          std::span<const Vec3>(random.bodies.velocity), i);
                return near(found, analytic::pair_density_rate(random.cloud, i), 1);
            });
        });
    };
    BOOST_TEST(holds(density_rate));
    BOOST_TEST(!holds(off_by(fault, density_rate)));
    BOOST_TEST(!holds(without_a_neighbor(density_rate)));
}

BOOST_AUTO_TEST_CASE(eq04_interpolates_a_wave_at_any_point)
{
    const auto holds = [](auto sum) {
        return for_all_lattices([&](const PeriodicLattice& flow) {
            // the box without its images: the point and its support are inside
            const Vec3 middle{4 * PeriodicLattice::dx, 4 * PeriodicLattice::dx, 4 * PeriodicLattice::dx};
            for (const Mode& n : {Mode{0, 0, 0}, Mode{1, 0, 0}, Mode{2, -1, 3}, Mode{4, 4, 4}}) {
                std::vector<double> A = flow.wave(n, -(n[0] + n[1] + n[2]) / 2.0); // phase 0 in the middle
                for (const Vector3d& offset :
                     {Vector3d(0, 0, 0), Vector3d(0.3, -0.2, 0.45), Vector3d(0.5, 0.5, 0)}) {
                    const Vector3d r = PeriodicLattice::dx * offset;
                    const auto expected = analytic::interpolated_wave(flow.medium, flow.wave_vector(n), r);
                    const double found = sum(flow.bodies, std::span<const double>(flow.density),
                                             std::span<const double>(A), flow.kernel, middle + to_vec3(r));
                    // 8 u of the box's edge through the difference of positions,
                    // on the slope's sum, < 8/h of W's
                    const double shift = rounding(8 * 8) * 8;
                    if (std::abs(found - expected.value) > 2 * expected.error + shift) {
                        return false;
                    }
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(interpolate));
    BOOST_TEST(!holds(off_by(fault, interpolate)));
    BOOST_TEST(!holds([](reference::Bodies b, const auto&... rest) { // one body overlooked
        b.role[4 * 64 + 4 * 8 + 4] = reference::Role::absent;
        return reference::interpolate(b, rest...);
    }));
}

BOOST_AUTO_TEST_CASE(eq04_sums_over_all_bodies_of_a_cloud)
{
    const auto holds = [](auto sum) {
        return for_both_clouds([&](const RandomCloud& random) {
            const auto& c = random.cloud;
            for (int k = 0; k < 40; ++k) {
                const Vector3d r = c.period * Vector3d(0.1 + 0.02 * k, 0.9 - 0.017 * k, 0.5 + 0.01 * k);
                const double found = sum(random.bodies, std::span<const double>(c.density),
                                         std::span<const double>(c.pressure), random.kernel, to_vec3(r));
                if (!near(found, analytic::pair_interpolation(c, r), 1)) {
                    return false;
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(interpolate));
    BOOST_TEST(!holds(off_by(fault, interpolate)));
}

BOOST_AUTO_TEST_CASE(eq05_density_of_the_lattice_is_the_rest_density)
{
    const auto holds = [](auto sum) {
        return for_all_lattices([&](const PeriodicLattice& flow) {
            const auto expected = analytic::density(flow.medium);
            for (std::size_t i = 0; i < flow.bodies.size(); ++i) {
                if (!near(sum(flow.bodies, flow.neighbors.of(i)), expected, 1)) {
                    return false;
                }
            }
            // m was made for rho: its own rounding, a division
            return within(expected.value, PeriodicLattice::rho,
                          expected.error + rounding(1) * PeriodicLattice::rho);
        });
    };
    BOOST_TEST(holds(density));
    BOOST_TEST(!holds(off_by(fault, density)));
    BOOST_TEST(!holds(without_a_neighbor(density)));
}

BOOST_AUTO_TEST_CASE(eq05_sums_over_all_pairs_of_a_cloud)
{
    const auto holds = [](auto sum) {
        return for_both_clouds([&](const RandomCloud& random) {
            return random.for_all([&](std::size_t i) {
                return near(sum(random.bodies, random.neighbors.of(i)),
                            analytic::pair_density(random.cloud, i), 1);
            });
        });
    };
    BOOST_TEST(holds(density));
    BOOST_TEST(!holds(off_by(fault, density)));
    BOOST_TEST(!holds(without_a_neighbor(density)));
}

BOOST_AUTO_TEST_CASE(eq06_force_of_a_wave_is_its_symbol)
{
    const auto holds = [](auto force) {
        return for_all_waves([&](const PeriodicLattice& flow, const Mode& n, const auto& c, const auto& s) {
            const auto crest = analytic::pressure_force(flow.medium, {flow.wave_vector(n), {}, 1}, 1);
            for (std::size_t i = 0; i < c.size(); ++i) {
                const Vec3 found =
                    force(flow.bodies, flow.neighbors.of(i), std::span<const double>(flow.density),
                          std::span<const double>(c), i);
                if (distance(found, s[i] * to_vec3(crest.value)) > 3 * crest.error) {
                    return false;
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(pressure_force));
    BOOST_TEST(!holds(off_by(fault, pressure_force)));
    BOOST_TEST(!holds(off_by(-2, pressure_force))); // the sign lost in print
    BOOST_TEST(!holds(off_by(1, pressure_force)));  // the full gradient
    BOOST_TEST(!holds(without_a_neighbor(pressure_force)));
}

BOOST_AUTO_TEST_CASE(eq06_is_half_of_the_gradient)
{
    // p = x inside the box: the force over -grad p is the oracle's number,
    // and the nearer to 1/2 the wider the support
    const auto holds = [](auto force) {
        for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
            double off_half = 0.5;
            for (const double ratio : {1.0, 1.3, 2.0}) {
                const PeriodicLattice flow({12, 12, 12}, name, ratio);
                std::vector<double> p;
                for (const Vec3& r : flow.bodies.position) {
                    p.push_back(r.x - 6 * PeriodicLattice::dx);
                }
                const std::size_t middle = 6 * 144 + 6 * 12 + 6;
                const Vec3 F =
                    force(flow.bodies, flow.neighbors.of(middle), std::span<const double>(flow.density),
                          std::span<const double>(p), middle);
                const auto half = analytic::pressure_force_ratio(flow.medium);
                if (!within(-F.x, half.value, 2 * half.error) || std::abs(half.value - 0.5) > off_half) {
                    return false;
                }
                off_half = std::abs(half.value - 0.5);
            }
        }
        return true;
    };
    BOOST_TEST(holds(pressure_force));
    BOOST_TEST(!holds(off_by(fault, pressure_force)));
    BOOST_TEST(!holds(off_by(1, pressure_force))); // -grad p itself, which the formula misses
}

BOOST_AUTO_TEST_CASE(eq06_sums_over_all_pairs_of_a_cloud)
{
    const auto holds = [](auto force) {
        return for_both_clouds([&](const RandomCloud& random) {
            const auto& c = random.cloud;
            return random.for_all([&](std::size_t i) {
                const Vec3 found =
                    force(random.bodies, random.neighbors.of(i), std::span<const double>(c.density),
                          std::span<const double>(c.pressure), i);
                return near(found, analytic::pair_pressure_force(c, i), 1);
            });
        });
    };
    BOOST_TEST(holds(pressure_force));
    BOOST_TEST(!holds(off_by(fault, pressure_force)));
    BOOST_TEST(!holds(without_a_neighbor(pressure_force)));
    BOOST_TEST(!holds([](reference::Bodies b, const auto&... rest) { // ghosts with a pressure of their own
        std::ranges::fill(b.role, reference::Role::free);
        return reference::pressure_force(b, rest...);
    }));
}

BOOST_AUTO_TEST_CASE(eq07_force_of_a_wave_is_its_symbol)
{
    const auto holds = [](auto force) {
        return for_all_waves([&](PeriodicLattice flow, const Mode& n, const auto& c, const auto&) {
            flow.bodies.velocity = times(c, v_1);
            const auto crest = analytic::viscosity_force(flow.medium, mu, {flow.wave_vector(n), v_1}, 1);
            for (std::size_t i = 0; i < c.size(); ++i) {
                const Vec3 found =
                    force(flow.bodies, flow.neighbors.of(i), std::span<const double>(flow.density), mu, i);
                if (distance(found, c[i] * to_vec3(crest.value)) > 3 * crest.error) {
                    return false;
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(viscosity_force));
    BOOST_TEST(!holds(off_by(fault, viscosity_force)));
    BOOST_TEST(!holds(off_by(-2, viscosity_force))); // as printed: v_i - v_j
    BOOST_TEST(!holds(without_a_neighbor(viscosity_force)));
}

BOOST_AUTO_TEST_CASE(eq07_sums_over_all_pairs_of_a_cloud)
{
    const auto holds = [](auto force) {
        return for_both_clouds([&](const RandomCloud& random) {
            return random.for_all([&](std::size_t i) {
                const Vec3 found = force(random.bodies, random.neighbors.of(i),
                                         std::span<const double>(random.cloud.density), mu, i);
                return near(found, analytic::pair_viscosity_force(random.cloud, mu, i), 1);
            });
        });
    };
    BOOST_TEST(holds(viscosity_force));
    BOOST_TEST(!holds(off_by(fault, viscosity_force)));
    BOOST_TEST(!holds(without_a_neighbor(viscosity_force)));
}

BOOST_AUTO_TEST_CASE(eq07_only_takes_energy_away)
{
    // equal particles: sum v_i.F_i = -mu V sum_{pairs} |v_i - v_j|^2 lap W, each pair not positive
    const auto holds = [](auto force) {
        RandomCloud random(KernelName::cubic_spline);
        const std::vector<double> rho(random.bodies.size(), 1050);
        std::ranges::fill(random.bodies.mass, 1.0);
        double power = 0;
        random.for_all([&](std::size_t i) {
            power += dot(random.bodies.velocity[i],
                         force(random.bodies, random.neighbors.of(i), std::span<const double>(rho), mu, i));
            return true;
        });
        return power < 0;
    };
    BOOST_TEST(holds(viscosity_force));
    BOOST_TEST(!holds(off_by(-2, viscosity_force))); // as printed
}
