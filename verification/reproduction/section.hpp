// SPDX-License-Identifier: Apache-2.0
// What one table or figure of the paper came to, as the page shows it.
#pragma once

#include "output/report/document.hpp"

#include <nlohmann/json_fwd.hpp>

#include <concepts>
#include <string>
#include <vector>

namespace aneurysm::reproduction
{

/// A number in as few digits as tell it apart; "-" for a NaN.
std::string number(double x, int digits = 4);
/// A number without its fraction; "-" for a NaN.
std::string whole(double x);
/// How far a is from b, as in "-12 %".
std::string percent_off(double a, double b);

struct ResultTable {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows{};

    /// A row of texts, whole numbers, and others to four digits.
    template <class... Cells>
    void add(const Cells&... cells)
    {
        rows.push_back({cell(cells)...});
    }
    static std::string cell(const std::string& text) { return text; }
    static std::string cell(std::integral auto x) { return std::to_string(x); }
    static std::string cell(std::floating_point auto x) { return number(x); }
};

/// The way in which it is decided whether a claim holds.
enum class Basis {
    measured, ///< in runs or on the wall, with the values of the scenario
    follows,  ///< it follows from the equations, whatever the values
    excluded, ///< the equations say otherwise, whatever the values
};

/// Something that the paper says in words, and what was found here.
struct Claim {
    std::string words;
    bool holds = false;
    std::string found; ///< the number that decides
    Basis basis = Basis::measured;
};
/// "holds", "does not hold", or "cannot hold" of one that the equations exclude.
std::string verdict_of(const Claim& claim);
/// "by measurement" or "by the equations"
std::string basis_of(const Claim& claim);

using report::Picture;

struct Section {
    std::string id;    ///< table1 ... fig10, text, errata
    std::string title; ///< the paper's
    std::vector<std::string> text{};
    std::vector<ResultTable> tables{};
    std::vector<Claim> claims{};
    std::vector<Picture> pictures{};
};

/// For programs.
nlohmann::ordered_json to_json(const Section& section);
/// RFC 4180.
std::string to_csv(const ResultTable& table);
/// One page that needs no other file.
std::string page(const std::vector<Section>& sections, const std::string& command);

} // namespace aneurysm::reproduction
