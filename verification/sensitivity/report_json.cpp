// SPDX-License-Identifier: Apache-2.0
#include "output/json.hpp"
#include "output/provenance.hpp"
#include "verification/sensitivity/report.hpp"

#include <array>

namespace aneurysm::sensitivity
{
namespace
{

output::Json json(const MutantRow& row, const SensitivityStudy& study)
{
    constexpr std::array names{"unreached", "untried", "green", "red"};
    output::Json checks = output::Json::object();
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        if (row.cells[k] != Cell::unreached) {
            checks[std::string(study.checks[k]->id)] = names.at(static_cast<std::size_t>(row.cells[k]));
        }
    }
    return {{"fault", name_of(row.mutant)},
            {"equation", equation_of(row.mutant.place)},
            {"backend", name_of(row.mutant.side)},
            {"what", words_of(row.mutant)},
            {"found_by", row.finder},
            {"message", row.message},
            {"argument", row.argument},
            {"checks", checks}};
}

output::Json json(const Sight& sight)
{
    return {
        {"check", sight.check->id},
        {"backend", name_of(sight.side)},
        {"sees_a_fault", sight.sees},
        {"smallest_coefficient_fault", sight.smallest > 0 ? output::Json(sight.smallest) : output::Json()},
        {"place", sight.smallest > 0 ? output::Json(places.at(sight.place).name) : output::Json()},
        {"argument", sight.argument}};
}

output::Json json(const BaselineCase& c)
{
    constexpr std::array names{"holds", "fails", "not run"}; // by Verdict
    return {{"case", c.what.name()},
            {"verdict", names.at(static_cast<std::size_t>(c.result.verdict))},
            {"message", c.result.message},
            {"cpu_seconds", c.result.seconds}};
}

} // namespace

std::string sensitivity_json(const SensitivityReport& report)
{
    const SensitivityStudy& study = report.study;
    const MutantTally all = tallies(study).back();
    return output::json_text(
        {{"verdict", verdict_of(study)},
         {"planted", all.planted},
         {"found", all.found},
         {"argued", all.argued},
         {"unexplained", all.unexplained()},
         {"fault_size", mutant_size},
         {"selection", report.selection},
         {"command", report.command},
         {"date", report.date},
         {"machine", report.machine},
         {"seconds", study.seconds},
         {"provenance", output::provenance()},
         {"without_faults",
          output::json_array(study.baseline, [](const BaselineCase& c) { return json(c); })},
         {"faults", output::json_array(study.rows, [&](const MutantRow& r) { return json(r, study); })},
         {"checks", output::json_array(study.sights, [](const Sight& s) { return json(s); })}});
}

} // namespace aneurysm::sensitivity
