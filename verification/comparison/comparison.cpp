// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aneurysm::comparison
{

void FieldCheck::add(double difference, double bound, std::int64_t index)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double r = difference == 0 && bound >= 0 ? 0.0 : difference / bound;
    if (!(difference <= bound) || !std::isfinite(bound)) {
        ++failed;
        r = std::isfinite(r) && r > 1 ? r : infinite;
    }
    if (compared == 0 || r > ratio) {
        ratio = r;
        measured = difference;
        allowed = bound;
        particle = index;
    }
    ++compared;
}

FieldCheck& FrameCheck::field(std::string_view name)
{
    const auto found = std::ranges::find(fields_, name, &FieldCheck::name);
    if (found != fields_.end()) {
        return *found;
    }
    fields_.push_back({std::string(name)});
    return fields_.back();
}

void FrameCheck::number(std::string_view name, double value, double expected, double low, double high)
{
    const double allowed = value > expected ? high - expected : expected - low;
    const bool same = value >= low && value <= high && value == expected;
    field(name).add(same ? 0 : std::abs(value - expected), std::max(allowed, 0.0));
}

bool FrameCheck::passed() const
{
    return std::ranges::all_of(fields_, [](const FieldCheck& f) { return f.failed == 0; });
}

void ComparisonResult::add(const FrameCheck& frame)
{
    for (const FieldCheck& check : frame.fields()) {
        auto found =
            std::ranges::find_if(fields, [&](const FieldResult& f) { return f.worst.name == check.name; });
        if (found == fields.end()) {
            FieldResult fresh;
            fresh.worst.name = check.name;
            fresh.ratios.resize(frames.size(), 0);
            fields.push_back(std::move(fresh));
            found = fields.end() - 1;
        }
        FieldCheck& worst = found->worst;
        const std::int64_t compared = worst.compared + check.compared;
        const std::int64_t failed = worst.failed + check.failed;
        if (check.compared > 0 && (found->frame < 0 || check.ratio > worst.ratio)) {
            worst = check;
            found->frame = frame.frame();
        }
        worst.compared = compared;
        worst.failed = failed;
        found->ratios.push_back(check.ratio);
    }
    frames.push_back(frame.frame());
    for (FieldResult& f : fields) {
        f.ratios.resize(frames.size(), 0);
    }
    ++phases[frame.phase()];
}

bool ComparisonResult::passed() const
{
    return problems.empty() && !fields.empty() && std::ranges::all_of(fields, [](const FieldResult& f) {
               return f.worst.compared > 0 && f.worst.failed == 0;
           });
}

} // namespace aneurysm::comparison
