// SPDX-License-Identifier: Apache-2.0
// What all reports of a study count.
#include "common/equations.hpp"
#include "verification/sensitivity/report.hpp"
#include "verification/suite/summary.hpp"

#include <algorithm>
#include <map>

namespace aneurysm::sensitivity
{

void MutantTally::add(const MutantRow& row)
{
    ++planted;
    found += row.survives() ? 0 : 1;
    argued += row.survives() && !row.argument.empty() ? 1 : 0;
}

std::vector<MutantTally> tallies(const SensitivityStudy& study)
{
    std::map<std::string, MutantTally> by_id;
    MutantTally all{.equation = "all"};
    for (const MutantRow& row : study.rows) {
        by_id[equation_of(row.mutant.place)].add(row);
        all.add(row);
    }
    std::vector<MutantTally> result;
    const auto take = [&](const std::string& id, const std::string& name, std::string_view title) {
        if (const auto found = by_id.find(id); found != by_id.end()) {
            result.push_back(found->second);
            result.back().equation = name;
            result.back().title = title;
        }
    };
    for (const Equation& equation : equations) {
        take(std::string(equation.id), suite::number_of(equation), equation.title);
    }
    take("Fig. 1", "Fig. 1", "collision with the wall");
    take("3.4", "3.4", "particle controller");
    result.push_back(all);
    return result;
}

MutantTally tally(const SensitivityStudy& study, Side side)
{
    MutantTally result{.equation = name_of(side)};
    for (const MutantRow& row : study.rows) {
        if (row.mutant.side == side) {
            result.add(row);
        }
    }
    return result;
}

std::vector<const MutantRow*> survivors(const SensitivityStudy& study)
{
    std::vector<const MutantRow*> rows;
    for (const MutantRow& row : study.rows) {
        if (row.survives()) {
            rows.push_back(&row);
        }
    }
    return rows;
}

std::vector<const Sight*> blind(const SensitivityStudy& study)
{
    std::vector<const Sight*> all;
    for (const Sight& sight : study.sights) {
        if (!sight.sees) {
            all.push_back(&sight);
        }
    }
    return all;
}

std::vector<Unusable> unusable(const SensitivityStudy& study)
{
    std::vector<Unusable> all;
    for (const BaselineCase& c : study.baseline) {
        if (c.result.verdict == suite::Verdict::holds) {
            continue;
        }
        const auto known = std::ranges::find(all, c.result.message, &Unusable::why);
        if (known == all.end()) {
            all.push_back({c.what.name(), c.result.message});
        } else {
            known->cases.append(", ").append(c.what.name());
        }
    }
    return all;
}

std::vector<const suite::Check*> without_backend(const SensitivityStudy& study)
{
    std::vector<const suite::Check*> checks;
    for (const suite::Check* check : study.checks) {
        const bool computes = std::ranges::any_of(study.baseline, [&](const BaselineCase& c) {
            return c.what.check == check && (c.result.verdict != suite::Verdict::holds ||
                                             c.result.reached[0].any() || c.result.reached[1].any());
        });
        if (!computes) {
            checks.push_back(check);
        }
    }
    return checks;
}

std::vector<SightPair> sight_pairs(const SensitivityStudy& study)
{
    std::vector<SightPair> pairs;
    for (const Sight& sight : study.sights) {
        if (pairs.empty() || pairs.back().check != sight.check) {
            pairs.push_back({.check = sight.check});
        }
        (sight.side == Side::reference ? pairs.back().reference : pairs.back().device) = &sight;
    }
    return pairs;
}

std::string verdict_of(const SensitivityStudy& study)
{
    return !study.complete ? "INCOMPLETE" : passed(study) ? "PASS" : "FAIL";
}

std::string headline(const SensitivityStudy& study)
{
    const MutantTally all = tallies(study).back();
    const auto count = [](int n, const std::string& what) { return std::to_string(n).append(what); };
    std::string text = count(all.planted, " faults planted, one at a time: ") +
                       count(tally(study, Side::reference).planted, " in the reference, ") +
                       count(tally(study, Side::device).planted, " in cpu. ") +
                       count(all.found, " turned a check red");
    if (all.argued > 0) {
        text += count(all.argued, " can't, for a reason given").insert(0, ", ");
    }
    if (all.unexplained() > 0) {
        text += count(all.unexplained(), " went unnoticed").insert(0, ", ");
    }
    return text.append(".");
}

std::string smallest_of(const Sight* sight)
{
    if (sight == nullptr) {
        return "-";
    }
    return sight->smallest > 0
               ? suite::shown(sight->smallest).append(" (").append(places.at(sight->place).name).append(")")
           : sight->sees ? "none of its own"
                         : "blind";
}

} // namespace aneurysm::sensitivity
