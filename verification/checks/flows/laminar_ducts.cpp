// SPDX-License-Identifier: Apache-2.0
// Flows along channel and tube, (1), (7), (15) and (27), whose discrete answer is known: too slow to move anything.
#include "analytic/lattice/lattice_duct_steps.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/flows/laminar.hpp"

#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Drive;
using analytic::DuctOperator;
using analytic::Section;

constexpr double weak = 0x1p-60; ///< a force that moves nothing by a rounding [m/s^2]

Quantity& placed(Probe& probe)
{
    return probe.quantity("particles in each column of the lattice", Source::exact,
                          "integers: cells along the duct, and across it in a channel");
}

/// The largest coordinate, which places are rounded at [m].
double extent(const Laminar& flow)
{
    return std::max(Laminar::width, 6 * flow.ratio * flow.dx());
}

/// Everything that one text of dt A u may differ by from another, over n steps.
double allowed(const Probe& probe, const DuctOperator& A, const Laminar& flow, int n)
{
    const double each = probe.roundoff();
    return analytic::step_uncertainty(A, flow.drive, flow.dt, n, each, 4 * each * extent(flow));
}

void frozen(Probe& probe)
{
    Quantity& place = placed(probe);
    Quantity& velocity = probe.quantity(
        "u/g of each particle, against its column's [s]", Source::rounding,
        "in each step dt times the uncertainty of the couplings and the rounding of the step, for as many "
        "steps as there are (docs/bounds.md, B9)");
    const auto cases = {Laminar{Section::channel, 8, 1, {weak, 0}, 0.009},
                        Laminar{Section::channel, 16, 1, pulse(weak, 8), 0.002},
                        Laminar{Section::channel, 12, 1.3, pulse(weak, 4), 0.004},
                        Laminar{Section::pipe, 8, 1, {weak, 0}, 0.009},
                        Laminar{Section::pipe, 8, 1.3, pulse(weak, 2), 0.009},
                        Laminar{Section::pipe, 10, 1, pulse(weak, 4), 0.006}};
    for (const Laminar& flow : cases) {
        const DuctOperator A(flow.lattice());
        LaminarFlow found(probe, flow, place);
        for (const int steps : {1, 9, 50}) {
            found.advance(steps);
            const analytic::Profile expected = step_by_step(A, flow.drive, flow.dt, found.steps());
            const double bound = expected.error + allowed(probe, A, flow, found.steps());
            found.for_each([&](std::size_t a, double v) {
                velocity.within(v / weak, expected.value(static_cast<Eigen::Index>(a)) / weak, bound / weak,
                                flow.name() + ", step " + std::to_string(found.steps()));
            });
        }
    }
}

void time_order(Probe& probe)
{
    Quantity& place = placed(probe);
    Quantity& order =
        probe.quantity("observed order in dt, against that of the lattice [1]", Source::rounding,
                       "the order is the logarithm of a ratio of two differences: 2/ln 2 times the relative "
                       "error of the smaller one (docs/bounds.md, B11)");
    Quantity& first =
        probe.quantity("order in dt of the lattice, from dt/2, dt/4, dt/8 [1]", Source::truncation,
                       "p - 1 tends to 0 with dt: what it is from dt, dt/2, dt/4");
    for (const Section section : {Section::channel, Section::pipe}) {
        for (const Drive& drive : {Drive{weak, 0}, pulse(weak, 4)}) {
            const double t = 0.06;
            std::vector<Eigen::VectorXd> found;
            std::vector<Eigen::VectorXd> expected;
            double bound = 0;
            for (const int n : {8, 16, 32, 64}) {
                const Laminar flow{section, 8, 1, drive, t / n};
                const DuctOperator A(flow.lattice());
                const auto profile = step_by_step(A, drive, flow.dt, n);
                expected.push_back(profile.value);
                if (n < 64) {
                    LaminarFlow simulated(probe, flow, place);
                    simulated.advance(n);
                    found.push_back(simulated.profile());
                    bound = std::max(bound, profile.error + allowed(probe, A, flow, n));
                }
            }
            const auto p = [](const std::vector<Eigen::VectorXd>& u, std::size_t i) {
                return std::log2((u[i] - u[i + 1]).norm() / (u[i + 1] - u[i + 2]).norm());
            };
            const double size = std::sqrt(static_cast<double>(expected[0].size()));
            const std::string where = Laminar{section, 8, 1, drive, t / 8}.name();
            order.within(p(found, 0), p(expected, 0),
                         2 / std::log(2.0) * 2 * bound * size / (expected[1] - expected[2]).norm(), where);
            first.within(p(expected, 1), 1, std::abs(p(expected, 0) - 1), where);
            probe.note("observed order in dt, " + where, p(found, 0));
        }
    }
}

} // namespace

std::vector<Check> laminar_ducts_checks()
{
    const Names flow{"27", "1", "5", "7", "15"};
    return {
        flow_check("eq27_frozen_ducts", flow, "slow flow along walls at rest is the lattice's, step by step",
                   {"the columns' matrix, in long double (oracle_duct_steps)"}, frozen),
        flow_check("eq27_time_order", flow, "steps of (7) and (15) are of first order in dt",
                   {"the columns' matrix, in long double (oracle_duct_steps)"}, time_order),
    };
}

} // namespace aneurysm::checks
