// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/summary.hpp"

#include <algorithm>
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

/// A further one for the same reason, or a new one.
void add(std::vector<Reason>& reasons, const std::string& who, const std::string& why)
{
    if (!reasons.empty() && reasons.back().why == why) {
        reasons.back().who.append(", ").append(who);
    } else {
        reasons.push_back({who, why});
    }
}

/// Of each check the subjects with such a verdict; those that aren't there were not run anyway.
std::vector<Reason> reasons(const SuiteResult& suite, Verdict verdict)
{
    const auto is_missing = [&](const std::string& name) {
        return std::ranges::any_of(suite.subjects, [&](const SuiteSubject& s) {
            return !s.missing.empty() && s.subject.name() == name;
        });
    };
    std::vector<Reason> all;
    for (auto r = suite.results.begin(); r != suite.results.end();) {
        const Check* check = r->check;
        std::vector<Reason> own;
        for (; r != suite.results.end() && r->check == check; ++r) {
            if (r->verdict == verdict && !is_missing(r->subject)) {
                add(own, r->subject, r->message);
            }
        }
        for (const Reason& reason : own) {
            add(all, std::string(check->id) + " (" + reason.who + ")", reason.why);
        }
    }
    return all;
}

} // namespace

std::string number_of(const Equation& equation)
{
    const std::string id(equation.id);
    return id == "EOS" ? id : "(" + id + ")";
}

void Tally::add(const CheckResult& result)
{
    holds += result.verdict == Verdict::holds ? 1 : 0;
    fails += result.verdict == Verdict::fails ? 1 : 0;
    not_run += result.verdict == Verdict::not_run ? 1 : 0;
    for (const Quantity& q : result.quantities) {
        compared += q.compared();
        const Quantity::Worst& w = q.worst();
        if (w.ratio > ratio) {
            ratio = w.ratio;
            closest = &q;
            where = &result;
        }
    }
}

Tally tally(const CheckResult& result)
{
    Tally t;
    t.add(result);
    return t;
}

Tally tally(const SuiteResult& suite)
{
    Tally t;
    for (const CheckResult& r : suite.results) {
        t.add(r);
    }
    return t;
}

Tally tally(const SuiteResult& suite, Level level)
{
    Tally t;
    for (const CheckResult& r : suite.results) {
        if (r.check->level == level) {
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

double median_ratio(const SuiteResult& suite, Level level)
{
    std::vector<double> ratios;
    for (const CheckResult& r : suite.results) {
        for (const Quantity& q : r.quantities) {
            if (r.check->level == level && q.compared() > 0) {
                ratios.push_back(q.worst().ratio);
            }
        }
    }
    if (ratios.empty()) {
        return -1;
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>((ratios.size() - 1) / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
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

std::vector<Reason> failures(const SuiteResult& suite)
{
    return reasons(suite, Verdict::fails);
}

std::vector<Reason> not_run(const SuiteResult& suite)
{
    std::vector<Reason> all;
    for (const SuiteSubject& s : suite.subjects) {
        if (!s.missing.empty()) {
            add(all, s.subject.name(), s.missing);
        }
    }
    const std::vector<Reason> checks = reasons(suite, Verdict::not_run);
    all.insert(all.end(), checks.begin(), checks.end());
    return all;
}

std::vector<Failure> what_fails(const SuiteResult& suite)
{
    std::vector<Failure> all;
    const auto add = [&](const CheckResult& r, const Quantity* q) {
        const auto known = std::ranges::find_if(all, [&](const Failure& f) {
            const bool same = q == nullptr ? f.quantity == nullptr && f.where->message == r.message
                                           : f.quantity != nullptr && f.quantity->name() == q->name();
            return f.where->check == r.check && same;
        });
        Failure& f = known == all.end() ? all.emplace_back(Failure{&r, q}) : *known;
        f.subjects.push_back(r.subject);
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
        if (r.verdict == Verdict::fails && std::ranges::none_of(r.quantities, is_red)) {
            add(r, nullptr);
        }
    }
    std::ranges::stable_sort(all, {}, [](const Failure& f) { return f.where->check->level; });
    return all;
}

bool passed(const SuiteResult& suite)
{
    const Tally t = tally(suite);
    return suite.complete && t.fails == 0 && t.holds > 0;
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
