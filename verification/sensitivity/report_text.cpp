// SPDX-License-Identifier: Apache-2.0
// What `aneurysm verify --sensitivity` prints, and the same with all mutants as Markdown.
#include "output/build_info.hpp"
#include "verification/sensitivity/report.hpp"

#include <iomanip>
#include <sstream>

namespace aneurysm::sensitivity
{
namespace
{

std::string reason(std::string_view argument)
{
    return argument.empty() ? "UNEXPLAINED" : std::string(argument);
}

/// What needs a reader's attention; the same in both forms.
std::string remarks(const SensitivityStudy& study, const std::string& heading)
{
    std::ostringstream text;
    const auto head = [&](bool needed, const std::string& title) {
        if (needed) {
            text << "\n" << heading << title << "\n\n";
        }
    };
    head(!unusable(study).empty(), "Left out: red, or not run, without any fault");
    for (const Unusable& u : unusable(study)) {
        text << "- " << u.cases << ": " << u.why << "\n";
    }
    head(!survivors(study).empty(), "Faults that no check finds");
    for (const MutantRow* row : survivors(study)) {
        text << "- " << name_of(row->mutant) << " (" << words_of(row->mutant)
             << "): " << reason(row->argument) << "\n";
    }
    head(!blind(study).empty(), "Checks that no fault turns red");
    for (const Sight* sight : blind(study)) {
        text << "- " << sight->check->id << ", " << name_of(sight->side) << ": " << reason(sight->argument)
             << "\n";
    }
    const std::vector<const suite::Check*> oracles = without_backend(study);
    head(!oracles.empty(), "Checks of the oracles alone: there is nothing of a backend to plant a fault in");
    for (const suite::Check* check : oracles) {
        text << "- " << check->id << "\n";
    }
    return text.str();
}

} // namespace

std::string sensitivity_text(const SensitivityReport& report)
{
    const SensitivityStudy& study = report.study;
    std::ostringstream text;
    text << "Sensitivity of the verification suite: " << verdict_of(study) << "\n"
         << report.selection << ".\n"
         << headline(study) << "\n\n"
         << std::left << std::setw(10) << "equation" << std::right << std::setw(8) << "planted"
         << std::setw(8) << "found" << std::setw(8) << "argued" << std::setw(13) << "unexplained"
         << "\n";
    for (const MutantTally& t : tallies(study)) {
        text << std::left << std::setw(10) << t.equation << std::right << std::setw(8) << t.planted
             << std::setw(8) << t.found << std::setw(8) << t.argued << std::setw(13) << t.unexplained()
             << "\n";
    }
    if (!study.sights.empty()) {
        text << "\nSmallest relative fault in a coefficient that turns a check red, and where\n\n"
             << std::left << std::setw(30) << "check" << std::setw(34) << "reference"
             << "cpu\n";
        for (const SightPair& pair : sight_pairs(study)) {
            text << std::setw(30) << pair.check->id << std::setw(34) << smallest_of(pair.reference)
                 << smallest_of(pair.device) << "\n";
        }
    }
    text << remarks(study, "") << "\n" << std::fixed << std::setprecision(0) << study.seconds << " s\n";
    return text.str();
}

std::string sensitivity_markdown(const SensitivityReport& report)
{
    const SensitivityStudy& study = report.study;
    std::ostringstream text;
    text << "# Sensitivity of the verification suite: " << verdict_of(study) << "\n\n"
         << headline(study) << "\n\n"
         << report.selection << ". Version " << output::build_info().version << ", " << report.date << ", "
         << report.machine << ", " << report.jobs << " processes, " << std::fixed << std::setprecision(0)
         << study.seconds << " s. Repeat it with `" << report.command << "`.\n\n"
         << "| equation | title | planted | found | argued | unexplained |\n|---|---|--:|--:|--:|--:|\n";
    for (const MutantTally& t : tallies(study)) {
        text << "| " << t.equation << " | " << t.title << " | " << t.planted << " | " << t.found << " | "
             << t.argued << " | " << t.unexplained() << " |\n";
    }
    if (!study.sights.empty()) {
        text << "\n## Smallest relative fault in a coefficient that turns a check red\n\n"
             << "| check | reference | cpu |\n|---|---|---|\n";
        for (const SightPair& pair : sight_pairs(study)) {
            text << "| " << pair.check->id << " | " << smallest_of(pair.reference) << " | "
                 << smallest_of(pair.device) << " |\n";
        }
    }
    text << remarks(study, "## ") << "\n## All faults\n\n| fault | what | first found by |\n|---|---|---|\n";
    for (const MutantRow& row : study.rows) {
        text << "| " << name_of(row.mutant) << " | " << words_of(row.mutant) << " | "
             << (row.survives() ? "-" : row.finder) << " |\n";
    }
    return text.str();
}

} // namespace aneurysm::sensitivity
