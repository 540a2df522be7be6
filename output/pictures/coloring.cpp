// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/coloring.hpp"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aneurysm::pictures
{
namespace
{

using Color = std::array<int, 3>; // of 255

constexpr std::array<Color, 9> viridis{{{68, 1, 84},
                                        {71, 44, 122},
                                        {59, 81, 139},
                                        {44, 113, 142},
                                        {33, 144, 141},
                                        {39, 173, 129},
                                        {92, 200, 99},
                                        {170, 220, 50},
                                        {253, 231, 37}}};
constexpr std::array<Color, 5> blue_to_red{
    {{59, 76, 192}, {141, 176, 254}, {221, 221, 221}, {244, 154, 123}, {180, 4, 38}}};

template <std::size_t n>
void add_colors(vtkColorTransferFunction& function, const std::array<Color, n>& colors)
{
    for (std::size_t i = 0; i < n; ++i) {
        const auto [r, g, b] = colors.at(i);
        function.AddRGBPoint(static_cast<double>(i) / (n - 1), r / 255.0, g / 255.0, b / 255.0);
    }
}

/// 1, 2, 2.5 or 5 times a power of ten, the first that isn't less than x > 0.
double round_step(double x)
{
    const double power = std::pow(10, std::floor(std::log10(x)));
    for (const double digit : {1.0, 2.0, 2.5, 5.0}) {
        if (digit * power >= x * (1 - 1e-9)) {
            return digit * power;
        }
    }
    return 10 * power;
}

} // namespace

std::string title_of(Quantity quantity)
{
    return quantity == Quantity::speed ? "speed [m/s]" : "pressure [kPa]";
}

std::vector<double> shown_values(const output::ShownParticles& particles, Quantity quantity)
{
    std::vector<double> values;
    values.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        values.push_back(quantity == Quantity::speed ? length(particles.velocity[i])
                                                     : particles.pressure[i] / 1000);
    }
    return values;
}

void RangeFinder::add(const output::ShownParticles& particles)
{
    const std::vector<double> values = shown_values(particles, quantity_);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (particles.is_blood(i)) {
            values_.push_back(values[i]);
        }
    }
}

Range RangeFinder::range()
{
    if (values_.empty()) {
        return {0, 1};
    }
    const auto at = [this](double part) {
        const auto n = static_cast<std::ptrdiff_t>(part * static_cast<double>(values_.size() - 1));
        std::nth_element(values_.begin(), values_.begin() + n, values_.end());
        return values_[static_cast<std::size_t>(n)];
    };
    const double low = quantity_ == Quantity::speed ? 0 : at(0.01);
    const double high = std::max(at(0.99), low);
    const double step = round_step(std::max(high - low, 1e-6 * (1 + std::abs(low))) / 5);
    return {step * std::floor(low / step), step * std::ceil(high / step)};
}

vtkSmartPointer<vtkLookupTable> colors_of(Quantity quantity, const Range& range)
{
    vtkNew<vtkColorTransferFunction> function;
    if (quantity == Quantity::speed) {
        add_colors(*function, viridis);
    } else {
        add_colors(*function, blue_to_red);
    }
    constexpr int steps = 256;
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(steps);
    for (int i = 0; i < steps; ++i) {
        std::array<double, 3> rgb{};
        function->GetColor(i / (steps - 1.0), rgb.data());
        table->SetTableValue(i, rgb[0], rgb[1], rgb[2], 1);
    }
    table->SetTableRange(range.low, range.high);
    return table;
}

} // namespace aneurysm::pictures
