// SPDX-License-Identifier: Apache-2.0
// Section 3.5: the inlet's velocity (25), as printed and by the other waveforms that a scenario may choose, its profile
// over the section and its start.
#include "analytic/boundary.hpp"
#include "analytic/exact/waveform.hpp"
#include "analytic/laminar_flow.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;

constexpr std::array<std::pair<Waveform, const char*>, 4> formulas{
    {{Waveform::sine, "sine "},
     {Waveform::rectified_sine, "rectified sine "},
     {Waveform::raised_sine, "raised sine "},
     {Waveform::constant, "constant "}}};

backends::Inlet inlet_of(Waveform waveform, double v_0, double T)
{
    backends::Inlet inlet;
    inlet.waveform = waveform;
    inlet.peak_velocity_m_s = v_0;
    inlet.cycle_s = T;
    return inlet;
}

void eq25_waveforms(Probe& probe)
{
    const std::string of_text = "gamma_3 x |dv/dx| for pi, a product and a quotient in the angle x; gamma_2 "
                                "v_0 and gamma_3 |v| for the sine, one sum and product, the oracle's value";
    Quantity& digits = probe.quantity("v against 50 digits [m/s]", Source::rounding, of_text);
    Quantity& gsl = probe.quantity("v against GSL's sine [m/s]", Source::rounding,
                                   of_text + "; GSL's bound, 4 u of x in its own angle");
    Quantity& oracles = probe.quantity("GSL's sine against 50 digits [m/s]", Source::rounding,
                                       "GSL's bound, 4 u of x in the angle, gamma_3 v_0 of the value");
    Quantity& constant =
        probe.quantity("v of the constant waveform [m/s]", Source::exact, "0: nothing is computed");
    Arguments a(25);
    for (const auto& [waveform, name] : formulas) {
        for (int n = 0; n < 150; ++n) {
            const double v_0 = a.between(0.05, 9);
            const double T = a.between(0.3, 1.7);
            const double t =
                n < 10 ? 0.1 * n * T : a.between(-1, 3) * T; // whole tenths, the zeros among them
            const std::string where = name + at({{"v_0", v_0}, {"T", T}, {"t/T", t / T}});
            const double v = probe.equations().inlet_velocity(inlet_of(waveform, v_0, T), t);
            const analytic::WaveformValue exact = analytic::exact_waveform(waveform, v_0, T, t);
            const Estimate by_gsl = analytic::waveform_velocity(waveform, v_0, T, t);
            const double allowed = rounding(3) * exact.angle_times_slope + rounding(2) * v_0 +
                                   rounding(3) * std::abs(exact.value);
            const double of_gsl =
                by_gsl.error + rounding(4) * (exact.angle_times_slope + v_0) + rounding(3) * v_0;
            digits.within(v, exact.value, allowed, where);
            gsl.within(v, by_gsl.value, allowed + of_gsl, where);
            oracles.within(by_gsl.value, exact.value, of_gsl, where);
            if (waveform == Waveform::constant) {
                constant.within(v, v_0, 0, where);
            }
        }
    }
}

void eq25_transport(Probe& probe)
{
    Quantity& transport =
        probe.quantity("int v dt of a cycle over v_0 T [1]", Source::quadrature,
                       "GSL's estimate over half cycles; gamma_6 2 pi of v, 3 of an angle below 2 pi");
    Quantity& oracles =
        probe.quantity("int v dt of GSL's sines over v_0 T [1]", Source::quadrature,
                       "GSL's estimate over half cycles; gamma_6 2 pi of v, 4 of an angle below 2 pi");
    Quantity& extremes = probe.quantity("the sine at 0, T/4, T/2, 3 T/4 over v_0 [1]", Source::rounding,
                                        "gamma_3 x where it turns; gamma_3 at its extremes, where an error "
                                        "of the angle doesn't count; 0 at 0");
    const double v_0 = 0.31;
    const double T = 0.83;
    for (const auto& [waveform, name] : formulas) {
        const auto v = [&, shape = waveform](double t) {
            return probe.equations().inlet_velocity(inlet_of(shape, v_0, T), t);
        };
        const Estimate sum = analytic::cycle_transport(v, {0, T / 2, T});
        const double angle = 2 * std::numbers::pi;
        transport.within(sum.value / (v_0 * T), analytic::exact_transport(waveform),
                         sum.error / (v_0 * T) + rounding(6) * angle, name);
        const Estimate by_gsl = analytic::cycle_transport(
            [&, shape = waveform](double t) { return analytic::waveform_velocity(shape, v_0, T, t).value; },
            {0, T / 2, T});
        oracles.within(by_gsl.value / (v_0 * T), analytic::exact_transport(waveform),
                       by_gsl.error / (v_0 * T) + rounding(6) * angle, name);
    }
    const auto sine = [&](double t) {
        return probe.equations().inlet_velocity(inlet_of(Waveform::sine, v_0, T), t) / v_0;
    };
    extremes.within(sine(0), 0, 0, "0");
    extremes.within(sine(T / 4), 1, rounding(3), "T/4");
    extremes.within(sine(T / 2), 0, rounding(3) * std::numbers::pi, "T/2");
    extremes.within(sine(3 * T / 4), -1, rounding(3), "3 T/4");
}

/// A table, and its steepest slope and largest entry for bounds.
struct Table {
    backends::Inlet inlet;
    std::string name;

    double largest() const
    {
        double v = 0;
        for (const double entry : inlet.table_velocity_m_s) {
            v = std::max(v, std::abs(entry));
        }
        return v;
    }
    double steepest() const
    {
        double slope = 0;
        const std::size_t n = inlet.table_time_s.size();
        for (std::size_t k = 0; k < n; ++k) {
            const double next = k + 1 < n ? inlet.table_time_s[k + 1] : inlet.cycle_s + inlet.table_time_s[0];
            const double rise = inlet.table_velocity_m_s[(k + 1) % n] - inlet.table_velocity_m_s[k];
            slope = std::max(slope, std::abs(rise) / (next - inlet.table_time_s[k]));
        }
        return slope;
    }
};

std::vector<Table> tables()
{
    const auto table = [](const char* name, double T, std::vector<double> time,
                          std::vector<double> velocity) {
        Table result{inlet_of(Waveform::table, 9, T), name};
        result.inlet.table_time_s = std::move(time);
        result.inlet.table_velocity_m_s = std::move(velocity);
        return result;
    };
    return {table("one entry, ", 0.8, {0}, {0.37}), table("two entries, ", 0.7, {0, 0.23}, {0.3, -0.8}),
            table("five entries, ", 0.8, {0, 0.09, 0.26, 0.51, 0.77}, {0.05, 0.41, -0.13, 0.022, 0.31})};
}

void eq25_table(Probe& probe)
{
    const std::string of_text =
        "steepest slope times gamma_2 (|t| + T) for the time in the cycle; 3 gamma_6 of the largest entry";
    Quantity& hats = probe.quantity("v against a sum of hats, 50 digits [m/s]", Source::rounding, of_text);
    Quantity& gsl = probe.quantity("v against GSL's interpolation [m/s]", Source::rounding,
                                   of_text + ", twice; 8 u of the largest entry of GSL's");
    Quantity& oracles = probe.quantity("GSL's interpolation against the hats [m/s]", Source::rounding,
                                       of_text + "; 8 u of the largest entry");
    Quantity& entries = probe.quantity("v at an entry's time in the first cycle [m/s]", Source::exact,
                                       "0: the slope is multiplied by 0");
    Arguments a(251);
    for (const Table& table : tables()) {
        const double T = table.inlet.cycle_s;
        const auto& time = table.inlet.table_time_s;
        std::vector<double> times{std::nextafter(T, 0), T, std::nextafter(T, 9), -T, std::nextafter(-T, -9)};
        for (int n = 0; n < 200; ++n) {
            times.push_back(a.between(-2, 5) * T);
        }
        for (std::size_t k = 0; k < time.size(); ++k) {
            for (const double cycle : {0.0, T, 3 * T, 1000 * T}) {
                times.push_back(time[k] + cycle);
                times.push_back(std::nextafter(time[k] + cycle, 1e9));
                times.push_back(std::nextafter(time[k] + cycle, -1));
            }
            entries.within(probe.equations().inlet_velocity(table.inlet, time[k]),
                           table.inlet.table_velocity_m_s[k], 0, table.name + at({{"entry", double(k)}}));
        }
        for (const double t : times) {
            const std::string where = table.name + at({{"t/T", t / T}});
            const double v = probe.equations().inlet_velocity(table.inlet, t);
            const double hat = analytic::hat_sum(time, table.inlet.table_velocity_m_s, T, t);
            const double by_gsl = analytic::interpolated_velocity(time, table.inlet.table_velocity_m_s, T, t);
            const double allowed =
                table.steepest() * rounding(2) * (std::abs(t) + T) + 3 * rounding(6) * table.largest();
            const double of_gsl = rounding(8) * table.largest();
            hats.within(v, hat, allowed, where);
            gsl.within(v, by_gsl, 2 * allowed + of_gsl, where);
            oracles.within(by_gsl, hat, allowed + of_gsl, where);
        }
    }
}

void eq25_table_seam(Probe& probe)
{
    Quantity& seam = probe.quantity(
        "v where whole cycles end over the first entry [1]", Source::rounding,
        "steepest slope times gamma_2 (t + T), 3 gamma_6 of the largest entry, over the entry");
    Table table = tables().back();
    table.inlet.cycle_s = 0.8; // a whole cycle of 800 frames of 0.001 s may be rounded to either side
    const double first = table.inlet.table_velocity_m_s[0];
    for (int cycle = 1; cycle <= 400; ++cycle) {
        const double t = 800 * cycle * 0.001;
        const double allowed = table.steepest() * rounding(2) * (t + 0.8) + 3 * rounding(6) * table.largest();
        seam.within(probe.equations().inlet_velocity(table.inlet, t) / first, 1, allowed / first,
                    at({{"cycle", double(cycle)}}));
    }
}

void eq25_profile(Probe& probe)
{
    Quantity& plug =
        probe.quantity("a plug's velocity over the mean [1]", Source::exact, "1: nothing is computed");
    Quantity& parabola = probe.quantity(
        "the parabola against Poiseuille's flow over half its crest [1]", Source::rounding,
        "gamma_6 of 2 and of 2 r^2/R^2: two products, a quotient, a difference, and the rounding of "
        "r^2; the oracle's bounds");
    Quantity& mean = probe.quantity("mean over the section over the mean [1]", Source::quadrature,
                                    "28 u of the Gauss rule's terms; 2 gamma_6 of a velocity below 2");
    Quantity& outside = probe.quantity("the parabola on the axis and beyond the wall [1]", Source::exact,
                                       "2 and 0: sums and products of whole numbers");
    const auto profile = probe.equations().inlet_profile;
    Arguments a(252);
    for (int n = 0; n < 20; ++n) {
        const double R = a.between(0.1, 2);
        const analytic::Duct pipe{analytic::Section::pipe, R, 3.3e-6};
        const analytic::Drive drive{1.7, 0};
        const Estimate crest = analytic::developed_velocity(pipe, drive, 0, 0);
        for (int k = 0; k < 10; ++k) {
            const double r = a.between(0, R);
            const std::string where = at({{"R", R}, {"r/R", r / R}});
            const Estimate u = analytic::developed_velocity(pipe, drive, r, 0);
            const double expected = 2 * u.value / crest.value;
            const double oracle =
                (2 * u.error + expected * crest.error) / crest.value + rounding(2) * expected;
            parabola.within(profile(InletProfile::parabolic, r * r, R), expected,
                            rounding(6) * (2 + 2 * r * r / (R * R)) + oracle, where);
            plug.within(profile(InletProfile::plug, r * r, R), 1, 0, where);
            outside.within(profile(InletProfile::parabolic, (R + r) * (R + r) * 1.01, R), 0, 0, where);
        }
        outside.within(profile(InletProfile::parabolic, 0, R), 2, 0, at({{"R", R}}) + ", axis");
        for (const InletProfile shape : {InletProfile::plug, InletProfile::parabolic}) {
            const Estimate flow = analytic::integrate_polynomial(
                [&](double r) { return 2 * r / (R * R) * profile(shape, r * r, R); }, 0, R);
            mean.within(flow.value, 1, flow.error + 2 * rounding(6) * 2, at({{"R", R}}));
        }
    }
}

void eq25_ramp(Probe& probe)
{
    Quantity& bell =
        probe.quantity("the ramp against int 6 x (1 - x) dx [1]", Source::quadrature,
                       "28 u of the Gauss rule's terms; u of t/T, where the slope is 3/2 at most, and "
                       "gamma_4 of 3 s^2 for three products and a difference");
    Quantity& ends = probe.quantity("the ramp before its start, at its end and beyond, and without one [1]",
                                    Source::exact, "0 or 1: nothing is rounded");
    const auto ramp = probe.equations().inlet_ramp;
    Arguments a(253);
    for (int n = 0; n < 200; ++n) {
        const double T = a.between(0.01, 2);
        const double t = a.between(0, T);
        const std::string where = at({{"T", T}, {"t/T", t / T}});
        const double s = t / T;
        const Estimate expected =
            analytic::integrate_polynomial([](double x) { return 6 * x * (1 - x); }, 0, s);
        bell.within(ramp(T, t), expected.value,
                    expected.error + rounding(2) * 1.5 * s + rounding(4) * 3 * s * s, where);
        ends.within(ramp(T, -t), 0, 0, where);
        ends.within(ramp(T, 0), 0, 0, where);
        ends.within(ramp(T, T), 1, 0, where);
        ends.within(ramp(T, T + t), 1, 0, where);
        ends.within(ramp(0, t), 1, 0, where);
        ends.within(ramp(0, -t), 1, 0, where);
    }
}

} // namespace

std::vector<Check> boundary_inlet_checks()
{
    return {
        formula_check("eq25_waveforms", {"25"},
                      "the inlet's velocity follows the sine as printed, and each other formula",
                      {"GSL's sine", "50 digits"}, eq25_waveforms),
        formula_check("eq25_transport", {"25"},
                      "each waveform transports what it must in a cycle; the sine as printed nothing",
                      {"GSL quadrature against exact integrals", "zeros and extremes"}, eq25_transport),
        formula_check("eq25_table", {"25"},
                      "a table is periodic and piecewise linear, at its entries and at its seam",
                      {"GSL's interpolation", "sum of hats, 50 digits"}, eq25_table),
        formula_check("eq25_table_seam", {"25"},
                      "a table goes on where rounding puts the end of a cycle before or behind it",
                      {"the first entry", "construction"}, eq25_table_seam),
        formula_check(
            "eq25_profile", {"25"},
            "over the inlet the velocity is the same everywhere, or a developed flow's, with one mean",
            {"Poiseuille's parabola", "Gauss rule over the section"}, eq25_profile),
        formula_check("eq25_ramp", {"25"}, "a start lets the velocity rise from 0 without a kink",
                      {"Gauss rule over the ramp's slope", "its ends"}, eq25_ramp),
    };
}

} // namespace aneurysm::checks
