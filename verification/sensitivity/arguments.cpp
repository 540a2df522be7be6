// SPDX-License-Identifier: Apache-2.0
// Why some mutants can't be found, and some checks can't be turned red.
#include "verification/sensitivity/sensitivity.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::sensitivity
{
namespace
{

/// One or both backends' formulas do the same with the mutant as without.
struct Equivalent {
    Place place;
    Kind kind;
    bool in_reference;
    bool in_device;
    std::string_view why;
};

constexpr std::string_view constant = "the part is a constant of the formula: its value before is its value";
constexpr std::string_view of_run = "the part is a constant of the run: its value before is its value";
constexpr std::string_view even = "only an even power of the part is used";
constexpr std::string_view size = "only the length of the vector that it multiplies is used";

constexpr std::array<Equivalent, 11> equivalents{{
    {eq02_mirrors, Kind::off_by_one, true, true, constant},
    {eq03_density, Kind::off_by_one, true, true, of_run},
    {eq04_square, Kind::off_by_one, false, true, constant},
    {eq04_slope_line, Kind::off_by_one, false, true, constant},
    {eq04_wendland, Kind::sign, true, true, even},
    {eq04_slope_outer, Kind::sign, true, true, even},
    {eq07_viscosity, Kind::off_by_one, true, true, of_run},
    {eq10_sphere, Kind::off_by_one, true, true, constant},
    {eq16_mass, Kind::sign, true, true, size},
    {eq16_density, Kind::sign, true, true, size},
    {eq24_root, Kind::off_by_one, true, true, constant},
}};

} // namespace

std::string_view argument_for(const Mutant& mutant)
{
    const auto* found = std::ranges::find_if(equivalents, [&](const Equivalent& e) {
        return e.place == mutant.place && e.kind == mutant.kind &&
               (mutant.side == Side::reference ? e.in_reference : e.in_device);
    });
    return found != equivalents.end() ? found->why : std::string_view{};
}

std::string_view argument_for(const suite::Check&, Side)
{
    return {};
}

} // namespace aneurysm::sensitivity
