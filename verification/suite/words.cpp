// SPDX-License-Identifier: Apache-2.0
// What levels, verdicts and sources of bounds are called,
// and what they mean to a reader who doesn't know the code.
#include "verification/suite/summary.hpp"

namespace aneurysm::suite
{

std::string_view name_of(Level level)
{
    switch (level) {
    case Level::scalar:
        return "single formulas";
    case Level::lattice:
        return "sums over neighbors";
    case Level::transient:
        return "flows with a known discrete answer";
    case Level::continuous:
        return "flows with a known continuous answer";
    case Level::metamorphic:
        return "the same run in other words";
    case Level::executors:
        return "optimized backends against the reference";
    }
    return "";
}

std::string_view meaning_of(Level level)
{
    switch (level) {
    case Level::scalar:
        return "Each formula of the paper by itself, against answers found in other ways: formulas derived "
               "by hand, and numbers of the GNU Scientific Library or of a computation with 50 digits.";
    case Level::lattice:
        return "Sums over neighboring particles: of regular lattices, whose exact sums mathematics gives, "
               "and of disordered clouds, summed by brute force. Only rounding may separate them from ours.";
    case Level::transient:
        return "Whole flows, step by step, whose answer in the same steps is known: again only rounding may "
               "separate the two, or the stated tolerance of the solve for the pressure.";
    case Level::continuous:
        return "Flows whose exact solution is a formula of space and time. Particles and time steps make an "
               "error; its size is predicted, and an error smaller than predicted fails as a larger one "
               "does.";
    case Level::metamorphic:
        return "The same run told differently (in other units, interrupted, on more threads, moved in "
               "space): the result must be the same to the last bit, or within rounding where a sum runs in "
               "another order.";
    case Level::executors:
        return "The fast versions of the program against the plain one that reads like the paper. This shows "
               "that they are equivalent; that they are right follows from the other levels.";
    }
    return "";
}

std::string_view name_of(Verdict verdict)
{
    switch (verdict) {
    case Verdict::holds:
        return "holds";
    case Verdict::fails:
        return "FAILS";
    case Verdict::not_run:
        return "not run";
    }
    return "";
}

std::string_view name_of(Source source)
{
    switch (source) {
    case Source::exact:
        return "exact";
    case Source::rounding:
        return "rounding";
    case Source::truncation:
        return "truncation";
    case Source::quadrature:
        return "quadrature";
    case Source::solver:
        return "solver";
    case Source::statistics:
        return "statistics";
    }
    return "";
}

std::string_view meaning_of(Source source)
{
    switch (source) {
    case Source::exact:
        return "bits, whole numbers or plain statements: no difference is allowed";
    case Source::rounding:
        return "a computer rounds every result; so many operations may add up to so much";
    case Source::truncation:
        return "terms that the method leaves out by design, of known size";
    case Source::quadrature:
        return "the error that the GNU Scientific Library states for its own integral";
    case Source::solver:
        return "an iteration that stops when its error is below a given size";
    case Source::statistics:
        return "an interval that a correct program misses with a stated, small probability";
    }
    return "";
}

std::string_view name_of(Status status)
{
    switch (status) {
    case Status::printed:
        return "printed";
    case Status::reconstructed:
        return "reconstructed";
    case Status::assumed:
        return "assumed";
    }
    return "";
}

std::string_view name_of(EquationVerdict verdict)
{
    switch (verdict) {
    case EquationVerdict::holds:
        return "holds";
    case EquationVerdict::fails:
        return "FAILS";
    case EquationVerdict::not_checked:
        return "not checked";
    case EquationVerdict::no_check:
        return "NO CHECK";
    }
    return "";
}

std::string number_of(const Equation& equation)
{
    const std::string id(equation.id);
    return id == "EOS" ? id : "(" + id + ")";
}

} // namespace aneurysm::suite
