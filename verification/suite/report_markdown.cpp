// SPDX-License-Identifier: Apache-2.0
// What `aneurysm verify` prints, and the same with more tables as Markdown.
#include "output/build_info.hpp"
#include "verification/suite/report.hpp"

#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace aneurysm::suite
{
namespace
{

std::string verdict_of(const SuiteResult& suite)
{
    return !suite.complete           ? "INCOMPLETE"
           : passed(suite)           ? "PASS"
           : tally(suite).holds == 0 ? "NOTHING HOLDS"
                                     : "FAIL";
}

std::string level_lines(const SuiteResult& suite)
{
    std::ostringstream text;
    text << std::left << std::setw(46) << "level" << std::right << std::setw(6) << "hold" << std::setw(6)
         << "fail" << std::setw(9) << "not run" << std::setw(12) << "compared" << std::setw(18)
         << "measured/allowed"
         << "\n";
    for (int n = 0; n <= static_cast<int>(Level::executors); ++n) {
        const Tally t = tally(suite, static_cast<Level>(n));
        text << "L" << n << " " << std::left << std::setw(43) << name_of(static_cast<Level>(n)) << std::right
             << std::setw(6) << t.holds << std::setw(6) << t.fails << std::setw(9) << t.not_run
             << std::setw(12) << t.compared << std::setw(18) << shown(t.ratio);
        if (t.closest != nullptr) {
            text << "  " << t.where->check->id << ", " << t.closest->name();
        }
        text << "\n";
    }
    return text.str();
}

/// What a table's cell may hold.
std::string cell(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        escaped += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
    }
    return escaped;
}

std::string equation_lines(const SuiteReport& report)
{
    std::ostringstream text;
    text << "| equation | title | reading | verdict |";
    std::string rule = "|---|---|---|---|";
    for (const SuiteSubject& s : report.suite.subjects) {
        text << " " << s.subject.name() << " |";
        rule += "---|";
    }
    text << " checks |\n" << rule << "---|\n";
    for (const EquationSummary& e : report.equations) {
        text << "| " << number_of(*e.equation) << " | " << cell(e.equation->title) << " | "
             << name_of(e.equation->status) << " | " << name_of(e.verdict)
             << (e.remark.empty() ? "" : ": " + cell(e.remark)) << " |";
        for (const EquationCell& c : e.cells) {
            using State = EquationCell::State;
            text << " "
                 << (c.state == State::holds || c.state == State::fails ? shown(c.tally.ratio)
                     : c.state == State::shared                         ? c.remark
                     : c.state == State::not_run                        ? "not run"
                                                                        : "-")
                 << (c.state == State::fails ? " FAILS |" : " |");
        }
        for (std::size_t k = 0; k < e.checks.size(); ++k) {
            text << (k == 0 ? " " : ", ") << e.checks[k]->id;
        }
        text << " |\n";
    }
    return text.str();
}

std::string ledger_lines(const SuiteReport& report)
{
    std::ostringstream text;
    text << "| check | subject | quantity | source | compared | measured | allowed | ratio | bound |\n"
         << "|---|---|---|---|---|---|---|---|---|\n";
    for (const CheckResult& r : report.suite.results) {
        for (const Quantity& q : r.quantities) {
            const Quantity::Worst& w = q.worst();
            text << "| " << r.check->id << " | " << r.subject << " | " << cell(q.name()) << " | "
                 << name_of(q.source()) << " | " << q.compared() << " | " << shown(w.error) << " | "
                 << shown(w.allowed) << " | " << shown(w.ratio) << (q.passed() ? "" : " **FAILS**")
                 << (q.loose() ? " (loose)" : "") << " | " << cell(q.derivation()) << " |\n";
        }
    }
    return text.str();
}

/// Each on a line that starts like this.
std::string lines(const std::vector<Reason>& reasons, const char* start)
{
    std::string text;
    for (const Reason& reason : reasons) {
        text.append(start).append(reason.who).append(": ").append(reason.why).append("\n");
    }
    return text;
}

} // namespace

std::string suite_text(const SuiteReport& report)
{
    const SuiteResult& suite = report.suite;
    return level_lines(suite) + lines(failures(suite), "FAILS      ") + lines(not_run(suite), "not run    ") +
           headline(report.equations) + "\n" + verdict_of(suite) + "\n";
}

std::string suite_markdown(const SuiteReport& report)
{
    const SuiteResult& suite = report.suite;
    const output::BuildInfo build = output::build_info();
    const Tally all = tally(suite);
    std::ostringstream text;
    text << "# Verification of aneurysm " << build.version << ": " << verdict_of(suite) << "\n\n"
         << headline(report.equations) << ".\n\n"
         << all.holds << " checks hold, " << all.fails << " fail, " << all.not_run << " were not run; "
         << all.compared << " numbers were compared, and the one closest to its bound used "
         << shown(100 * all.ratio) << " % of it. " << report.selection << ".\n\n"
         << "Commit " << build.commit << ", " << build.compiler << ", " << report.machine << ", "
         << report.date << ", " << shown(suite.seconds) << " s. Again: `" << report.command << "`\n\n";
    if (all.fails > 0) {
        text << "## What fails\n\n" << lines(failures(suite), "- ") << "\n";
    }
    if (!not_run(suite).empty()) {
        text << "## What was not run\n\n" << lines(not_run(suite), "- ") << "\n";
    }
    text << "## Equations\n\nThe numbers are the largest measured/allowed of all checks; above 1 is a "
            "failure.\n\n"
         << equation_lines(report) << "\n## Every number and its bound\n\n"
         << ledger_lines(report);
    return text.str();
}

} // namespace aneurysm::suite
