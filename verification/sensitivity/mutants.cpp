// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/mutants.hpp"

#include <array>
#include <utility>

namespace aneurysm::sensitivity
{
namespace
{

std::vector<Kind> kinds_of(Part part)
{
    switch (part) {
    case Part::term:
    case Part::vector:
    case Part::factor:
        return {Kind::coefficient, Kind::sign, Kind::power, Kind::dropped, Kind::off_by_one};
    case Part::limit:
        return {Kind::coefficient, Kind::sign, Kind::dropped};
    case Part::condition:
        return {Kind::sign, Kind::dropped, Kind::off_by_one};
    case Part::count:
        return {Kind::off_by_one};
    case Part::nought:
        return {Kind::coefficient};
    }
    return {};
}

std::string_view name_of(Kind kind)
{
    constexpr std::array<std::string_view, 5> names{"coefficient", "sign", "power", "dropped", "off_by_one"};
    return names.at(static_cast<std::size_t>(kind));
}

/// What is done to a part.
std::string_view words_of(Kind kind, Part part)
{
    switch (kind) {
    case Kind::coefficient:
        return part == Part::nought ? "0.01 m/s instead" : "1 % too large";
    case Kind::sign:
        return part == Part::condition ? "the opposite" : "wrong sign";
    case Kind::power:
        return part == Part::vector ? "components in the wrong order" : "to the power 1.01";
    case Kind::dropped:
        return part == Part::factor      ? "left out (1)"
               : part == Part::condition ? "left out (always)"
                                         : "left out (0)";
    case Kind::off_by_one:
        return part == Part::count ? "one too few" : "the one before";
    }
    return "";
}

} // namespace

std::vector<Mutant> all_mutants()
{
    std::vector<Mutant> all;
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (const Side side : {Side::reference, Side::device}) {
            if (side == Side::reference && places.at(k).backends == Backends::cuda) {
                continue;
            }
            for (const Kind kind : kinds_of(places.at(k).part)) {
                all.push_back({static_cast<Place>(k), side, kind, mutant_size});
            }
        }
    }
    return all;
}

/// (1) and (15) are hit through (7), (5) and (6) through (4), (21) through (19).
std::vector<Mutant> daily_mutants()
{
    constexpr Side reference = Side::reference;
    constexpr Side device = Side::device;
    return {
        {eq02_term, reference, Kind::off_by_one, mutant_size},
        {eq03_restart, device, Kind::sign, mutant_size},
        {eq04_outer, reference, Kind::power, mutant_size},
        {eos_rest, device, Kind::dropped, mutant_size},
        {eq07_difference, device, Kind::sign, mutant_size},
        {eq08_force, device, Kind::sign, mutant_size},
        {eq09_radius, reference, Kind::power, mutant_size},
        {eq10_thinning, device, Kind::dropped, mutant_size},
        {eq11_porosity, reference, Kind::coefficient, mutant_size},
        {eq12_load, device, Kind::off_by_one, mutant_size},
        {eq13_poisson, reference, Kind::dropped, mutant_size},
        {eq14_velocity, device, Kind::power, mutant_size},
        {eq16_band, reference, Kind::coefficient, mutant_size},
        {eq17_fibres, device, Kind::sign, mutant_size},
        {eq18_speed, reference, Kind::off_by_one, mutant_size},
        {eq19_collagen, device, Kind::dropped, mutant_size},
        {eq20_radius, reference, Kind::coefficient, mutant_size},
        {eq22_thinning, reference, Kind::dropped, mutant_size},
        {eq23_cap, device, Kind::coefficient, mutant_size},
        {eq24_root, reference, Kind::power, mutant_size},
        {eq25_phase, device, Kind::coefficient, mutant_size},
        {eq26_dynamic, reference, Kind::sign, mutant_size},
        {eq27_velocity, device, Kind::coefficient, mutant_size},
        {eq28_spring, reference, Kind::off_by_one, mutant_size},
    };
}

std::string equation_of(Place place)
{
    const std::string_view name = places.at(place).name;
    if (name.starts_with("eos")) {
        return "EOS";
    }
    if (name.starts_with("fig1")) {
        return "Fig. 1";
    }
    if (name.starts_with("sec34")) {
        return "3.4";
    }
    return std::to_string(std::stoi(std::string(name.substr(2, 2)))); // eqNN_
}

std::string name_of(Side side)
{
    return side == Side::reference ? "reference" : "cpu";
}

std::string name_of(const Mutant& mutant)
{
    return std::string(places.at(mutant.place).name)
        .append("/")
        .append(name_of(mutant.kind))
        .append("/")
        .append(name_of(mutant.side));
}

std::string words_of(const Mutant& mutant)
{
    const PlaceInfo& place = places.at(mutant.place);
    return std::string(place.text).append(": ").append(words_of(mutant.kind, place.part));
}

} // namespace aneurysm::sensitivity
