// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/report.hpp"

#include "output/columns.hpp"
#include "output/json.hpp"
#include "output/provenance.hpp"

#include <iomanip>
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

std::string table(const ComparisonResult& result)
{
    std::size_t width = 0;
    for (const FieldResult& f : result.fields) {
        width = std::max(width, f.worst.name.size());
    }
    std::ostringstream text;
    text << std::left << std::setw(static_cast<int>(width)) << "field" << std::right << std::setw(11)
         << "compared" << std::setw(10) << "particle" << std::setw(8) << "frame" << std::setw(12)
         << "measured" << std::setw(12) << "allowed" << std::setw(18) << "measured/allowed"
         << "  verdict\n";
    for (const FieldResult& f : result.fields) {
        const FieldCheck& w = f.worst;
        text << std::left << std::setw(static_cast<int>(width)) << w.name << std::right << std::setw(11)
             << w.compared << std::setw(10) << (w.particle < 0 ? "-" : std::to_string(w.particle))
             << std::setw(8) << f.frame << std::setprecision(3) << std::setw(12) << w.measured
             << std::setw(12) << w.allowed << std::setw(18) << w.ratio << "  " << verdict(f);
        if (w.failed > 0) {
            text << " (" << w.failed << " times)";
        }
        text << "\n";
    }
    return text.str();
}

output::Json fields_json(const ComparisonResult& result)
{
    output::Json fields = output::Json::array();
    for (const FieldResult& f : result.fields) {
        output::Json ratios = output::Json::array();
        for (const double r : f.ratios) {
            ratios.push_back(output::json_number(r));
        }
        fields.push_back({{"name", f.worst.name},
                          {"compared", f.worst.compared},
                          {"failed", f.worst.failed},
                          {"worst_particle", f.worst.particle},
                          {"worst_frame", f.frame},
                          {"measured", output::json_number(f.worst.measured)},
                          {"allowed", output::json_number(f.worst.allowed)},
                          {"ratio", output::json_number(f.worst.ratio)},
                          {"verdict", verdict(f)},
                          {"worst_ratio_by_frame", ratios}});
    }
    return fields;
}

} // namespace

std::string report_text(const ComparisonTitle& title, const ComparisonResult& result)
{
    std::ostringstream text;
    text << title.mode << ": " << title.candidate.name << " (" << title.candidate.precision << ", "
         << title.device << ") against the reference, scenario " << title.scenario << "\n";
    if (!result.fields.empty()) {
        text << table(result);
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
    json["backend"] = title.candidate.name;
    json["precision"] = title.candidate.precision;
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
    json["fields"] = fields_json(result);
    return output::json_text(json);
}

} // namespace aneurysm::comparison
