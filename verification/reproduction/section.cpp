// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/section.hpp"

#include "output/json.hpp"
#include "output/report/numbers.hpp"

#include <cmath>

namespace aneurysm::reproduction
{
namespace
{

std::string csv_row(const std::vector<std::string>& cells)
{
    std::string line;
    for (const std::string& cell : cells) {
        std::string quoted = cell;
        for (std::size_t k = quoted.find('"'); k != std::string::npos; k = quoted.find('"', k + 2)) {
            quoted.insert(k, 1, '"');
        }
        const bool plain = cell.find_first_of(",\"\n") == std::string::npos;
        line += (line.empty() ? "" : ",") + (plain ? cell : '"' + quoted + '"');
    }
    return line + "\n";
}

} // namespace

std::string number(double x, int digits)
{
    return std::isnan(x) ? "-" : report::printed(("%." + std::to_string(digits) + "g").c_str(), x);
}

std::string whole(double x)
{
    return std::isnan(x) ? "-" : std::to_string(std::llround(x));
}

std::string percent_off(double a, double b)
{
    const long long off = std::llround(100 * (a / b - 1));
    return (off >= 0 ? "+" : "") + std::to_string(off) + " %";
}

std::string verdict_of(const Claim& claim)
{
    return claim.holds ? "holds" : claim.basis == Basis::excluded ? "cannot hold" : "does not hold";
}

std::string basis_of(const Claim& claim)
{
    return claim.basis == Basis::measured ? "by measurement" : "by the equations";
}

nlohmann::ordered_json to_json(const Section& section)
{
    using output::Json;
    return {{"id", section.id},
            {"title", section.title},
            {"text", section.text},
            {"tables",
             output::json_array(section.tables,
                                [](const ResultTable& t) {
                                    return Json{{"title", t.title}, {"columns", t.columns}, {"rows", t.rows}};
                                })},
            {"claims", output::json_array(section.claims,
                                          [](const Claim& c) {
                                              return Json{{"claim", c.words},
                                                          {"holds", c.holds},
                                                          {"verdict", verdict_of(c)},
                                                          {"decided", basis_of(c)},
                                                          {"found", c.found}};
                                          })},
            {"pictures", output::json_array(section.pictures, [](const Picture& p) {
                 return Json{{"file", p.file.filename().string()}, {"caption", p.caption}};
             })}};
}

std::string to_csv(const ResultTable& table)
{
    std::string text = csv_row(table.columns);
    for (const std::vector<std::string>& row : table.rows) {
        text += csv_row(row);
    }
    return text;
}

} // namespace aneurysm::reproduction
