// SPDX-License-Identifier: Apache-2.0
#include "output/run_frames.hpp"

#include "common/error.hpp"
#include "common/exception.hpp"
#include "common/process/interrupt.hpp"

#include <string>

namespace aneurysm::output
{
namespace
{

class Loop
{
public:
    Loop(const Scenario& scenario, const Vessel& vessel, std::int64_t frames, Simulation& simulation,
         RunDirectory& directory)
        : scenario_(scenario), vessel_(vessel), frames_(frames), simulation_(simulation),
          directory_(directory)
    {
    }

    /// \return whether it came to the end; not when it was interrupted
    bool run(const OnFrame& on_frame)
    {
        if (frame() == 0) {
            write_particles(0);
            written_frame_ = 0;
        }
        while (frame() < frames_ && !InterruptWatch::interrupted()) {
            const FrameRecord record = simulation_.advance();
            directory_.append(record, simulation_.state());
            write_due(record.frame);
            written_frame_ = record.frame;
            on_frame(record);
        }
        if (frame() >= frames_ && !due(frame(), scenario_.output.particles_every_frames)) {
            written_frame_ = -1;
            write_particles(frame()); // the last one, too
            written_frame_ = frame();
        }
        save_state();
        return frame() >= frames_;
    }

    /// The run has failed; keep what there is and say why. A second failure (the same full disk) must not
    /// hide the first. A state whose row or particles didn't make it onto the disk is none to go on from, since a
    /// resumed run starts after it; the checkpoint before it is.
    void save_failed(const std::string& message)
    {
        try {
            if (frame() == directory_.frames() && frame() == written_frame_) {
                save_state();
            }
        } catch (const std::exception&) { // NOLINT(bugprone-empty-catch)
        }
        try {
            directory_.close(RunStatus::failed, message);
        } catch (const std::exception&) { // NOLINT(bugprone-empty-catch)
        }
    }

    std::int64_t frame() const { return simulation_.state().frame; }

private:
    void save_state()
    {
        if (saved_frame_ != frame()) {
            directory_.write_checkpoint(simulation_.state());
            saved_frame_ = frame();
        }
    }
    static bool due(std::int64_t frame, std::int64_t every) { return every > 0 && frame % every == 0; }
    void write_due(std::int64_t frame)
    {
        if (due(frame, scenario_.output.particles_every_frames)) {
            write_particles(frame);
        }
        if (due(frame, scenario_.output.checkpoint_every_frames)) {
            save_state();
        }
    }
    void write_particles(std::int64_t frame)
    {
        if (scenario_.output.particles_every_frames == 0) {
            return;
        }
        const SimulationState& state = simulation_.state();
        directory_.write_particles(frame, {state.particles, simulation_.density()});
        if (vessel_.form() == DomainForm::artery) {
            const AneurysmState& sac = state.aneurysm;
            const double breach = scenario_.rupture.breach_radius_radii * scenario_.vessel.radius_m;
            directory_.write_wall(
                frame, vessel_,
                wall_shape(vessel_, sac.radius + sac.displacement, sac.phase == Phase::ruptured, breach));
        }
    }

    const Scenario& scenario_;
    const Vessel& vessel_;
    std::int64_t frames_;
    Simulation& simulation_;
    RunDirectory& directory_;
    std::int64_t saved_frame_ = -1;
    std::int64_t written_frame_ = -1; ///< all that is due for it is on the disk
};

} // namespace

bool run_frames(const Scenario& scenario, const Vessel& vessel, std::int64_t frames, Simulation& simulation,
                RunDirectory& directory, const OnFrame& on_frame)
{
    Loop loop(scenario, vessel, frames, simulation, directory);
    bool complete = false;
    try {
        complete = loop.run(on_frame);
    } catch (const std::exception& error) {
        loop.save_failed(text_of(error));
        throw;
    }
    directory.close(complete ? RunStatus::finished : RunStatus::interrupted,
                    complete ? "" : "interrupted after frame " + std::to_string(loop.frame()));
    return complete;
}

} // namespace aneurysm::output
