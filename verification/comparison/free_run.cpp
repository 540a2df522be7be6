// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/free_run.hpp"

#include "common/error.hpp"
#include "verification/backends/float_state.hpp"
#include "verification/comparison/ensemble.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <sstream>
#include <utility>

namespace aneurysm::comparison
{
namespace
{

/// A number of a frame that is compared as a mean over windows.
struct Quantity {
    std::string name;
    std::function<double(const FreeFrame&)> of;
};

std::vector<Quantity> quantities()
{
    const auto member = [](double FrameRecord::*number) {
        return [number](const FreeFrame& f) { return f.record.*number; };
    };
    const auto component = [](double Vec3::*axis) {
        return [axis](const FreeFrame& f) { return f.momentum.*axis; };
    };
    return {{"F_b [N]", member(&FrameRecord::impact_force)},
            {"R [m]", member(&FrameRecord::radius)},
            {"h [m]", member(&FrameRecord::thickness)},
            {"P_c [Pa]", member(&FrameRecord::critical_pressure)},
            {"momentum x [kg m/s]", component(&Vec3::x)},
            {"momentum y [kg m/s]", component(&Vec3::y)},
            {"momentum z [kg m/s]", component(&Vec3::z)},
            {"kinetic energy [J]", member(&FrameRecord::kinetic_energy)}};
}

struct Sample {
    double mean = 0;
    double deviation = 0;
};
Sample sample_of(const std::vector<double>& values)
{
    const auto n = static_cast<double>(values.size());
    Sample sample;
    for (const double x : values) {
        sample.mean += x / n;
    }
    double squares = 0;
    for (const double x : values) {
        squares += (x - sample.mean) * (x - sample.mean);
    }
    sample.deviation = std::sqrt(squares / (n - 1));
    return sample;
}

class FreeComparison
{
public:
    FreeComparison(const FreeRunSettings& settings, std::int64_t window, const FreeRun& candidate,
                   const std::vector<FreeRun>& runs)
        : window_(static_cast<std::size_t>(window)), windows_(candidate.frames.size() / window_),
          candidate_(candidate), reference_(runs.front()), members_(runs.begin() + 1, runs.end()),
          factor_(prediction_factor(settings.members,
                                    settings.false_alarm /
                                        static_cast<double>(quantities().size() * windows_ + 1)))
    {
    }

    ComparisonResult result();

private:
    double mean(const std::vector<FreeFrame>& frames, const Quantity& quantity, std::size_t w) const;
    void check_window(std::size_t w);
    void check_rupture(FrameCheck& check);
    void note_distances();

    std::size_t window_;
    std::size_t windows_;
    const FreeRun& candidate_;
    const FreeRun& reference_;
    std::vector<FreeRun> members_;
    double factor_;
    ComparisonResult result_;
};

double FreeComparison::mean(const std::vector<FreeFrame>& frames, const Quantity& quantity,
                            std::size_t w) const
{
    double sum = 0;
    for (std::size_t n = w * window_; n < (w + 1) * window_; ++n) {
        sum += quantity.of(frames[n]);
    }
    return sum / static_cast<double>(window_);
}

void FreeComparison::check_window(std::size_t w)
{
    const FrameRecord& last = candidate_.frames[(w + 1) * window_ - 1].record;
    FrameCheck check(last.frame, last.phase);
    for (const Quantity& quantity : quantities()) {
        std::vector<double> values;
        for (const FreeRun& member : members_) {
            values.push_back(mean(member.frames, quantity, w));
        }
        const Sample sample = sample_of(values);
        const double rounding = mean(reference_.rounding, quantity, w);
        check.field(quantity.name)
            .add(std::abs(mean(candidate_.frames, quantity, w) - sample.mean),
                 factor_ * sample.deviation + rounding);
    }
    if (w + 1 == windows_) {
        check_rupture(check);
    }
    result_.add(check);
}

/// -1 when the run didn't.
std::int64_t rupture_frame(const FreeRun& run)
{
    for (const FreeFrame& f : run.frames) {
        if (f.record.phase == Phase::ruptured) {
            return f.record.frame;
        }
    }
    return -1;
}

/// A frame's number is a time rounded to whole frames on both sides: one frame more.
void FreeComparison::check_rupture(FrameCheck& check)
{
    const std::int64_t own = rupture_frame(candidate_);
    std::vector<double> frames;
    std::ostringstream text;
    for (const FreeRun& member : members_) {
        const std::int64_t frame = rupture_frame(member);
        text << (text.str().empty() ? "" : ", ") << frame;
        if (frame >= 0) {
            frames.push_back(static_cast<double>(frame));
        }
    }
    result_.notes.push_back("frame of rupture (-1: none): " + std::to_string(own) + ", of the ensemble " +
                            text.str());
    const char* const name = "frame of rupture";
    if (frames.empty()) {
        check.field(name).add(own < 0 ? 0 : 1, 0);
    } else if (frames.size() < members_.size()) {
        result_.notes.emplace_back("only part of the ensemble ruptured: too few frames to compare its frame");
    } else {
        const Sample sample = sample_of(frames);
        check.field(name).add(own < 0 ? std::nan("") : std::abs(static_cast<double>(own) - sample.mean),
                              factor_ * sample.deviation + 1);
    }
}

/// Root mean square distance of the blood that both have.
double distance(const Particles& p, const Particles& q)
{
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
        if (p.kind[i] == Kind::fluid && q.kind[i] == Kind::fluid) {
            const Vec3 d = p.position[i] - q.position[i];
            sum += dot(d, d);
            ++count;
        }
    }
    return std::sqrt(sum / std::max(count, 1.0));
}

void FreeComparison::note_distances()
{
    std::ostringstream text;
    text.precision(2);
    text << "rms distance of particles from the undisturbed reference [m], of the candidate and of a member:";
    for (std::size_t w = 0; w < windows_; ++w) {
        text << " frame " << candidate_.frames[(w + 1) * window_ - 1].record.frame << ": "
             << distance(candidate_.particles[w], reference_.particles[w]) << ", "
             << distance(members_.front().particles[w], reference_.particles[w]) << ";";
    }
    result_.notes.push_back(text.str());
}

ComparisonResult FreeComparison::result()
{
    for (std::size_t w = 0; w < windows_; ++w) {
        check_window(w);
    }
    note_distances();
    std::ostringstream text;
    text.precision(3);
    text << windows_ << " windows of " << window_ << " frames; a further member is within " << factor_
         << " standard deviations of the ensemble's mean";
    result_.notes.push_back(text.str());
    return std::move(result_);
}

FreeRun run_candidate(Simulation& candidate, std::int64_t frames, std::int64_t window, const FrameDone& done)
{
    FreeRun run;
    for (std::int64_t n = 1; n <= frames; ++n) {
        const FrameRecord record = candidate.advance();
        run.frames.push_back({record, momentum(candidate.state().particles)});
        if (n % window == 0) {
            run.particles.push_back(candidate.state().particles);
        }
        if (!done(record)) {
            break;
        }
    }
    return run;
}

} // namespace

double prediction_factor(int members, double alpha)
{
    return gsl_cdf_tdist_Qinv(alpha / 2, members - 1) * std::sqrt(1 + 1.0 / members);
}

ComparisonResult compare_free(const Scenario& scenario, Simulation& candidate,
                              const FreeRunSettings& settings, const AfterFrame& after_frame)
{
    const std::int64_t window = std::max<std::int64_t>(settings.frames / settings.windows, 1);
    const Precision precision = candidate.engine().precision;
    SimulationState start = candidate.state();
    if (precision == Precision::float_) {
        backends::round_to_float(start.particles);
    }
    std::mutex mutex;
    bool go_on = true;
    const FrameDone done = [&](const FrameRecord& record) {
        const std::lock_guard lock(mutex);
        go_on = go_on && after_frame(record);
        return go_on;
    };
    ComparisonResult failed;
    try {
        const FreeRun own = run_candidate(candidate, settings.frames, window, done);
        const std::vector<FreeRun> runs =
            go_on ? run_ensemble(scenario, start, precision, settings.frames, window, settings.members, done)
                  : std::vector<FreeRun>{};
        if (go_on && static_cast<std::int64_t>(own.frames.size()) >= window) {
            return FreeComparison(settings, window, own, runs).result();
        }
        failed.problems.emplace_back("too few frames");
    } catch (const SimulationError& error) {
        failed.problems.push_back(std::string("stopped: ") + error.what());
    }
    return failed;
}

} // namespace aneurysm::comparison
