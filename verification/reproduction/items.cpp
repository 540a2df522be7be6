// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/items.hpp"

namespace aneurysm::reproduction
{

const std::vector<Item>& all_items()
{
    static const std::vector<Item> items{
        {"table1", "Table 1: given values", table1},
        {"table2", "Table 2: shapes", table2},
        {"table3", "Table 3: frames per second", table3},
        {"table4", "Table 4: frames of rupture", table4},
        {"fig4", "Fig. 4: particles", figure4},
        {"fig5", "Fig. 5: blood", figure5},
        {"fig6", "Fig. 6: shapes", figure6},
        {"fig7", "Fig. 7: impact, thickness and critical pressure by shape", figure7},
        {"fig8", "Fig. 8: angles", figure8},
        {"fig9", "Fig. 9: impact, critical pressure and thickness by Poisson's ratio", figure9},
        {"fig10", "Fig. 10: radius and thickness at fixed growth", figure10},
        {"text", "Text: claims that the equations decide", text},
        {"errata", "Errata", errata},
    };
    return items;
}

} // namespace aneurysm::reproduction
