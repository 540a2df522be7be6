// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/summary.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace aneurysm::suite
{
namespace
{

bool names(const Check& check, const Equation& equation)
{
    return std::ranges::find(check.equations, equation.id) != check.equations.end();
}

/// Of the results that look at an equation.
EquationCell cell_of(const std::vector<const CheckResult*>& results, const std::string& subject)
{
    EquationCell cell;
    Tally evidence;
    for (const CheckResult* r : results) {
        if (r->subject == subject) {
            cell.tally.add(*r);
            if (is_evidence(*r->check)) {
                evidence.add(*r);
            }
            cell.remark = r->verdict == Verdict::not_run ? r->message : cell.remark;
        }
    }
    const Tally& t = cell.tally;
    using State = EquationCell::State;
    cell.state = t.fails > 0          ? State::fails
                 : evidence.holds > 0 ? State::holds
                 : t.holds > 0        ? State::equal
                 : t.not_run > 0      ? State::not_run
                                      : State::none;
    return cell;
}

/// Optimized subjects without formulas of their own share those of the one that has them.
void share(std::vector<EquationCell>& cells, const std::vector<SuiteSubject>& subjects)
{
    const auto is_optimized = [](const SuiteSubject& s) {
        return s.subject.choice.backend != Backend::reference;
    };
    for (std::size_t owner = 0; owner < subjects.size(); ++owner) {
        const bool owns = subjects[owner].subject.equations != nullptr && is_optimized(subjects[owner]);
        if (!owns || cells[owner].state == EquationCell::State::none) {
            continue;
        }
        for (std::size_t k = 0; k < subjects.size(); ++k) {
            const EquationCell::State state = cells[k].state;
            if ((state == EquationCell::State::none || state == EquationCell::State::equal) &&
                is_optimized(subjects[k])) {
                const bool here = subjects[k].missing.empty();
                cells[k].state = here ? EquationCell::State::shared : EquationCell::State::not_run;
                cells[k].remark = here ? "as " + subjects[owner].subject.name() : subjects[k].missing;
            }
        }
    }
}

void judge(EquationSummary& e, const std::vector<const CheckResult*>& results)
{
    const auto any = [&](Verdict v) {
        return std::ranges::any_of(results, [v](const CheckResult* r) { return r->verdict == v; });
    };
    const bool held = std::ranges::any_of(
        e.cells, [](const EquationCell& c) { return c.state == EquationCell::State::holds; });
    const bool cut_short =
        std::ranges::any_of(results, [](const CheckResult* r) { return r->message == interruption; });
    if (any(Verdict::fails)) {
        e.verdict = EquationVerdict::fails;
        e.only_shared = std::ranges::none_of(results, [&](const CheckResult* r) {
            return r->verdict == Verdict::fails && is_own(*r->check, *e.equation);
        });
    } else if (std::ranges::none_of(e.checks, [](const Check* c) { return is_evidence(*c); })) {
        e.verdict = EquationVerdict::no_check;
        e.remark = "the suite has no check of it";
    } else if (held && !cut_short) {
        e.verdict = EquationVerdict::holds;
    } else {
        e.verdict = EquationVerdict::not_checked;
        e.remark = cut_short ? interruption : "no check that could show that it holds was run";
    }
}

} // namespace

void Tally::add(const CheckResult& result)
{
    holds += result.verdict == Verdict::holds ? 1 : 0;
    fails += result.verdict == Verdict::fails ? 1 : 0;
    not_run += result.verdict == Verdict::not_run ? 1 : 0;
    limits += result.verdict == Verdict::limit ? 1 : 0;
    for (const Quantity& q : result.quantities) {
        compared += q.compared();
        const double used = q.worst().ratio;
        if (q.compared() > 0) {
            ratios.push_back(used);
        }
        if (used > ratio) {
            std::tie(ratio, closest, where) = std::tuple(used, &q, &result);
        }
    }
}

double Tally::median() const
{
    if (ratios.empty()) {
        return -1;
    }
    std::vector<double> sorted = ratios;
    std::ranges::sort(sorted);
    return sorted[(sorted.size() - 1) / 2];
}

Tally tally(const SuiteResult& suite, std::optional<Level> level)
{
    Tally t;
    for (const CheckResult& r : suite.results) {
        if (!level || r.check->level == level) {
            t.add(r);
        }
    }
    return t;
}

bool is_evidence(const Check& check)
{
    return check.scope != Scope::once && check.level < Level::metamorphic;
}

bool is_own(const Check& check, const Equation& equation)
{
    const std::string id = (equation.id.size() == 1 ? "eq0" : "eq") + std::string(equation.id);
    return check.id.starts_with(id + "_") || (check.equations.size() == 1 && names(check, equation));
}

std::vector<EquationSummary> by_equation(const SuiteResult& suite, const std::vector<Check>& checks)
{
    std::vector<EquationSummary> summaries;
    for (const Equation& equation : equations) {
        EquationSummary e{.equation = &equation};
        for (const Check& check : checks) {
            if (names(check, equation)) {
                e.checks.push_back(&check);
            }
        }
        std::vector<const CheckResult*> results;
        for (const CheckResult& r : suite.results) {
            if (names(*r.check, equation)) {
                results.push_back(&r);
            }
        }
        for (const SuiteSubject& s : suite.subjects) {
            e.cells.push_back(cell_of(results, s.subject.name()));
        }
        share(e.cells, suite.subjects);
        judge(e, results);
        summaries.push_back(std::move(e));
    }
    return summaries;
}

std::vector<Results> by_check(const SuiteResult& suite)
{
    std::vector<Results> all;
    const Results results = suite.results;
    for (std::size_t from = 0, end = 0; from < results.size(); from = end) {
        while (end < results.size() && results[end].check == results[from].check) {
            ++end;
        }
        all.push_back(results.subspan(from, end - from));
    }
    return all;
}

void add(std::vector<Reason>& reasons, const std::string& who, const std::string& why)
{
    const auto known = std::ranges::find(reasons, why, &Reason::why);
    if (known == reasons.end()) {
        reasons.push_back({who, why});
    } else {
        known->who.append(", ").append(who);
    }
}

std::vector<Reason> not_run(const SuiteResult& suite)
{
    std::vector<Reason> all;
    std::set<std::string> missing;
    for (const SuiteSubject& s : suite.subjects) {
        if (!s.missing.empty()) {
            add(all, s.subject.name(), s.missing);
            missing.insert(s.subject.name());
        }
    }
    for (const Results& results : by_check(suite)) {
        std::vector<Reason> own;
        for (const CheckResult& r : results) {
            if (r.verdict == Verdict::not_run && !missing.contains(r.subject)) {
                add(own, r.subject, r.message);
            }
        }
        for (const Reason& reason : own) {
            add(all, std::string(results[0].check->id) + " (" + reason.who + ")", reason.why);
        }
    }
    return all;
}

std::vector<Failure> what_fails(const SuiteResult& suite)
{
    std::vector<Failure> all;
    const auto add = [&](const CheckResult& r, const Quantity* q) {
        const std::string what = q == nullptr ? r.message : q->name();
        const auto known = std::ranges::find_if(
            all, [&](const Failure& f) { return f.where->check == r.check && f.what == what; });
        Failure& f = known == all.end() ? all.emplace_back(Failure{&r, q, what}) : *known;
        f.subjects.append(f.subjects.empty() ? "" : ", ").append(r.subject);
        if (q != nullptr && q->worst().ratio > f.quantity->worst().ratio) {
            std::tie(f.where, f.quantity) = std::tuple(&r, q);
        }
    };
    for (const CheckResult& r : suite.results) {
        const auto is_red = [](const Quantity& q) { return q.compared() > 0 && q.failed() > 0; };
        for (const Quantity& q : r.quantities) {
            if (is_red(q)) {
                add(r, &q);
            }
        }
        const bool stopped = r.message.starts_with("stopped: ");
        if (r.verdict == Verdict::fails && (stopped || std::ranges::none_of(r.quantities, is_red))) {
            add(r, nullptr);
        }
    }
    std::ranges::stable_sort(all, {}, [](const Failure& f) { return f.where->check->level; });
    return all;
}

bool passed(const SuiteResult& suite)
{
    const Tally t = tally(suite);
    return suite.complete && t.fails == 0 && t.holds + t.limits > 0;
}

std::string headline(const std::vector<EquationSummary>& summaries)
{
    const auto count = [&](EquationVerdict v) {
        return std::ranges::count(summaries, v, &EquationSummary::verdict);
    };
    std::string text = std::to_string(count(EquationVerdict::holds)) + " of " +
                       std::to_string(summaries.size()) + " equations hold";
    for (const EquationVerdict v :
         {EquationVerdict::fails, EquationVerdict::not_checked, EquationVerdict::no_check}) {
        if (count(v) == 0) {
            continue;
        }
        text.append("; ").append(name_of(v)).append(":");
        for (const EquationSummary& e : summaries) {
            if (e.verdict == v) {
                text.append(" ").append(number_of(*e.equation));
            }
        }
    }
    return text;
}

} // namespace aneurysm::suite
