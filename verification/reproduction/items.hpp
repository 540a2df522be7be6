// SPDX-License-Identifier: Apache-2.0
// The tables and figures of the paper that can be reproduced.
#pragma once

#include "verification/reproduction/context.hpp"

#include <string_view>
#include <vector>

namespace aneurysm::reproduction
{

struct Item {
    std::string_view id;
    std::string_view title;
    Section (*make)(Reproduction&);
};
const std::vector<Item>& all_items();

Section table1(Reproduction& reproduction);
Section table2(Reproduction& reproduction);
Section table3(Reproduction& reproduction);
Section table4(Reproduction& reproduction);
Section figure4(Reproduction& reproduction);
Section figure5(Reproduction& reproduction);
Section figure6(Reproduction& reproduction);
Section figure7(Reproduction& reproduction);
Section figure8(Reproduction& reproduction);
Section figure9(Reproduction& reproduction);
Section figure10(Reproduction& reproduction);
Section text(Reproduction& reproduction);
Section errata(Reproduction& reproduction);

} // namespace aneurysm::reproduction
