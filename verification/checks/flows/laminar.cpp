// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/flows/laminar.hpp"

#include "common/scenario/shipped.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

namespace aneurysm::checks
{
namespace
{

using analytic::Section;

/// A tube's columns lie deeper than this in the wall, in spacings; see sample_lattice.
constexpr double inset = 0.08;

/// Narrowest periodic box, in cells: three supports.
std::int64_t cells_along(const Laminar& flow)
{
    return static_cast<std::int64_t>(std::ceil(6 * flow.ratio));
}

std::int64_t particles_of_column(const Laminar& flow)
{
    const std::int64_t along = cells_along(flow);
    return flow.section == Section::channel ? along * along : along;
}

/// Number of the cell of x, counted from the middle.
long cell(double x, double dx)
{
    return std::lround(std::floor(x / dx));
}

} // namespace

analytic::LatticeDuct Laminar::lattice() const
{
    const Scenario s = shipped_scenario("verify_channel");
    const analytic::Lattice lattice{s.kernel.function, ratio * dx(), dx()};
    const double rho_0 = s.fluid.density_kg_m3;
    return section == Section::channel
               ? analytic::lattice_channel(lattice, rho_0, nu * rho_0, across)
               : analytic::lattice_tube(lattice, rho_0, nu * rho_0, width / 2, inset * dx());
}

Scenario Laminar::scenario() const
{
    const bool plane = section == Section::channel;
    Scenario s = shipped_scenario(plane ? "verify_channel" : "verify_tube");
    s.domain.spacing_m = dx();
    (plane ? s.domain.cells_x : s.domain.cells_y) = cells_along(*this);
    (plane ? s.domain.cells_y : s.domain.cells_x) = across;
    s.domain.cells_z = plane ? cells_along(*this) : across;
    s.particles.count = static_cast<std::int64_t>(lattice().size()) * particles_of_column(*this);
    s.kernel.smoothing_length_spacings = ratio;
    s.pressure.relaxation = 0.2; // below the limit up to h/dx = 1.3
    s.fluid.viscosity_pa_s = nu * s.fluid.density_kg_m3;
    s.fluid.gravity_m_s2 = plane ? Vec3{drive.g, 0, 0} : Vec3{0, drive.g, 0};
    s.fluid.gravity_cycle_s = drive.steady() ? 0 : 2 * std::numbers::pi / drive.omega;
    s.time.frame_s = dt;
    s.inlet.peak_velocity_m_s = 0.5; // the fastest of these flows, which the step must be short enough for
    return s;
}

std::string Laminar::name() const
{
    std::string name = section == Section::channel ? "channel, " : "tube, ";
    name += std::to_string(across) + " cells across";
    name += ratio == 1 ? "" : ", h/dx " + std::to_string(ratio);
    return name + (drive.steady() ? ", steady force"
                                  : ", alpha " + std::to_string(analytic::womersley_number(exact(), drive)));
}

analytic::Drive pulse(double g, double womersley)
{
    return {g, womersley * womersley * Laminar::nu / (Laminar::width * Laminar::width / 4)};
}

int steps_to(double t, double dx, int parts)
{
    return parts * static_cast<int>(std::ceil(t * Laminar::nu / (0.1 * dx * dx * parts)));
}

LaminarFlow::LaminarFlow(const Probe& probe, const Laminar& flow, Quantity& placed)
    : LaminarFlow(probe, flow, flow.scenario(), placed)
{
}

LaminarFlow::LaminarFlow(const Probe& probe, const Laminar& flow, const Scenario& scenario, Quantity& placed)
    : flow_(flow), backend_(probe.simulate(scenario))
{
    const bool plane = flow.section == Section::channel;
    const analytic::LatticeDuct lattice = flow.lattice();
    const double dx = flow.dx();
    std::map<std::pair<long, long>, std::size_t> columns;
    for (std::size_t a = 0; a < lattice.size(); ++a) {
        const Eigen::Vector2d& x = lattice.fluid[a].x;
        columns[{cell(x(0), dx), plane ? 0 : cell(x(1), dx)}] = a;
    }
    std::vector<std::int64_t> counts(lattice.size() + 1, 0);
    for (const Vec3& x : backend_->state().particles.position) {
        const auto found = columns.find(plane ? std::pair(cell(x.y - Laminar::width / 2, dx), 0L)
                                              : std::pair(cell(x.x, dx), cell(x.z, dx)));
        column_.push_back(found == columns.end() ? lattice.size() : found->second);
        ++counts[column_.back()];
    }
    for (std::size_t a = 0; a < lattice.size(); ++a) {
        placed.equal(counts[a], particles_of_column(flow), flow.name());
    }
    placed.equal(counts.back(), 0, flow.name() + ", elsewhere");
    if (counts.back() > 0) {
        throw std::runtime_error(flow.name() + ": particles that the oracle has no column for");
    }
}

void LaminarFlow::advance(int steps)
{
    for (int step = 0; step < steps; ++step) {
        backend_->advance();
    }
    steps_ += steps;
}

void LaminarFlow::for_each(const std::function<void(std::size_t, double)>& visit) const
{
    const std::vector<Vec3>& velocity = backend_->state().particles.velocity;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        visit(column_[i], flow_.section == Section::channel ? velocity[i].x : velocity[i].y);
    }
}

Eigen::VectorXd LaminarFlow::profile() const
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(flow_.lattice().size()));
    for_each([&](std::size_t a, double v) { sum(static_cast<Eigen::Index>(a)) += v; });
    return sum / static_cast<double>(particles_of_column(flow_));
}

} // namespace aneurysm::checks
