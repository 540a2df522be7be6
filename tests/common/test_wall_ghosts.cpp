// SPDX-License-Identifier: Apache-2.0
// Section 3.5: the wall's ghosts (27), which hold the part of their lattice cell that is outside the wall.
#include "common/vessel/sampling.hpp"
#include "tests/cells.hpp"

#include <map>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double dx = 0.13;
constexpr double support = 2 * dx;
constexpr double mass = 0.7;

/// The vessel, and its ghosts as the simulation makes them: for radii up to one spacing beyond the sac's own.
struct Walls {
    Vessel vessel;
    double smallest;
    double largest;
    GhostLattice ghosts;

    explicit Walls(const Scenario& s)
        : vessel(make_vessel(s)), smallest(0.5 * s.aneurysm.initial_radius_radii * s.vessel.radius_m),
          largest(vessel.largest_radius() + dx), ghosts(vessel, smallest, largest, dx, support, mass)
    {
    }
};

std::map<Cell, double> by_cell(const Vessel& vessel, const WallGhosts& ghosts)
{
    std::map<Cell, double> found;
    for (std::size_t i = 0; i < ghosts.size(); ++i) {
        const auto cell = cell_of(vessel, dx, ghosts.position[i]);
        found[cell.value_or(Cell{})] += cell ? ghosts.mass[i] : std::nan(""); // off the lattice
    }
    return found;
}

/// The mass of a ghost at x, or none. Where rounding decides, the ghost's mass is 0 or it is out of the
/// blood's sight, and `found` is right.
double expected_mass(const Vessel& vessel, double R, const std::optional<Breach>& breach, const Vec3& x,
                     double found)
{
    const double d = vessel.wall(x, R).value;
    const double beyond = vessel.openings()[vessel.nearest_tube(x)].beyond(x);
    const double end = beyond - (opening_layers * dx + support);
    const auto rounds = [](double margin) { return std::abs(margin) <= 2 * distance_rounding; };
    if (rounds(d - support) || rounds(end)) {
        return found;
    }
    if (d > support || end > 0 || (breach && breach->contains(x))) {
        return 0;
    }
    return mass * std::clamp(0.5 + d / dx, 0.0, 1.0);
}

template <class Candidate>
bool ghosts_are_those_of_all_cells(Candidate at)
{
    return std::ranges::all_of(sacs, [&](const SacWidths& sac) {
        const Walls walls(with_sac(shipped_scenario("quick"), sac));
        return std::ranges::all_of(std::array{0.0, 0.3, 0.7, 1.0}, [&](double part) {
            const double R = walls.smallest + part * (walls.largest - walls.smallest);
            std::optional<Breach> breach;
            if (part == 0.7 && walls.vessel.has_sac()) {
                breach = Breach{walls.vessel.dome(R), 0.2};
            }
            auto found = by_cell(walls.vessel, at(walls, R, breach));
            bool good = true;
            for_each_cell(dx, 3.5, [&](const Cell& cell) {
                const auto it = found.find(cell);
                const double m = it == found.end() ? 0 : it->second;
                const double expected =
                    expected_mass(walls.vessel, R, breach, center_of(walls.vessel, dx, cell), m);
                good = good && std::abs(m - expected) <= 2 * distance_rounding / dx * mass;
                found.erase(cell);
            });
            return good && found.empty();
        });
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(ghosts_are_the_outer_parts_of_all_cells_near_the_wall_at_every_radius)
{
    const auto at = [](const Walls& walls, double R, const std::optional<Breach>& breach) {
        return walls.ghosts.at(R, breach);
    };
    BOOST_TEST(ghosts_are_those_of_all_cells(at));
    BOOST_TEST(!ghosts_are_those_of_all_cells(
        [&](const Walls& walls, double R, const std::optional<Breach>& breach) {
            return at(walls, R * (1 + 1e-9), breach);
        }));
    BOOST_TEST(!ghosts_are_those_of_all_cells([&](const Walls& walls, double R, const auto&) { // no breach
        return at(walls, R, std::nullopt);
    }));
    const auto made_for = [](double smaller, double larger) {
        return [=](const Walls& walls, double R, const auto& breach) {
            return GhostLattice(walls.vessel, walls.smallest + smaller, walls.largest + larger, dx, support,
                                mass)
                .at(R, breach);
        };
    };
    BOOST_TEST(!ghosts_are_those_of_all_cells(made_for(0, -dx))); // a smaller sac than the largest
    BOOST_TEST(!ghosts_are_those_of_all_cells(made_for(dx, 0)));  // a larger one than the smallest
}

BOOST_AUTO_TEST_CASE(breach_is_open_through_the_whole_wall)
{
    const Walls walls(shipped_scenario("quick"));
    const double R = walls.vessel.largest_radius();
    const Breach breach{walls.vessel.dome(R), 0.2};

    const WallGhosts ghosts = walls.ghosts.at(R, breach);

    BOOST_TEST(ghosts.size() < walls.ghosts.at(R, std::nullopt).size());
    BOOST_TEST(std::ranges::none_of(ghosts.position, [&](const Vec3& x) {
        return x.y > breach.center.y &&
               std::hypot(x.x - breach.center.x, x.z - breach.center.z) < breach.radius;
    }));
}

BOOST_AUTO_TEST_CASE(blood_and_ghosts_fill_a_row_of_cells_across_the_wall)
{
    // What the ghosts of a row along x leave free is the row's length inside the wall.
    // The wall is nearly plane: at z = dx/2 it is tilted by the cosine c = x_w / r_0. A ramp of slope c/dx,
    // summed over the row, is off by at most (1 - c)/2 cells (Euler-Maclaurin: the kinks at
    // its ends are 1/c cells apart). The curvature z^2/r^3 moves each of the ramp's at most 3 cells,
    // within 0.6 dx of the wall, by half of (0.6 dx)^2 z^2/r^3.
    const auto holds = [](auto mass_of) {
        const Walls walls(shipped_scenario("quick"));
        const double r_0 = walls.vessel.openings()[0].radius;
        const double z = dx / 2;
        const double half_width = std::sqrt(r_0 * r_0 - z * z);
        const double y = walls.vessel.openings()[0].center.y + 3.5 * dx; // far from the junction
        double free = 0;
        auto found = by_cell(walls.vessel, walls.ghosts.at(walls.largest, std::nullopt));
        for (long i = -5; i < 5; ++i) {
            const Cell cell{i, 3, 0};
            const Vec3 x = center_of(walls.vessel, dx, cell);
            BOOST_TEST(within(x.y, y, distance_rounding));
            free += dx * (1 - mass_of(found[cell]) / mass);
        }
        const double c = half_width / r_0;
        const double curved = 3 * 0.6 * 0.6 / 2 * dx * dx * z * z / std::pow(r_0 - 0.6 * dx, 3);
        return within(free, 2 * half_width, 2 * (dx * (1 - c) / 2 + curved) + 10 * distance_rounding);
    };
    BOOST_TEST(holds([](double m) { return m; }));
    BOOST_TEST(!holds([](double m) { return 0.98 * m; }));
    BOOST_TEST(!holds([](double m) { return m > mass / 2 ? mass : 0; })); // whole ghosts or none
}
