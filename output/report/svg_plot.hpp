// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/report/markup.hpp"
#include "output/report/plot.hpp"

namespace aneurysm::report
{

/// A plot as an inline <svg>. Its colors are those of the page's style sheet: classes axis, grid, and s0, s1
/// ... for the series, which differ in shape and dashes, too. Points that an axis has no place for (NaN,
/// infinite, not positive on a logarithmic one) are left out and counted in the legend.
Markup svg(const Plot& plot);

} // namespace aneurysm::report
