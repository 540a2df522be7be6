// SPDX-License-Identifier: Apache-2.0
#include "output/build_info.hpp"
#include "output/provenance.hpp"
#include "output/report/html.hpp"
#include "verification/reproduction/section.hpp"

#include <algorithm>

namespace aneurysm::reproduction
{
namespace
{

using report::Document;
using report::Heading;
using report::Look;
using report::Text;

report::Table claims(const std::vector<Claim>& all)
{
    report::Table table{{report::prose("what the paper says"), "here", "decided", report::prose("found")}};
    for (const Claim& claim : all) {
        table.rows.push_back({claim.words, Text(verdict_of(claim), claim.holds ? Look::holds : Look::fails),
                              basis_of(claim), claim.found});
    }
    return table;
}

report::Table words(const ResultTable& t)
{
    report::Table table;
    for (const std::string& column : t.columns) {
        table.columns.emplace_back(column);
    }
    for (const std::vector<std::string>& row : t.rows) {
        table.rows.emplace_back(row.begin(), row.end());
    }
    return table;
}

/// What it came to first, how to understand it afterwards.
void add(Document& document, const Section& s)
{
    document << Heading{2, s.title, s.id};
    if (!s.claims.empty()) {
        document << claims(s.claims);
    }
    for (const Picture& p : s.pictures) {
        document << p;
    }
    for (std::size_t k = 0; k < std::max<std::size_t>(s.tables.size(), 1); ++k) {
        if (k < s.tables.size()) {
            if (!s.tables[k].title.empty()) {
                document << Heading{4, s.tables[k].title};
            }
            document << words(s.tables[k]);
        }
        for (std::size_t n = 0; k == 0 && n < s.text.size(); ++n) {
            document << Text(s.text[n]);
        }
    }
}

/// How many claims of the paper hold here, which don't, and where they stand.
void add_summary(Document& document, const std::vector<Section>& sections)
{
    std::int64_t all = 0;
    std::int64_t hold = 0;
    report::List broken;
    report::Table table{{"table or figure", "claims"}};
    for (const Section& s : sections) {
        const auto of = std::ssize(s.claims);
        const auto here = std::ranges::count_if(s.claims, &Claim::holds);
        all += of;
        hold += here;
        const Text link = report::Span{s.title, Look::plain, s.id};
        table.rows.push_back(
            {link, of == 0 ? "" : std::to_string(here) + " of " + std::to_string(of) + " claims hold"});
        for (const Claim& claim : s.claims) {
            if (!claim.holds) {
                broken.items.push_back(Text(verdict_of(claim), Look::fails) + ": " + claim.words + " (" +
                                       claim.found + "; " + link + ")");
            }
        }
    }
    const std::string verdict =
        std::to_string(hold) + " of " + std::to_string(all) + " claims of the paper hold here";
    document << report::Verdict{{verdict, hold == all ? Look::holds : Look::fails}};
    if (!broken.items.empty()) {
        document << broken;
    }
    document << table;
}

} // namespace

std::string page(const std::vector<Section>& sections, const std::string& command)
{
    Document document{std::string("The paper, reproduced by aneurysm ") + output::build_info().version};
    add_summary(document, sections);
    document
        << Text("Wu et al., Computational Simulation of Aneurysms Using Smoothed Particle Hydrodynamics, "
                "Mathematics 2025, 13(15), 2439: what this program makes of its tables, figures and claims. "
                "Made by ") +
               Text(command, Look::code) + " on " + output::machine() + ", commit " +
               Text(output::build_info().commit, Look::code) + ", " + output::now_utc() + ".";
    for (const Section& s : sections) {
        add(document, s);
    }
    return report::html(document);
}

} // namespace aneurysm::reproduction
