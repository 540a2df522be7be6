// SPDX-License-Identifier: Apache-2.0
// What is misprinted, missing or inconsistent in the paper, and how it is read here.
#include "common/equations.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/suite/words.hpp"

namespace aneurysm::reproduction
{

Section errata(Reproduction& reproduction)
{
    ResultTable by_equation{
        "Equations", {"equation", "title", "in runs", "read", "what is printed, and what is done here"}};
    for (const Equation& e : equations) {
        if (!e.deviation.empty()) {
            by_equation.add("(" + std::string(e.id) + ")", std::string(e.title),
                            std::string(suite::name_of(e.use)), std::string(suite::name_of(e.status)),
                            std::string(e.deviation));
        }
    }
    ResultTable others{"Tables, figures and text", {"where", "what", "read as"}};
    for (const auto& row : reproduction.paper.at("errata")) { // what the table of equations has no place for
        others.add(row.at("where").get<std::string>(), row.at("what").get<std::string>(),
                   row.at("read_as").get<std::string>());
    }
    Section section{"errata", "Errata of the paper, and how they are read"};
    section.tables = {by_equation, others};
    return section;
}

} // namespace aneurysm::reproduction
