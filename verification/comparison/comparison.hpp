// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::comparison
{

/// One field of one frame: what was compared, and its worst member by measured / allowed.
struct FieldCheck {
    std::string name; ///< with its unit
    std::int64_t compared = 0;
    std::int64_t failed = 0;
    double ratio = 0; ///< measured / allowed; infinite for a NaN, or where nothing is allowed
    double measured = 0;
    double allowed = 0;
    std::int64_t particle = -1; ///< -1: the field has no particles

    /// A difference and its bound. NaN fails.
    void add(double difference, double bound, std::int64_t index = -1);
};

/// All fields of one frame, in a fixed order.
class FrameCheck
{
public:
    FrameCheck(std::int64_t frame, Phase phase) : frame_(frame), phase_(phase) {}

    FieldCheck& field(std::string_view name);
    /// Adds a check of one number: its distance from `expected`, which may lie between low and high.
    void number(std::string_view name, double value, double expected, double low, double high);
    void number(std::string_view name, double value, double expected, double error)
    {
        number(name, value, expected, expected - error, expected + error);
    }
    bool passed() const;

    std::int64_t frame() const { return frame_; }
    Phase phase() const { return phase_; }
    const std::vector<FieldCheck>& fields() const { return fields_; }

private:
    std::int64_t frame_;
    Phase phase_;
    std::vector<FieldCheck> fields_;
};

/// One field over all frames.
struct FieldResult {
    FieldCheck worst;           ///< `compared` and `failed`: of all frames
    std::int64_t frame = -1;    ///< of the worst
    std::vector<double> ratios; ///< by compared frame
};

/// What a comparison found out.
struct ComparisonResult {
    std::vector<FieldResult> fields;
    std::vector<std::int64_t> frames;      ///< compared, by their number
    std::map<Phase, std::int64_t> phases;  ///< how many of them
    std::int64_t open_particles = 0;       ///< whose bounds cover both outcomes of a decision, all frames
    std::int64_t particles = 0;            ///< all frames
    std::vector<std::int64_t> open_frames; ///< left out, or in part, since rounding decides what happens
    std::vector<std::string> problems;     ///< why it failed, beside the fields
    std::vector<std::string> notes;        ///< what else is worth knowing

    void add(const FrameCheck& frame);
    /// Every field compared something and stayed within its bound, and there is no problem.
    bool passed() const;
};

} // namespace aneurysm::comparison
