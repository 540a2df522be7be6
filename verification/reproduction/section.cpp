// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/section.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>

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
    if (std::isnan(x)) {
        return "-";
    }
    std::ostringstream text;
    text << std::setprecision(digits) << x;
    return text.str();
}

std::string percent_off(double a, double b)
{
    std::ostringstream text;
    text << std::showpos << std::fixed << std::setprecision(0) << 100 * (a / b - 1) << " %";
    return text.str();
}

nlohmann::ordered_json to_json(const Section& section)
{
    using Json = nlohmann::ordered_json;
    Json tables = Json::array();
    for (const ResultTable& table : section.tables) {
        tables.push_back({{"title", table.title}, {"columns", table.columns}, {"rows", table.rows}});
    }
    Json claims = Json::array();
    for (const Claim& claim : section.claims) {
        claims.push_back({{"claim", claim.words}, {"holds", claim.holds}, {"found", claim.found}});
    }
    Json pictures = Json::array();
    for (const Picture& picture : section.pictures) {
        pictures.push_back({{"file", picture.file.filename().string()}, {"caption", picture.caption}});
    }
    return {{"id", section.id}, {"title", section.title}, {"text", section.text},
            {"tables", tables}, {"claims", claims},       {"pictures", pictures}};
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
