// SPDX-License-Identifier: Apache-2.0
// What levels, verdicts and sources of bounds are called, and what they mean to a reader who doesn't know the code.
#pragma once

#include "common/equations.hpp"
#include "verification/suite/suite.hpp"

#include <array>
#include <string>
#include <string_view>

namespace aneurysm::suite
{

enum class EquationVerdict {
    holds,       ///< all that was checked, by evidence for at least one backend
    fails,       ///< somewhere
    not_checked, ///< not chosen, not run or interrupted; the remark says which
    no_check,    ///< the suite has none
};

/// A value of an enumeration in words.
struct Word {
    std::string_view name;
    std::string_view meaning{};
};

/// The words of an enumeration, in the order of its values.
template <class Enum>
inline constexpr std::array<Word, 0> words{};

template <>
inline constexpr std::array words<Level>{
    Word{
        "single formulas",
        "Each formula of the paper by itself, against answers found in other ways: formulas derived by hand, and "
        "numbers of the GNU Scientific Library or of a computation with 50 digits."},
    Word{
        "sums over neighbors",
        "Sums over neighboring particles: of regular lattices, whose exact sums mathematics gives, and of disordered "
        "clouds, summed by brute force. Only rounding may separate them from ours."},
    Word{
        "flows with a known discrete answer",
        "Whole flows, step by step, whose answer in the same steps is known: again only rounding may separate the "
        "two, or the stated tolerance of the solve for the pressure."},
    Word{
        "exact solutions of flows",
        "Flows whose exact solution is a formula of space and time, each found in two ways. The model against nature "
        "(L6) is measured by them."},
    Word{
        "the same run in other words",
        "The same run told differently (in other units, interrupted, on more threads, moved in space): the result "
        "must be the same to the last bit, or within rounding where a sum runs in another order."},
    Word{
        "optimized backends against the reference",
        "The fast versions of the program against the plain one that reads like the paper. This shows that they are "
        "equivalent; that they are right follows from the other levels."},
    Word{
        "the model against nature",
        "What blood does, against what the program makes of it with the paper's own means: blood at rest stays at rest, "
        "flow in a tube has its profile. Here the model itself is judged, not how it is programmed; it is the same in "
        "all versions, so that one of them is enough."}};

template <>
inline constexpr std::array words<Source>{
    Word{"exact", "bits, whole numbers or plain statements: no difference is allowed"},
    Word{"rounding", "a computer rounds every result; so many operations may add up to so much"},
    Word{"truncation", "terms that the method leaves out by design, of known size"},
    Word{"quadrature", "the error that the GNU Scientific Library states for its own integral"},
    Word{"solver", "an iteration that stops when its error is below a given size"},
    Word{"statistics", "an interval that a correct program misses with a stated, small probability"},
    Word{"nature", "what is asked of the model; where it isn't met yet, what it was when that was recorded"}};

template <>
inline constexpr std::array words<Verdict>{Word{"holds"}, Word{"FAILS"}, Word{"not run"},
                                           Word{"not met yet"}};

template <>
inline constexpr std::array words<EquationVerdict>{Word{"holds"}, Word{"FAILS"}, Word{"not checked"},
                                                   Word{"NO CHECK"}};

template <>
inline constexpr std::array words<Status>{Word{"printed"}, Word{"reconstructed"}, Word{"assumed"}};

template <>
inline constexpr std::array words<Use>{Word{"used"}, Word{"part of (21)"}, Word{"nominal"}};

template <>
inline constexpr std::array words<Scope>{Word{"equations"}, Word{"flows"}, Word{"backends"}, Word{"once"},
                                         Word{"model"}};

template <class Enum>
requires(!words<Enum>.empty()) constexpr std::string_view name_of(Enum value)
{
    return words<Enum>.at(static_cast<std::size_t>(value)).name;
}

inline constexpr std::array levels{Level::scalar,      Level::lattice,   Level::transient, Level::continuous,
                                   Level::metamorphic, Level::executors, Level::nature};
constexpr std::string_view meaning_of(Level level)
{
    return words<Level>.at(static_cast<std::size_t>(level)).meaning;
}
/// "L0"
inline std::string number_of(Level level)
{
    return "L" + std::to_string(static_cast<int>(level));
}
/// "(13)", or "EOS"
inline std::string number_of(const Equation& equation)
{
    const std::string id(equation.id);
    return id == "EOS" ? id : "(" + id + ")";
}

} // namespace aneurysm::suite
