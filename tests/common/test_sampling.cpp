// SPDX-License-Identifier: Apache-2.0
// Section 3.4: particles on a lattice in the vessel, as many as asked for.
#include "common/vessel/sampling.hpp"
#include "tests/cells.hpp"

#include <map>
#include <optional>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

struct Sample {
    Scenario scenario;
    Vessel vessel;
    double R = 0;               ///< at frame 0 [m]
    double daughter_radius = 0; ///< [m]

    explicit Sample(const Scenario& s)
        : scenario(s), vessel(make_vessel(s)), R(s.aneurysm.initial_radius_radii * s.vessel.radius_m),
          daughter_radius(vessel.openings()[1].radius)
    {
    }
};

template <class Claim>
bool for_all_sacs(Claim claim)
{
    return std::ranges::all_of(
        sacs, [&](const SacWidths& sac) { return claim(Sample(with_sac(shipped_scenario("base"), sac))); });
}

/// Spacings beside the one found that the bisection can tell apart: 30 halvings of 3/7 of it.
constexpr double bisected = 0x1p-30;

template <class Candidate>
bool meets_the_count(Candidate sample_count)
{
    return for_all_sacs([&](const Sample& s) {
        bool good = true;
        std::vector<std::size_t> counts{1100, 1988, 1999, 2500, 5520};
        if (s.scenario.aneurysm.shape == table_2[0].shape) {
            counts.insert(counts.end(), {15'456, 40'296}); // Table 3
        }
        for (const std::size_t count : counts) {
            const double reserve = s.scenario.particles.reserve_fraction;
            const auto wanted = static_cast<std::size_t>(static_cast<double>(count) * (1 - reserve));
            const Lattice lattice = sample_count(s.vessel, s.R, count, reserve, s.daughter_radius);
            const auto beside = [&](double way) {
                return sample_lattice(s.vessel, s.R, lattice.spacing * (1 + way)).size();
            };
            good = good && lattice.size() <= count && lattice.spacing <= 0.5 * s.daughter_radius &&
                   (lattice.size() >= wanted ? beside(bisected) < wanted : beside(-bisected) > count);
        }
        return good;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(every_particle_number_is_met_with_the_reserve_that_was_asked_for)
{
    BOOST_TEST(meets_the_count(sample_count));
    // 1 % more or fewer particles
    for (const double error : {0.01, -0.01}) {
        BOOST_TEST(!meets_the_count(
            [&](const Vessel& vessel, double R, std::size_t count, double reserve, double daughter_radius) {
                const auto wrong = static_cast<std::size_t>(static_cast<double>(count) * (1 + error));
                return sample_count(vessel, R, wrong, reserve, daughter_radius);
            }));
    }
}

BOOST_AUTO_TEST_CASE(too_few_particles_are_refused_with_the_least_number_that_is_enough)
{
    BOOST_TEST(for_all_sacs([](const Sample& s) {
        const std::size_t least = sample_lattice(s.vessel, s.R, 0.5 * s.daughter_radius).size();
        return std::ranges::all_of(std::array{0.0, 0.06, 0.5}, [&](double reserve) {
            const auto sample = [&](std::size_t count) {
                return sample_count(s.vessel, s.R, count, reserve, s.daughter_radius);
            };
            std::size_t needed = least;
            while (static_cast<std::size_t>(static_cast<double>(needed) * (1 - reserve)) < least) {
                ++needed;
            }
            const std::string text = message_of([&] { sample(needed - 1); });
            return text.starts_with("particles.count: " + std::to_string(needed - 1)) &&
                   contains(text, "at least " + std::to_string(needed)) && sample(needed).size() >= least;
        });
    }));
}

namespace
{

enum class Place { outside, unsure, artery, first_slab };

Place slab(std::size_t k)
{
    return static_cast<Place>(static_cast<std::size_t>(Place::first_slab) + k);
}

/// Where a particle at x belongs. Unsure: so near to a border that rounding decides.
Place place_of(const Vessel& vessel, double R, double dx, const Vec3& x)
{
    constexpr double inset = 0.08; // spacings, the seeding inset
    const double inside = -vessel.wall(x, R).value - inset * dx;
    const std::size_t k = vessel.nearest_tube(x);
    const double beyond = vessel.openings()[k].beyond(x);
    const double depth = opening_layers * dx;
    const auto rounds = [](double margin) { return std::abs(margin) <= 2 * distance_rounding; };
    if (rounds(inside) || rounds(beyond) || rounds(beyond - depth)) {
        return Place::unsure;
    }
    if (inside < 0 || beyond > depth) {
        return Place::outside;
    }
    return beyond < 0 ? Place::artery : slab(k);
}

/// The same point, in the middle of its layer of the inlet's buffer; nothing where it is on a layer's border.
std::optional<Vec3> in_phase(const Vessel& vessel, double dx, const Vec3& x)
{
    const Opening& inlet = vessel.openings()[0];
    const double layer = inlet.beyond(x) / dx;
    if (std::abs(layer - std::round(layer)) < 1e-9) {
        return {};
    }
    return x + (std::floor(layer) + 0.5 - layer) * dx * inlet.outward;
}

/// Each particle is on the cubic lattice, in its place, once, and no lattice point is forgotten; those of the inlet's
/// buffer may be shifted along its axis, within their layer.
template <class Candidate>
bool fills_vessel_and_slabs(Candidate sample)
{
    return for_all_sacs([&](const Sample& s) {
        const double dx = 0.11;
        const Lattice lattice = sample(s.vessel, s.R, dx);
        std::map<Cell, Place> found;
        bool good = lattice.spacing == dx;
        const auto add = [&](const std::vector<Vec3>& points, Place place) {
            for (const Vec3& x : points) {
                const auto cell = cell_of(s.vessel, dx, x);
                good = good && cell && found.emplace(*cell, place).second;
            }
        };
        add(lattice.fluid, Place::artery);
        for (const Vec3& x : lattice.openings[0]) {
            const std::optional<Vec3> middle = in_phase(s.vessel, dx, x);
            good = good && middle;
            add({middle.value_or(x)}, slab(0));
        }
        add(lattice.openings[1], slab(1));
        add(lattice.openings[2], slab(2));
        for_each_cell(dx, 5.5, [&](const Cell& cell) {
            const Place expected = place_of(s.vessel, s.R, dx, center_of(s.vessel, dx, cell));
            const auto it = found.find(cell);
            const Place actual = it == found.end() ? Place::outside : it->second;
            good = good && (expected == Place::unsure || expected == actual);
            found.erase(cell);
        });
        return good && found.empty();
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(lattice_is_cubic_and_fills_vessel_and_slabs)
{
    BOOST_TEST(fills_vessel_and_slabs(sample_lattice));
    const auto is_found = [](auto fault) {
        return !fills_vessel_and_slabs([fault](const Vessel& vessel, double R, double dx) {
            Lattice lattice = sample_lattice(vessel, R, dx);
            fault(lattice);
            return lattice;
        });
    };
    BOOST_TEST(is_found([](Lattice& lattice) { lattice.fluid.pop_back(); }));
    BOOST_TEST(is_found([](Lattice& lattice) { lattice.fluid[7].x += 1e-9 * lattice.spacing; }));
    BOOST_TEST(is_found([](Lattice& lattice) { std::swap(lattice.openings[1], lattice.openings[2]); }));
    BOOST_TEST(is_found([](Lattice& lattice) { lattice.openings[0][5].y += lattice.spacing; }));
    BOOST_TEST(is_found([](Lattice& lattice) { lattice.openings[0][5].x += 1e-9 * lattice.spacing; }));
}

namespace
{

/// Whether no two columns of the inlet's buffer that lie side by side cross its plane together: by the sequence they are
/// 0.2451 or 0.4302 spacings out of phase, along x and z.
template <class Candidate>
bool columns_are_out_of_phase(Candidate sample)
{
    return for_all_sacs([&](const Sample& s) {
        const double dx = 0.11;
        const std::vector<Vec3> buffer = sample(s.vessel, s.R, dx).openings[0];
        const auto phase = [&](const Vec3& x) { return s.vessel.openings()[0].beyond(x) / dx; };
        int pairs = 0;
        const bool good = std::ranges::all_of(buffer, [&](const Vec3& a) {
            return std::ranges::all_of(buffer, [&](const Vec3& b) {
                const Vec3 d = (a - b) / dx;
                const double apart = std::hypot(d.x, d.z);
                if (apart < 0.5 || apart > 1.2) {
                    return true;
                }
                ++pairs;
                const double turns = phase(a) - phase(b);
                return std::abs(turns - std::round(turns)) > 0.245;
            });
        });
        return good && pairs > 0;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(the_inlets_columns_cross_its_plane_one_after_the_other)
{
    BOOST_TEST(columns_are_out_of_phase(sample_lattice));
    BOOST_TEST(!columns_are_out_of_phase([](const Vessel& vessel, double R, double dx) {
        Lattice lattice = sample_lattice(vessel, R, dx);
        for (Vec3& x : lattice.openings[0]) {
            x = in_phase(vessel, dx, x).value_or(x);
        }
        return lattice;
    }));
}

BOOST_AUTO_TEST_CASE(sampling_gives_the_same_bits_twice)
{
    const Sample s(shipped_scenario("base"));
    const Lattice first = sample_count(s.vessel, s.R, 1999, 0.06, s.daughter_radius);
    const Lattice second = sample_count(s.vessel, s.R, 1999, 0.06, s.daughter_radius);
    const Lattice again = sample_lattice(s.vessel, s.R, first.spacing); // what a resumed run samples

    BOOST_TEST((first.fluid == second.fluid && first.openings == second.openings));
    BOOST_TEST((first.fluid == again.fluid && first.openings == again.openings));
}
