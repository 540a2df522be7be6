// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/report.hpp"

#include "output/columns.hpp"
#include "output/json.hpp"
#include "output/provenance.hpp"
#include "output/report/markdown.hpp"
#include "output/report/numbers.hpp"

#include <sstream>

namespace aneurysm::comparison
{
namespace
{

std::string verdict(const FieldResult& field)
{
    if (field.worst.compared == 0) {
        return "NOTHING COMPARED";
    }
    return field.worst.failed == 0 ? "pass" : "FAIL";
}

std::string phases_text(const ComparisonResult& result)
{
    std::string text;
    for (const auto& [phase, count] : result.phases) {
        text +=
            (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(output::name_of(phase));
    }
    return text.empty() ? "none" : text;
}

report::Table table(const ComparisonResult& result)
{
    using report::number;
    report::Table table{{"field", number("compared"), number("particle"), number("frame"), number("measured"),
                         number("allowed"), number("measured/allowed"), "verdict"}};
    for (const FieldResult& f : result.fields) {
        const FieldCheck& w = f.worst;
        const std::string times = w.failed > 0 ? " (" + std::to_string(w.failed) + " times)" : "";
        table.rows.push_back({w.name, std::to_string(w.compared),
                              w.particle < 0 ? "-" : std::to_string(w.particle), std::to_string(f.frame),
                              report::shown(w.measured), report::shown(w.allowed), report::shown(w.ratio),
                              verdict(f) + times});
    }
    return table;
}

output::Json to_json(const FieldResult& f)
{
    return {{"name", f.worst.name},
            {"compared", f.worst.compared},
            {"failed", f.worst.failed},
            {"worst_particle", f.worst.particle},
            {"worst_frame", f.frame},
            {"measured", output::json_number(f.worst.measured)},
            {"allowed", output::json_number(f.worst.allowed)},
            {"ratio", output::json_number(f.worst.ratio)},
            {"verdict", verdict(f)},
            {"worst_ratio_by_frame", output::json_array(f.ratios, output::json_number)}};
}

} // namespace

std::string report_text(const ComparisonTitle& title, const ComparisonResult& result)
{
    std::ostringstream text;
    text << title.mode << ": " << name_of(title.candidate.backend) << " ("
         << name_of(title.candidate.precision) << ", " << title.device << ") against the reference, scenario "
         << title.scenario << "\n";
    if (!result.fields.empty()) {
        text << report::text(table(result));
    }
    text << "frames     " << result.frames.size();
    if (!result.frames.empty()) {
        text << " (" << result.frames.front() << " to " << result.frames.back()
             << "): " << phases_text(result);
    }
    text << "\n";
    if (result.particles > 0) {
        text << "undecided  by rounding: " << result.open_particles << " of " << result.particles
             << " particles, whose bounds cover both outcomes; " << result.open_frames.size()
             << " frames left out, or in part\n";
    }
    for (const std::string& note : result.notes) {
        text << "note       " << note << "\n";
    }
    for (const std::string& problem : result.problems) {
        text << "PROBLEM    " << problem << "\n";
    }
    text << (result.passed() ? "PASS" : "FAIL") << "\n";
    return text.str();
}

std::string report_json(const ComparisonTitle& title, const ComparisonResult& result)
{
    output::Json json = output::provenance();
    json["mode"] = title.mode;
    json["scenario"] = title.scenario;
    json["scenario_hash"] = title.scenario_hash;
    json["backend"] = name_of(title.candidate.backend);
    json["precision"] = name_of(title.candidate.precision);
    json["threads"] = title.candidate.threads;
    json["block_size"] = title.candidate.block_size;
    json["device"] = title.device;
    json["passed"] = result.passed();
    json["frames"] = result.frames;
    json["phases"] = output::Json::object();
    for (const auto& [phase, count] : result.phases) {
        json["phases"][std::string(output::name_of(phase))] = count;
    }
    json["undecided_particles"] = result.open_particles;
    json["particles"] = result.particles;
    json["undecided_frames"] = result.open_frames;
    json["problems"] = result.problems;
    json["notes"] = result.notes;
    json["fields"] = output::json_array(result.fields, [](const FieldResult& f) { return to_json(f); });
    return output::json_text(json);
}

} // namespace aneurysm::comparison
