// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/sensitivity.hpp"

#include "common/parallel.hpp"
#include "common/process/interrupt.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>

namespace aneurysm::sensitivity
{
namespace
{

constexpr double grace_s = 3;    ///< CPU time that any trial may take [s]
constexpr double patience = 3;   ///< and how many times what the case takes without a mutant
constexpr double costly_s = 0.2; ///< a case that takes longer isn't tried with every mutant,
constexpr double dear_s = 1;     ///< and one that takes longer than this only until one is found
constexpr int finest = 52;       ///< the smallest mutant is 2^-52, one unit in the last place
constexpr int coarsest = 0;      ///< and the largest 1

/// Whether mutants of `side` are first looked for with this subject.
bool is_own(const Case& c, Side side)
{
    return c.check->scope == suite::Scope::once ||
           c.subject->name() == (side == Side::reference ? "reference" : "cpu double");
}

bool lists(const suite::Check& check, Place place)
{
    return std::ranges::find(check.equations, equation_of(place)) != check.equations.end();
}

bool reaches(const BaselineCase& c, Side side, Place place)
{
    return c.result.verdict == suite::Verdict::holds &&
           c.result.reached.at(static_cast<std::size_t>(side))[place];
}

bool has_coefficient(Place place)
{
    const Part part = places.at(place).part;
    return part == Part::term || part == Part::vector || part == Part::factor || part == Part::nought;
}

class Study
{
public:
    Study(SensitivityStudy& result, const StudyOptions& options, const AfterStep& after_step)
        : result_(result), options_(options), after_step_(after_step)
    {
    }

    void run()
    {
        share("case", result_.baseline, [](BaselineCase& c, Turn& turn) {
            constexpr double limit_s = 3600;
            c.result = run_trial(c.what, std::nullopt, limit_s, turn);
            return c.what.name();
        });
        share("fault", result_.rows, [this](MutantRow& row, Turn& turn) {
            plant(row, turn);
            return name_of(row.mutant);
        });
        if (!options_.daily) {
            list_sights();
            share("check", result_.sights, [this](Sight& sight, Turn& turn) {
                look(sight, turn);
                return std::string(sight.check->id);
            });
        }
    }

private:
    /// work(item, turn) for each item on several threads, see Turn.
    template <class Item, class Work>
    void share(const std::string& part, std::vector<Item>& items, const Work& work)
    {
        std::int64_t done = 0; // guarded by the turn
        in_parallel(items.size(), options_.jobs, [&](std::size_t k) {
            Turn turn(mutex_);
            if (InterruptWatch::interrupted()) {
                return;
            }
            const std::string last = work(items[k], turn);
            ++done;
            if (after_step_) {
                after_step_(part, done, static_cast<std::int64_t>(items.size()), last);
            }
        });
    }

    static TrialResult tried(const BaselineCase& c, const Mutant& mutant, Turn& turn)
    {
        return run_trial(c.what, mutant, grace_s + patience * c.result.seconds, turn);
    }

    /// The cases that compute with the mutant's place: first those that look at its backend and list its
    /// equation, then the backend's flows, then its others, then other backends' cases that use it, too;
    /// cheap ones first.
    std::vector<const BaselineCase*> cases_for(const Mutant& mutant) const
    {
        const auto rank = [&](const BaselineCase* c) {
            const bool own = is_own(c->what, mutant.side);
            const bool flow = c->what.check->level >= suite::Level::transient;
            const int group = !own ? 3 : lists(*c->what.check, mutant.place) ? 0 : flow ? 1 : 2;
            return std::tuple(group, c->result.seconds);
        };
        std::vector<const BaselineCase*> cases;
        for (const BaselineCase& c : result_.baseline) {
            if (reaches(c, mutant.side, mutant.place)) {
                cases.push_back(&c);
            }
        }
        std::ranges::stable_sort(cases, {}, rank);
        return cases;
    }

    std::size_t column_of(const suite::Check* check) const
    {
        return static_cast<std::size_t>(std::ranges::find(result_.checks, check) - result_.checks.begin());
    }

    /// Whether a full study tries this case, found or not: all that look at the backend and list the
    /// equation, and one flow. Costly ones are tried with one kind of mutant only: those in coefficients,
    /// which are the hardest to see; a metamorphic relation, which holds whatever a coefficient is, with
    /// wrong powers. The dearest have their own turn, see look().
    static bool is_wanted(const BaselineCase& c, const Mutant& mutant, bool flow_tried)
    {
        const bool flow = c.what.check->level >= suite::Level::transient;
        const bool of_equation = lists(*c.what.check, mutant.place) || (flow && !flow_tried);
        const bool relation = c.what.check->level == suite::Level::metamorphic;
        const Kind kind = relation ? Kind::power : Kind::coefficient;
        const bool affordable = c.result.seconds < costly_s || mutant.kind == kind;
        return is_own(c.what, mutant.side) && of_equation && affordable && c.result.seconds < dear_s;
    }

    /// What else computes with the place is tried only as long as nothing has found the mutant.
    void plant(MutantRow& row, Turn& turn)
    {
        row.cells.assign(result_.checks.size(), Cell::unreached);
        bool flow_tried = false;
        for (const BaselineCase* c : cases_for(row.mutant)) {
            Cell& cell = row.cells[column_of(c->what.check)];
            cell = std::max(cell, Cell::untried);
            if (!row.survives() && (options_.daily || !is_wanted(*c, row.mutant, flow_tried))) {
                continue;
            }
            flow_tried = flow_tried || c->what.check->level >= suite::Level::transient;
            const TrialResult result = tried(*c, row.mutant, turn);
            cell = std::max(cell, result.red() ? Cell::red : Cell::green);
            if (result.red() && row.survives()) {
                row.finder = c->what.name();
                row.message = result.message;
            }
        }
        row.argument = argument_for(row.mutant);
    }

    /// The case of a check in which mutants of `side` are looked for; null: there is none.
    const BaselineCase* case_of(const suite::Check* check, Side side) const
    {
        for (const BaselineCase& c : result_.baseline) {
            if (c.what.check == check && is_own(c.what, side) && c.result.verdict == suite::Verdict::holds) {
                return &c;
            }
        }
        return nullptr;
    }

    void list_sights()
    {
        for (const suite::Check* check : result_.checks) {
            for (const Side side : {Side::reference, Side::device}) {
                const BaselineCase* c = case_of(check, side);
                if (c != nullptr && c->result.reached.at(static_cast<std::size_t>(side)).any()) {
                    result_.sights.push_back({check, side});
                }
            }
        }
    }

    void look(Sight& sight, Turn& turn)
    {
        const BaselineCase& c = *case_of(sight.check, sight.side);
        sight.sees =
            std::ranges::any_of(result_.rows, [&](const MutantRow& row) { return is_red(row, sight); });
        std::vector<Place> seen = seen_places(sight); // with a coefficient of an equation of its own
        if (seen.empty() && sight.check->level != suite::Level::metamorphic) {
            seen = first_seen(sight, c, turn);
        }
        sight.sees = sight.sees || !seen.empty();
        if (!sight.sees) {
            look_everywhere(sight, c, turn);
        }
        int finest_red = coarsest - 1;
        for (const Place place : seen) {
            refine(finest_red, sight, c, place, turn);
        }
        sight.argument = argument_for(*sight.check, sight.side);
    }

    bool is_red(const MutantRow& row, const Sight& sight) const
    {
        return row.mutant.side == sight.side && row.cells[column_of(sight.check)] == Cell::red;
    }

    std::vector<Place> seen_places(const Sight& sight) const
    {
        std::vector<Place> seen;
        for (const MutantRow& row : result_.rows) {
            if (is_red(row, sight) && row.mutant.kind == Kind::coefficient &&
                is_own_coefficient(sight, row.mutant.place)) {
                seen.push_back(row.mutant.place);
            }
        }
        return seen;
    }

    static bool is_own_coefficient(const Sight& sight, Place place)
    {
        return has_coefficient(place) && lists(*sight.check, place);
    }

    /// The first place of its own equations where it sees a wrong coefficient.
    static std::vector<Place> first_seen(const Sight& sight, const BaselineCase& c, Turn& turn)
    {
        for (std::size_t k = 0; k < place_count; ++k) {
            const auto place = static_cast<Place>(k);
            const Mutant mutant{place, sight.side, Kind::coefficient, mutant_size};
            if (is_own_coefficient(sight, place) && reaches(c, sight.side, place) &&
                tried(c, mutant, turn).red()) {
                return {place};
            }
        }
        return {};
    }

    /// Values from before, then wrong signs and wrong powers, at all places that the check computes with,
    /// until one turns it red.
    static void look_everywhere(Sight& sight, const BaselineCase& c, Turn& turn)
    {
        for (const Kind kind : {Kind::off_by_one, Kind::sign, Kind::power}) {
            for (std::size_t k = 0; k < place_count && !sight.sees; ++k) {
                const auto place = static_cast<Place>(k);
                if (reaches(c, sight.side, place)) {
                    sight.sees = tried(c, {place, sight.side, kind, mutant_size}, turn).red();
                }
            }
        }
    }

    /// Bisection on 2^0 ... 2^-52, from what another place has reached already.
    static void refine(int& finest_red, Sight& sight, const BaselineCase& c, Place place, Turn& turn)
    {
        const auto is_red = [&](int k) {
            const Mutant mutant{place, sight.side, Kind::coefficient, std::ldexp(1, -k)};
            return tried(c, mutant, turn).red();
        };
        if (finest_red >= finest || !is_red(finest_red + 1)) {
            return;
        }
        ++finest_red;
        int green = finest + 1; // not tried: nothing is finer
        while (green - finest_red > 1) {
            const int middle = (finest_red + green) / 2;
            (is_red(middle) ? finest_red : green) = middle;
        }
        sight.smallest = std::ldexp(1, -finest_red);
        sight.place = place;
    }

    std::mutex mutex_;
    SensitivityStudy& result_;
    const StudyOptions& options_;
    const AfterStep& after_step_;
};

} // namespace

SensitivityStudy run_study(const std::vector<const suite::Check*>& checks,
                           std::vector<suite::SuiteSubject> subjects, const StudyOptions& options,
                           const AfterStep& after_step)
{
    const auto start = std::chrono::steady_clock::now();
    SensitivityStudy study{.checks = checks, .subjects = std::move(subjects)};
    for (const suite::Check* check : checks) {
        if (check->scope == suite::Scope::model) {
            continue; // it judges the model, and takes long
        }
        for (const suite::SuiteSubject* s : suite::subjects_of(*check, study.subjects)) {
            study.baseline.push_back({{check, &s->subject}});
        }
    }
    for (const Mutant& mutant : options.mutants) {
        study.rows.push_back({mutant});
    }
    Study(study, options, after_step).run();
    study.complete = !InterruptWatch::interrupted();
    study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return study;
}

bool passed(const SensitivityStudy& study)
{
    const auto argued = [](const auto& x) { return !x.argument.empty(); };
    return std::ranges::none_of(study.baseline, [](const BaselineCase& c) { return c.result.red(); }) &&
           std::ranges::all_of(study.rows,
                               [&](const MutantRow& row) { return !row.survives() || argued(row); }) &&
           std::ranges::all_of(study.sights, [&](const Sight& s) { return s.sees || argued(s); });
}

} // namespace aneurysm::sensitivity
