// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the start of the pressure's solve in slices, over all pairs.
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/duct.hpp"
#include "verification/checks/sums/incompressible.hpp"
#include "verification/checks/sums/one_iteration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace aneurysm::checks
{
namespace
{

/// Particles of one slice that are above the lowest pressure, and their change.
struct Slice {
    double from = 0; ///< along the duct [m]
    double to = 0;
    double change = 0; ///< of the first [Pa]
};

/// Runs along the duct of particles that change alike, within `error`; `changes`: by place.
std::vector<Slice> slices_of(std::vector<std::pair<double, double>> changes, double error)
{
    std::ranges::sort(changes);
    std::vector<Slice> slices;
    for (const auto& [y, change] : changes) {
        if (slices.empty() || std::abs(change - slices.back().change) > error) {
            slices.push_back({y, y, change});
        }
        slices.back().to = y;
    }
    return slices;
}

/// The slice at or next to a place.
std::size_t slice_at(const std::vector<Slice>& slices, double y)
{
    const auto distance = [y](const Slice& slice) { return std::max(slice.from - y, y - slice.to); };
    return static_cast<std::size_t>(std::ranges::min_element(slices, {}, distance) - slices.begin());
}

/// A duct whose blood comes together (or, with a negative speed, goes apart) before a solve whose only iteration is too weak
/// to do anything but start. A quarter of it has the lowest pressure.
struct Squeezed {
    static constexpr double lowest = -64; ///< pressure [Pa]

    Scenario s;
    SimulationState before;
    double level = 0; ///< of the pressure [Pa]
};
Squeezed squeezed(const Probe& probe, double speed)
{
    Scenario s = without_iterations(duct::scenario(16, 7), 0.75);
    s.kernel.smoothing_length_spacings = 0.8; // so that there are two slices
    s.pressure.start = PressureStart::slices;
    s.pressure.relaxation = 0x1p-100;
    s.pressure.tolerance_per_s = 1e-300;
    s.pressure.max_iterations = 1;
    s.fluid.viscosity_pa_s = 0;
    const double level =
        s.outlet.level_margin * s.fluid.density_kg_m3 * std::pow(s.inlet.peak_velocity_m_s, 2);
    s.outlet.pressure_pa = level - Squeezed::lowest;
    SimulationState before = duct::disturbed(probe, s, 0);
    Particles& p = before.particles;
    const double length = static_cast<double>(s.domain.cells_y) * s.domain.spacing_m;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.pressure[i] = i % 4 == 0 ? 2 * Squeezed::lowest : static_cast<double>(i * i % 61);
        p.drift[i] = 0;
        p.velocity[i].y -= speed * p.position[i].y / length;
    }
    return {s, before, level};
}

/// The free blood of a start, and what its pressures were and became.
class Start
{
public:
    Start(const Probe& probe, const Squeezed& scene)
        : scene_(scene), flow_(probe.simulate(scene.s, scene.before)), dt_(scene.s.time.frame_s)
    {
        flow_->advance();
        cloud_ = duct::cloud_of(scene_.s, scene_.before, flow_->density());
        of_velocity_ = duct::push_at_outlet(probe, scene_.s, scene_.before, scene_.level, cloud_);
        const Particles& p = scene_.before.particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (cloud_.free[i] && duct::is_blood(p.kind[i])) {
                blood_.push_back(i);
                cloud_.pressure[i] = std::max(Squeezed::lowest, p.pressure[i]);
                largest_ = std::max(largest_, std::abs(after(i)));
            }
        }
        largest_ += scene_.level + scene_.s.outlet.pressure_pa;
    }

    const std::vector<std::size_t>& blood() const { return blood_; }
    bool is_lowest(std::size_t i) const { return scene_.before.particles.pressure[i] < Squeezed::lowest; }
    double y(std::size_t i) const { return scene_.before.particles.position[i].y; }
    double after(std::size_t i) const { return flow_->solved_pressure()[i]; }
    const analytic::Cloud& cloud() const { return cloud_; }
    double largest() const { return largest_; }

    OneIteration solve(const Probe& probe, const analytic::Cloud& cloud) const
    {
        return {probe, scene_.s, cloud, of_velocity_};
    }
    analytic::Estimate residual(const OneIteration& solve, std::size_t i) const
    {
        const auto missing = duct::missing_density(scene_.s, scene_.before.particles, cloud_, i);
        return solve.residual(i, {missing.value / dt_, missing.error / dt_});
    }
    /// dt rho_0^2 sum_i (sum_j |m_j grad W_ij| / rho_0^2)^2, by Cauchy and Schwarz over at most 64 neighbors: more than any
    /// entry of the slices' equations [kg/(m^3 s Pa)].
    double largest_entry() const
    {
        double sum = 0;
        for (const std::size_t i : blood_) {
            sum += 64 / analytic::pair_dfsph_factor(cloud_, i).value;
        }
        return dt_ * sum / std::pow(scene_.s.fluid.density_kg_m3, 2);
    }

private:
    Squeezed scene_;
    std::unique_ptr<Simulation> flow_;
    double dt_;
    analytic::Cloud cloud_;
    double of_velocity_ = 0;
    double largest_ = 0;
    std::vector<std::size_t> blood_;
};

/// Which slices there are shows in the blood above the lowest pressure, all of it members.
std::vector<Slice> slices_of(const Start& start, double error)
{
    std::vector<std::pair<double, double>> changes;
    for (const std::size_t i : start.blood()) {
        if (!start.is_lowest(i)) {
            changes.emplace_back(start.y(i), start.after(i) - start.cloud().pressure[i]);
        }
    }
    return slices_of(std::move(changes), error);
}

/// One constant a slice, for its members alone, after which their residuals add up to 0.
void comes_together(Probe& probe)
{
    Quantity& pressure = probe.quantity(
        "pressure after the start [Pa]", Source::rounding,
        "gamma_8 of the largest pressure, twice, as a slice's change is that of its first particle");
    Quantity& left = probe.quantity(
        "sum of the residuals of a slice [kg/(m^3 s)]", Source::rounding,
        "the bounds of all its members' residuals, for oracle and subject, + gamma_200 of the largest entry that the "
        "slices' equations may have times twice the largest change");
    Quantity& seen =
        probe.quantity("slices, and particles at the lowest pressure that are members and that are not",
                       Source::exact, "a claim: two slices at least, and some of each kind");
    const Start start(probe, squeezed(probe, 4));
    const double error = 2 * probe.gamma(8) * start.largest();
    const std::vector<Slice> slices = slices_of(start, 2 * error);
    const OneIteration before = start.solve(probe, start.cloud());
    auto moved = start.cloud();
    std::vector<std::vector<std::size_t>> members(slices.size());
    std::array<int, 2> at_lowest{};
    for (const std::size_t i : start.blood()) {
        const std::size_t c = slice_at(slices, start.y(i));
        const bool is_member = !start.is_lowest(i) || start.residual(before, i).value > 0;
        moved.pressure[i] += is_member ? slices[c].change : 0;
        pressure.within(start.after(i), moved.pressure[i], error, "particle " + std::to_string(i));
        at_lowest.at(is_member ? 0 : 1) += start.is_lowest(i) ? 1 : 0;
        if (is_member) {
            members[c].push_back(i);
        }
    }
    seen.holds(slices.size() >= 2 && std::ranges::min(at_lowest) > 0);
    const OneIteration after = start.solve(probe, moved);
    const double of_solve = probe.gamma(200) * start.largest_entry() * 2 * start.largest();
    for (std::size_t c = 0; c < slices.size(); ++c) {
        analytic::Estimate sum{0, of_solve};
        for (const std::size_t i : members[c]) {
            const auto r = start.residual(after, i);
            sum.value += r.value;
            sum.error += r.error;
        }
        left.within(sum.value, 0, sum.error, "slice " + std::to_string(c));
    }
}

/// Where blood goes apart, constants below 0 would pull its pressure below the lowest.
void goes_apart(Probe& probe)
{
    Quantity& pressure = probe.quantity("pressure where blood goes apart [Pa]", Source::rounding,
                                        "gamma_8 of the pressures whose difference the lowest is");
    const Start start(probe, squeezed(probe, -32));
    for (const std::size_t i : start.blood()) {
        pressure.within(start.after(i), Squeezed::lowest, probe.gamma(8) * start.largest(),
                        "particle " + std::to_string(i));
    }
}

void start_in_slices(Probe& probe)
{
    comes_together(probe);
    goes_apart(probe);
}

} // namespace

std::vector<Check> slices_checks()
{
    return {sum_check(
        "eq03_slices", {"3"},
        "the pressure's solve starts with a constant in each slice, such that the residuals of its particles "
        "add up to 0",
        {"brute force over all pairs"}, start_in_slices)};
}

} // namespace aneurysm::checks
