// SPDX-License-Identifier: Apache-2.0
// Poiseuille's and Womersley's flows along walls at rest, (1), (7), (15) and (27), at several resolutions, in motion: how
// far they are from the exact ones, at which order that falls, and what of it the lattice predicts.
#include "analytic/lattice/lattice_duct_steps.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/flows/laminar.hpp"

#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Drive;
using analytic::Section;
using analytic::SlidingDuct;

constexpr int samples = 40; ///< looks at a flow, evenly spaced

/// One flow at several resolutions.
struct Study {
    Section section = Section::channel;
    Drive drive;
    double t = 0;            ///< the end [s]
    std::vector<int> across; ///< cells between the walls

    Laminar at(int cells) const
    {
        Laminar flow{section, cells, 1, drive, 0};
        flow.dt = t / steps(flow);
        return flow;
    }
    int steps(const Laminar& flow) const { return steps_to(t, flow.dx(), samples); }
    std::string name() const
    {
        const std::string where = section == Section::channel ? "channel" : "tube";
        const auto alpha = std::lround(analytic::womersley_number(at(8).exact(), drive));
        return drive.steady() ? where : where + ", alpha " + std::to_string(alpha);
    }
};

/// What all studies of a check are compared in.
struct Ledger {
    explicit Ledger(Probe& probe)
        : placed(probe.quantity("particles in each column of the lattice", Source::exact,
                                "integers: cells along the duct, and across it in a channel")),
          pressure(probe.quantity("iterations of the pressure solve", Source::exact,
                                  "none: its tolerance is above all that sliding does to the density")),
          error(probe.quantity("L2 error against the exact flow, found - predicted [1]", Source::rounding,
                               "the norm of what rounding makes of the sliding columns, by the triangle "
                               "inequality (docs/bounds.md, B10)")),
          order(probe.quantity(
              "observed order of the L2 error, found - predicted [1]", Source::rounding,
              "that of both errors over themselves, over the logarithm of the ratio of spacings"))
    {
    }
    Quantity& placed;
    Quantity& pressure;
    Quantity& error;
    Quantity& order;
};

/// Norm of the exact flow and L2 error of another, at a time.
analytic::FlowError error_of(const Laminar& flow, const analytic::LatticeDuct& lattice,
                             const Eigen::VectorXd& velocity, double t)
{
    return analytic::flow_error(lattice, velocity, [&](double r) {
        return analytic::velocity(flow.exact(), flow.drive, r, t).value;
    });
}

/// Root mean square of the exact flow over the columns [m/s].
double exact_size(const Laminar& flow, const analytic::LatticeDuct& lattice, double t)
{
    double squares = 0;
    for (std::size_t a = 0; a < lattice.size(); ++a) {
        squares += std::pow(analytic::velocity(flow.exact(), flow.drive, lattice.r(a), t).value, 2);
    }
    return std::sqrt(squares / static_cast<double>(lattice.size()));
}

/// Of a tube an eighth is enough: the rest are mirror images.
Series profile_of(const Laminar& flow, const analytic::LatticeDuct& lattice, const Eigen::VectorXd& velocity)
{
    Series series{std::to_string(flow.across) + " cells across", {}, {}, false};
    for (std::size_t a = 0; a < lattice.size(); ++a) {
        const Eigen::Vector2d& x = lattice.fluid[a].x;
        const bool plane = flow.section == Section::channel;
        if (plane || (x(1) >= 0 && x(1) <= x(0))) {
            series.x.push_back(plane ? x(0) : x.norm());
            series.y.push_back(velocity(static_cast<Eigen::Index>(a)));
        }
    }
    return series;
}

Series exact_profile(const Laminar& flow, double t)
{
    Series series{"exact", {}, {}, true};
    for (int i = flow.section == Section::channel ? -50 : 0; i <= 50; ++i) {
        const double r = Laminar::width / 2 * i / 50;
        series.x.push_back(r);
        series.y.push_back(analytic::velocity(flow.exact(), flow.drive, std::abs(r), t).value);
    }
    return series;
}

/// An L2 error, what is predicted, and how far another text may be from that.
struct LastError {
    double found = 0;
    double predicted = 0;
    double bound = 0;
};

/// What is seen of a study.
struct Pictures {
    Plot profiles; ///< at the end, of all resolutions
    Plot means;    ///< over time
};

/// One resolution from rest to the end.
LastError run(const Probe& probe, const Study& study, int across, Ledger& ledger, Pictures& pictures)
{
    const Laminar flow = study.at(across);
    const analytic::LatticeDuct lattice = flow.lattice();
    Scenario s = flow.scenario();
    s.pressure.tolerance_per_s = s.pressure.max_tolerance_per_s = 1000;
    LaminarFlow simulated(probe, flow, s, ledger.placed);
    SlidingDuct sliding(lattice);
    const int steps = study.steps(flow) / samples;
    Series mean{std::to_string(across) + " cells across", {}, {}, false};
    LastError last;
    for (int sample = 1; sample <= samples; ++sample) {
        simulated.advance(steps);
        for (int n = 0; n < steps; ++n) {
            sliding.step(flow.drive, flow.dt);
        }
        const double t = simulated.steps() * flow.dt;
        const Eigen::VectorXd profile = simulated.profile();
        mean.x.push_back(t);
        mean.y.push_back(profile.mean());
        if (sample == 1 || sample % 10 == 0) {
            const double rounded = sliding.error(probe.roundoff(), std::max(Laminar::width, 6 * flow.dx()));
            last = {error_of(flow, lattice, profile, t).l2, error_of(flow, lattice, sliding.velocity(), t).l2,
                    rounded / exact_size(flow, lattice, t)};
            ledger.error.within(last.found, last.predicted, last.bound,
                                study.name() + ", " + std::to_string(across) + " cells, t " +
                                    std::to_string(t));
        }
        if (sample == samples) {
            pictures.profiles.series.push_back(profile_of(flow, lattice, profile));
        }
    }
    ledger.pressure.equal(simulated.iterations(), 0, flow.name());
    pictures.means.series.push_back(mean);
    return last;
}

/// L2 error at the end if no column slid.
double frozen_error(const Study& study, int across)
{
    const Laminar flow = study.at(across);
    const analytic::LatticeDuct lattice = flow.lattice();
    const analytic::DuctModes modes{analytic::DuctOperator(lattice)};
    return error_of(flow, lattice, modes.after(flow.drive, flow.dt, study.steps(flow)).value, study.t).l2;
}

Pictures exact_pictures(const Study& study)
{
    const Laminar flow = study.at(study.across[0]);
    const bool plane = study.section == Section::channel;
    const double area = plane ? Laminar::width : std::numbers::pi * Laminar::width * Laminar::width / 4;
    Series mean{"exact", {}, {}, true};
    for (int sample = 0; sample <= 2 * samples; ++sample) {
        mean.x.push_back(study.t * sample / (2 * samples));
        mean.y.push_back(analytic::flow_rate(flow.exact(), flow.drive, mean.x.back()).value / area);
    }
    return {
        {"Velocity at t = " + std::to_string(study.t) + " s, " + study.name(),
         plane ? "distance from the middle [m]" : "distance from the axis [m]",
         "velocity [m/s]",
         false,
         false,
         {exact_profile(flow, study.t)}},
        {"Mean velocity from rest, " + study.name(), "t [s]", "mean velocity [m/s]", false, false, {mean}}};
}

void look_at(Probe& probe, const Study& study, Ledger& ledger)
{
    Pictures pictures = exact_pictures(study);
    Plot errors{"L2 error at t = " + std::to_string(study.t) + " s, " + study.name(),
                "cells between the walls",
                "error over the exact flow",
                true,
                true,
                {{"found", {}, {}, false},
                 {"predicted: columns that slide", {}, {}, true},
                 {"columns that don't slide", {}, {}, true}}};
    LastError coarse;
    for (std::size_t i = 0; i < study.across.size(); ++i) {
        const int across = study.across[i];
        const LastError fine = run(probe, study, across, ledger, pictures);
        const std::array<double, 3> values{fine.found, fine.predicted, frozen_error(study, across)};
        for (std::size_t series = 0; series < 3; ++series) {
            errors.series[series].x.push_back(across);
            errors.series[series].y.push_back(values.at(series));
        }
        const std::string where = study.name() + ", " + std::to_string(across) + " cells";
        probe.note("L2 error, " + where, fine.found);
        if (i > 0) {
            const double ratio = std::log(static_cast<double>(across) / study.across[i - 1]);
            const double order = std::log(coarse.found / fine.found) / ratio;
            ledger.order.within(order, std::log(coarse.predicted / fine.predicted) / ratio,
                                (coarse.bound / coarse.predicted + fine.bound / fine.predicted) / ratio,
                                where);
            probe.note("observed order, " + where, order,
                       "1 for a wall displaced by a part of dx; less, as sliding columns are less viscous");
        }
        coarse = fine;
    }
    probe.plot(std::move(pictures.profiles));
    probe.plot(std::move(pictures.means));
    probe.plot(std::move(errors));
}

/// With the artery's pressure solve, from a disturbed lattice: it breaks up, and no discrete answer is known.
void with_pressure(Probe& probe)
{
    const Study study{Section::channel, {0.5, 0}, 0.6, {16}};
    const Laminar flow = study.at(16);
    Scenario s = flow.scenario();
    s.pressure = shipped_scenario("base").pressure;
    s.particles.jitter_spacings = 0.05;
    const auto simulated = probe.simulate(s);
    std::int64_t iterations = 0;
    for (int n = 0; n < study.steps(flow); ++n) {
        iterations += simulated->advance().iterations;
    }
    const Particles& p = simulated->state().particles;
    double squares = 0;
    double exact_squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double r = std::abs(p.position[i].y - Laminar::width / 2);
        const double exact = analytic::velocity(flow.exact(), flow.drive, r, study.t).value;
        squares += std::pow(p.velocity[i].x - exact, 2);
        exact_squares += exact * exact;
    }
    probe.note("L2 error with the artery's pressure solve, 16 cells, t 0.6",
               std::sqrt(squares / exact_squares), "no bound: the lattice breaks up");
    probe.note("its iterations a step", static_cast<double>(iterations) / study.steps(flow));
    probe.note("L2 error of the lattice there, if nothing slides", frozen_error(study, 16));
}

void poiseuille_channel(Probe& probe)
{
    Ledger ledger(probe);
    look_at(probe, {Section::channel, {0.5, 0}, 3, {8, 12, 16, 24}}, ledger);
    with_pressure(probe);
}

void poiseuille_tube(Probe& probe)
{
    Ledger ledger(probe);
    look_at(probe, {Section::pipe, {0.8, 0}, 1.2, {8, 12, 16, 20}}, ledger);
}

/// The first cycle, or half of a long one, at about 0.4 m/s.
Study pulsating(Section section, double alpha, std::vector<int> across)
{
    const double omega = pulse(1, alpha).omega;
    const double t = (alpha > 2 ? 2 : 1) * std::numbers::pi / omega;
    return {section, pulse(0.2 * omega + 0.3, alpha), t, std::move(across)};
}

void womersley_channel(Probe& probe)
{
    Ledger ledger(probe);
    for (const double alpha : {2.0, 4.0, 8.0}) {
        look_at(probe, pulsating(Section::channel, alpha, {8, 16, 24}), ledger);
    }
}

void womersley_tube(Probe& probe)
{
    Ledger ledger(probe);
    for (const double alpha : {2.0, 4.0, 8.0}) {
        look_at(probe, pulsating(Section::pipe, alpha, {8, 12, 16}), ledger);
    }
}

} // namespace

std::vector<Check> laminar_flow_checks()
{
    const Names flow{"27", "1", "5", "7", "15"};
    const Names oracles{"exact flow from rest, two ways (oracle_flow_from_rest)",
                        "sliding columns, which predict the error"};
    return {
        limit_check("poiseuille_channel", flow,
                    "flow between plates tends to Poiseuille's with the predicted error and order", oracles,
                    poiseuille_channel),
        limit_check("womersley_channel", flow,
                    "pulsating flow between plates tends to Womersley's with the predicted error and order",
                    oracles, womersley_channel),
        limit_check("poiseuille_tube", flow,
                    "flow in a tube tends to Hagen and Poiseuille's with the predicted error and order",
                    oracles, poiseuille_tube),
        limit_check("womersley_tube", flow,
                    "pulsating flow in a tube tends to Womersley's with the predicted error and order",
                    oracles, womersley_tube),
    };
}

} // namespace aneurysm::checks
