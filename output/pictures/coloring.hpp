// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/vtk.hpp"

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aneurysm::pictures
{

/// What particles are colored by.
enum class Quantity { speed, pressure };

/// What the color bar says, unit included.
std::string title_of(Quantity quantity);

/// By particle, in the unit of the title: speeds [m/s], pressures [kPa].
std::vector<double> shown_values(const output::ShownParticles& particles, Quantity quantity);

/// What the colors span, in the unit of the title.
struct Range {
    double low = 0;
    double high = 0;
};

/// Round numbers that all but the outermost 1 % of blood's values lie between; a speed's begins at 0.
class RangeFinder
{
public:
    explicit RangeFinder(Quantity quantity) : quantity_(quantity) {}
    void add(const output::ShownParticles& particles);
    Range range();

private:
    Quantity quantity_;
    std::vector<double> values_;
};

/// Viridis for speeds; blue over gray to red for pressures.
vtkSmartPointer<vtkLookupTable> colors_of(Quantity quantity, const Range& range);

} // namespace aneurysm::pictures
