// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/bits.hpp"

#include "common/error.hpp"
#include "common/text.hpp"

#include <algorithm>

namespace aneurysm::comparison
{
namespace
{

/// Adds one field for each column; says the first time which ones differ.
void check_hashes(const std::vector<std::string>& hashes, const std::vector<std::string>& expected,
                  const std::string& whose, FrameCheck& check, ComparisonResult& result)
{
    const std::vector<std::string> differing = differing_columns(hashes, expected);
    for (const std::string& column : hash_columns()) {
        const bool same = std::ranges::find(differing, column) == differing.end();
        check.field(column + ", " + whose).add(same ? 0 : 1, 0);
    }
    const std::string text = "other bits than " + whose;
    const bool known = std::ranges::any_of(
        result.problems, [&](const std::string& problem) { return problem.starts_with(text); });
    if (!differing.empty() && !known) {
        result.problems.push_back(text + ", first in frame " + std::to_string(check.frame()) + ": " +
                                  joined(differing));
    }
}

} // namespace

ComparisonResult compare_bits(Simulation& candidate, const BitsOracles& oracles, std::int64_t frames,
                              const AfterFrame& after_frame, RecordedHashes* recording)
{
    ComparisonResult result;
    std::int64_t beyond_recorded = 0;
    try {
        for (std::int64_t n = 0; n < frames; ++n) {
            const FrameRecord record = candidate.advance();
            const std::vector<std::string> hashes = hashes_of(candidate.state());
            FrameCheck check(record.frame, record.phase);
            if (oracles.twin != nullptr) {
                oracles.twin->advance();
                check_hashes(hashes, hashes_of(oracles.twin->state()), "cpu with one thread", check, result);
            }
            if (oracles.recorded) {
                const auto row = oracles.recorded->frames.find(record.frame);
                if (row != oracles.recorded->frames.end()) {
                    check_hashes(hashes, row->second, "recorded", check, result);
                } else {
                    ++beyond_recorded;
                }
            }
            if (recording != nullptr) {
                recording->frames[record.frame] = hashes;
            }
            result.add(check);
            if (!after_frame(record)) {
                break;
            }
        }
    } catch (const SimulationError& error) {
        result.problems.push_back(std::string("stopped: ") + error.what());
    }
    if (beyond_recorded > 0) {
        result.notes.push_back(std::to_string(beyond_recorded) + " frames were never recorded");
    }
    return result;
}

} // namespace aneurysm::comparison
