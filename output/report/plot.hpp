// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace aneurysm::report
{

/// One curve, or one set of points, of a plot.
struct Series {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;
    bool line = false; ///< else points
};

/// Curves over one pair of axes.
struct Plot {
    std::string title;
    std::string x_label; ///< with its unit
    std::string y_label;
    bool log_x = false;
    bool log_y = false;
    std::vector<Series> series;
};

} // namespace aneurysm::report
