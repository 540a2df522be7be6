// SPDX-License-Identifier: Apache-2.0
#include "app/info.hpp"

#include "app/cite.hpp"
#include "app/notes.hpp"
#include "app/options.hpp"
#include "common/equations.hpp"
#include "common/scenario/limits.hpp"
#include "common/scenario/shipped.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"
#include "reference/bifurcation.hpp"
#include "reference/rupture.hpp"
#include "verification/suite/subjects.hpp"
#include "verification/suite/summary.hpp"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>
#include <sstream>
#include <vector>

namespace aneurysm::app
{
namespace
{

/// Lines "name   value unit".
class Lines
{
public:
    Lines() { text_ << std::setprecision(4); }
    template <class Value>
    Lines& add(const std::string& name, const Value& value, const std::string& unit = "")
    {
        text_ << "  " << std::left << std::setw(50) << name << value << (unit.empty() ? "" : " ") << unit
              << "\n";
        return *this;
    }
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

std::string flow_info(const Scenario& s)
{
    const double dx = estimated_spacing(s);
    const double v_0 = largest_inlet_velocity(s);
    const double r_0 = s.vessel.radius_m;
    const double rho_0 = s.fluid.density_kg_m3;
    const double step = s.time.frame_s / static_cast<double>(s.time.substeps);
    const StepLimits limits = step_limits(s, estimated_spacing(s));
    const double path = (s.vessel.parent_length_radii + s.vessel.daughter_length_radii) * r_0;
    Lines lines;
    lines.add("particle spacing dx, about", dx, "m")
        .add("particle mass, about", rho_0 * dx * dx * dx, "kg")
        .add("spacings that the inlet moves in a step", largest_inlet_speed(s) * step / dx)
        .add("step", step, "s")
        .add("  its limit by convection, about", limits.convective, "s")
        .add("  its limit by viscosity, about", limits.viscous, "s");
    if (s.pressure.model == PressureModel::eos) {
        lines.add("  its limit by sound, about", limits.acoustic, "s");
    }
    if (s.domain.form != DomainForm::artery) {
        return lines.text();
    }
    lines.add("particle spacings across the parent", 2 * r_0 / dx)
        .add("radius of the daughters, (24)", reference::daughter_radius(r_0), "m")
        .add("Reynolds number rho_0 v_0 2 r_0 / mu", rho_0 * v_0 * 2 * r_0 / s.fluid.viscosity_pa_s)
        .add("largest level of the pressure, p_const", s.outlet.pressure_pa, "Pa")
        .add("  that of decelerating blood, rho L 2 pi v_0/T",
             rho_0 * path * 2 * std::numbers::pi * v_0 / s.inlet.cycle_s, "Pa");
    return lines.text();
}

std::string wall_info(const Scenario& s)
{
    if (s.aneurysm.shape == SacShape::none) {
        return "";
    }
    const auto& r = s.rupture;
    const double r_0 = s.vessel.radius_m;
    const double h_0 = r.thickness_ratio * r_0;
    const double R_0 = s.aneurysm.initial_radius_radii * r_0;
    const double R_max = s.aneurysm.base_width_radii / 2 * r_0;
    const double h_max = h_0 * std::pow(R_max / R_0, -r.poisson_ratio);
    const double omega = std::sqrt(s.elastic_wall.stiffness_n_m / s.elastic_wall.mass_kg);
    Lines lines;
    lines.add("radius R of the aneurysm in frame 0", R_0, "m")
        .add("  fully developed", R_max, "m")
        .add("thickness h of its wall in frame 0", h_0, "m")
        .add("  fully developed, by the integral of (9)", h_max, "m")
        .add("critical pressure P_c in frame 0, (13)",
             reference::critical_pressure(h_0, R_0, r.yield_limit_pa, r.poisson_ratio, r.porosity), "Pa")
        .add("  fully developed",
             reference::critical_pressure(h_max, R_max, r.yield_limit_pa, r.poisson_ratio, r.porosity), "Pa")
        .add("period of the elastic wall, (28)", 2 * std::numbers::pi / omega, "s");
    return lines.text();
}

/// The program's version and how it was built.
std::string program_info()
{
    const output::BuildInfo build = output::build_info();
    std::ostringstream text;
    text << "aneurysm " << build.version << "\n"
         << "  commit    " << build.commit << "\n"
         << "  compiler  " << build.compiler << "\n"
         << "  flags     " << build.flags << "\n"
         << "  backends  ";
    std::vector<std::string> present;
    std::string missing;
    for (const suite::SuiteSubject& s : suite::make_subjects()) {
        const backends::BackendChoice& choice = s.subject.choice;
        const std::string name = name_of(choice.backend) + " (" + name_of(choice.precision) + ")";
        if (s.missing.empty()) {
            present.push_back(name + (choice.backend == Backend::cuda ? " on " + s.device : ""));
        } else if (missing.find(s.missing) == std::string::npos) { // once, for both precisions
            missing += "            not " + name_of(choice.backend) + ": " + s.missing + "\n";
        }
    }
    text << joined(present, ", ") << "\n" << missing;
    return text.str();
}

/// Every equation of the paper with its status, its use and its deviation.
std::string equation_table()
{
    std::ostringstream text;
    for (const Equation& e : equations) {
        text << "  " << std::left << std::setw(5) << e.id << std::setw(5) << e.section << std::setw(15)
             << suite::name_of(e.status) << std::setw(14) << suite::name_of(e.use) << e.title << "  ["
             << e.function << "]\n";
        if (!e.deviation.empty()) {
            text << std::string(41, ' ') << e.deviation << "\n";
        }
    }
    return text.str();
}

/// What follows from a scenario's values, and which of them are assumed.
std::string scenario_info(const Scenario& scenario)
{
    std::ostringstream text;
    text << scenario.name << ": " << scenario.description << "\n"
         << "  hash " << scenario_hash(scenario) << "\n"
         << flow_info(scenario) << wall_info(scenario) << "Other than the paper's, or not given by it:\n";
    for (const auto& [path, why] : scenario.assumed) {
        text << "  " << path << ": " << why << "\n";
    }
    const std::string note = note_before_run(scenario);
    return text.str() + (note.empty() ? "" : "Note: " + note + "\n");
}

} // namespace

void add_info(CLI::App& app, std::optional<int>& code)
{
    struct InfoOptions {
        std::filesystem::path scenario;
        bool schema = false;
        bool cite = false;
        bool data = false;
    };
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* info =
        app.add_subcommand("info", "Show version and equations, or what follows from a scenario");
    CLI::Option* scenario = add_input(*info, "SCENARIO", options->scenario, "scenario file");
    CLI::Option* schema =
        info->add_flag("--schema", options->schema, "print the JSON Schema of scenario files")
            ->excludes(scenario);
    CLI::Option* cite = info->add_flag("--cite", options->cite, "print what to cite, as text and BibTeX")
                            ->excludes(scenario)
                            ->excludes(schema);
    info->add_flag("--data", options->data, "print the folder of the shipped scenarios and records")
        ->excludes(scenario)
        ->excludes(schema)
        ->excludes(cite);
    info->footer("Examples:\n"
                 "  aneurysm info\n"
                 "  aneurysm info data/scenarios/paper_tc1.json\n"
                 "  aneurysm info --cite");
    info->callback([options, &code] {
        if (options->cite) {
            std::cout << citation();
        } else if (options->schema) {
            std::cout << scenario_schema();
        } else if (options->data) {
            std::cout << data_directory().string() << "\n";
        } else if (options->scenario.empty()) {
            std::cout << program_info() << "Equations of the paper: number, section, status, in runs, title\n"
                      << equation_table();
        } else {
            std::cout << scenario_info(read_scenario(options->scenario));
        }
        code = exit_done;
    });
}

} // namespace aneurysm::app
