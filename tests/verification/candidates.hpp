// SPDX-License-Identifier: Apache-2.0
// Candidates for the comparisons: the reference itself, rounded to float or with faults; and what is found in them.
#pragma once

#include "common/simulation.hpp"
#include "reference/simulation.hpp"
#include "tests/vessels.hpp"
#include "verification/backends/float_state.hpp"
#include "verification/comparison/lockstep.hpp"

#include <functional>
#include <string>
#include <utility>

namespace aneurysm::test
{

/// A state as a float backend holds it.
inline SimulationState to_float(SimulationState state)
{
    const auto round = [](double& x) { x = static_cast<double>(static_cast<float>(x)); };
    backends::round_to_float(state.particles);
    round(state.outlet_velocity[0]);
    round(state.outlet_velocity[1]);
    AneurysmState& a = state.aneurysm;
    for (double* x : {&a.radius, &a.thickness, &a.displacement, &a.wall_velocity}) {
        round(*x);
    }
    return state;
}

/// A frame as a candidate shows it.
struct Frame {
    SimulationState state;
    FrameRecord record;
    std::vector<double> density;
    std::vector<double> solved_pressure;
    std::vector<double> solved_kappa;
};

/// Faults to plant: in the state that a frame is computed from, and in the frame that is shown.
struct Faults {
    std::function<void(SimulationState&)> before;
    std::function<void(Frame&)> after;
};

/// The reference as a candidate. In `float` it rounds all that it shows, and goes on from that.
class Candidate final : public Simulation
{
public:
    /// `scenario` is what it computes, which may differ from what it should.
    Candidate(const Scenario& scenario, const SimulationState& start, Precision precision, Faults faults = {})
        : precision_(precision), faults_(std::move(faults)),
          simulation_(scenario, rounds() ? to_float(start) : start)
    {
        frame_.state = simulation_.state();
        frame_.density = simulation_.density();
    }

    Engine engine() const override { return {Backend::reference, precision_, "a test"}; }
    FrameRecord advance() override
    {
        SimulationState start = frame_.state;
        if (faults_.before) {
            faults_.before(start);
        }
        simulation_.restart(std::move(start));
        frame_.record = simulation_.advance();
        frame_.state = rounds() ? to_float(simulation_.state()) : simulation_.state();
        frame_.density = simulation_.density();
        frame_.solved_pressure = simulation_.solved_pressure();
        frame_.solved_kappa = simulation_.solved_kappa();
        if (rounds()) {
            for (std::vector<double>* field :
                 {&frame_.density, &frame_.solved_pressure, &frame_.solved_kappa}) {
                for (double& x : *field) {
                    x = static_cast<double>(static_cast<float>(x));
                }
            }
        }
        if (faults_.after) {
            faults_.after(frame_);
        }
        return frame_.record;
    }
    const SimulationState& state() const override { return frame_.state; }
    const std::vector<double>& density() const override { return frame_.density; }
    const std::vector<double>& solved_pressure() const override { return frame_.solved_pressure; }
    const std::vector<double>& solved_kappa() const override { return frame_.solved_kappa; }

private:
    bool rounds() const { return precision_ == Precision::float_; }

    Precision precision_;
    Faults faults_;
    reference::Simulation simulation_;
    Frame frame_;
};

inline bool go_on(const FrameRecord&)
{
    return true;
}

inline comparison::ComparisonResult lockstep(const Scenario& scenario, Simulation& candidate, int frames)
{
    return comparison::compare_lockstep(scenario, candidate, frames, go_on);
}

/// Whether the comparison failed, and in this field.
inline bool is_red(const comparison::ComparisonResult& result, std::string_view name)
{
    const auto field =
        std::ranges::find_if(result.fields, [&](const auto& f) { return f.worst.name == name; });
    return !result.passed() && field != result.fields.end() && field->worst.failed > 0;
}

} // namespace aneurysm::test
