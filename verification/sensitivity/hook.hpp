// SPDX-License-Identifier: Apache-2.0
// The hook by which `aneurysm verify --sensitivity` plants mutants in the formulas: the mutant that is planted in this
// process, and what it does to a value. plant.py puts calls of it into a copy of the backends; their own sources have none.
#pragma once

#include "common/vec3.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace aneurysm::sensitivity
{

/// A part of one equation's formula, or of the rules that come with it: a row of mutants.txt.
enum Place : std::uint8_t {
#define ANEURYSM_PLACE(name, part, backends, text) name, ///< text
#include "verification/sensitivity/places.inc"
#undef ANEURYSM_PLACE
    place_count
};

/// What kind of part of a formula a place is; it decides which kinds of mutant make sense there.
enum class Part : std::uint8_t {
    term,      ///< of a sum; left out, it is 0
    vector,    ///< a term with three components
    factor,    ///< of a product; left out, it is 1
    limit,     ///< that something is compared with
    condition, ///< left out, it holds always
    count,     ///< a whole number
    nought,    ///< a velocity that ought to be 0
};

enum class Kind : std::uint8_t {
    coefficient, ///< (1 + size) x; of a velocity that ought to be 0: size in every direction [m/s]
    sign,        ///< -x; of a condition: its opposite
    power,       ///< |x|^(1 + size) with the sign of x; of a vector, the wrong index: (z, x, y)
    dropped,     ///< left out
    off_by_one,  ///< the value before: of the neighbor before in a sum, of the call before elsewhere; of a
                 ///< count one too few
};

/// Where the hook is.
enum class Side : std::uint8_t { reference, device };

struct Mutant {
    Place place = place_count; ///< place_count: none
    Side side = Side::reference;
    Kind kind = Kind::coefficient;
    double size = 0;
};

enum class Backends : std::uint8_t { both, cuda };

struct PlaceInfo {
    std::string_view name;
    Part part;
    Backends backends;
    std::string_view text;
};
inline constexpr std::array<PlaceInfo, place_count> places{{
#define ANEURYSM_PLACE(name, part, backends, text) {#name, Part::part, Backends::backends, text},
#include "verification/sensitivity/places.inc"
#undef ANEURYSM_PLACE
}};

/// The one mutant of this process; set it while nothing computes.
inline Mutant planted;
/// The places that have been computed with, by side.
inline std::array<std::array<std::atomic<bool>, place_count>, 2> visited{};

/// Lanes, without their header: a vector of numbers in `v`.
template <class T>
concept Several = requires(T x)
{
    x.v[0];
};
template <Several T>
// NOLINTNEXTLINE(bugprone-sizeof-expression): a vector of numbers, not a pointer
inline constexpr std::size_t size_of = sizeof(T::v) / sizeof(std::declval<T>().v[0]);

/// A number changed as `mutant` says, but for the value before.
template <std::floating_point T>
T changed(const Mutant& mutant, T x)
{
    const Part part = places[mutant.place].part;
    const auto wide = static_cast<double>(x);
    switch (mutant.kind) {
    case Kind::coefficient:
        return static_cast<T>(part == Part::nought ? mutant.size : wide * (1 + mutant.size));
    case Kind::sign:
        return -x;
    case Kind::power:
        return static_cast<T>(std::copysign(std::pow(std::abs(wide), 1 + mutant.size), wide));
    case Kind::dropped:
        return part == Part::factor ? T(1) : T(0);
    case Kind::off_by_one:
        break;
    }
    return x;
}
inline bool changed(const Mutant& mutant, bool holds)
{
    return mutant.kind == Kind::sign ? !holds : mutant.kind == Kind::dropped || holds;
}
template <std::integral T>
T changed(const Mutant& mutant, T count)
{
    return mutant.kind == Kind::off_by_one ? count - 1 : count;
}
template <Several T>
T changed(const Mutant& mutant, T x)
{
    for (std::size_t l = 0; l < size_of<T>; ++l) {
        x.v[l] = changed(mutant, x.v[l]);
    }
    return x;
}
template <class T>
Vec3T<T> changed(const Mutant& mutant, const Vec3T<T>& x)
{
    if (mutant.kind == Kind::power) {
        return {x.z, x.x, x.y};
    }
    return {changed(mutant, x.x), changed(mutant, x.y), changed(mutant, x.z)};
}

/// The value before `x`, when `previous` was the one of the call before.
template <class T>
T before(const T& previous, const T&)
{
    return previous;
}
template <Several T>
T before(const T& previous, const T& x)
{
    T r = x;
    for (std::size_t l = 0; l < size_of<T>; ++l) {
        r.v[l] = l > 0 ? x.v[l - 1] : previous.v[size_of<T> - 1];
    }
    return r;
}
template <class T>
Vec3T<T> before(const Vec3T<T>& previous, const Vec3T<T>& x)
{
    return {before(previous.x, x.x), before(previous.y, x.y), before(previous.z, x.z)};
}
/// Of the first call, its own.
template <class T>
T value_before(const T& x)
{
    thread_local std::optional<T> previous;
    const T r = before(previous.value_or(x), x);
    previous = x;
    return r;
}

template <class T>
T hooked(Side side, Place place, const T& x)
{
    visited[static_cast<std::size_t>(side)][place].store(true, std::memory_order_relaxed);
    if (planted.place != place || planted.side != side) {
        return x;
    }
    constexpr bool has_before = !std::integral<T> || std::same_as<T, bool>;
    if (planted.kind == Kind::off_by_one && has_before) {
        return value_before(x);
    }
    return changed(planted, x);
}

/// What a formula goes on with in the place of `value`; what is computed while compiling has no mutants.
template <class T>
constexpr T in_reference(Place place, const T& value)
{
    return std::is_constant_evaluated() ? value : hooked(Side::reference, place, value);
}
template <class T>
constexpr T in_device(Place place, const T& value)
{
    return std::is_constant_evaluated() ? value : hooked(Side::device, place, value);
}

} // namespace aneurysm::sensitivity
