// SPDX-License-Identifier: Apache-2.0
// What runs once came to, kept in data/: baseline.json and the hashes of their frames. To cite, and to find
// again on another machine or years later.
#pragma once

#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/hash_file.hpp"
#include "verification/comparison/lockstep.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aneurysm::comparison
{

/// Numbers of one frame that a reader may want to compare.
struct KeyFrame {
    std::int64_t frame = 0;
    std::vector<double> values; ///< as key_names()
};
/// "F_b [N]", ...
const std::vector<std::string>& key_names();

/// The whole run in a few numbers.
struct BaselineTotals {
    std::int64_t rupture_frame = -1; ///< -1: none
    std::int64_t particles_in = 0;   ///< at all open ends, back-flow included
    std::int64_t particles_out = 0;
    std::int64_t particles_escaped = 0; ///< through the breach
    double iterations = 0;              ///< of the pressure solve, mean over the frames

    bool operator==(const BaselineTotals&) const = default;
};

/// A run of one backend.
struct BaselineRun {
    std::string recorded_as; ///< reference, double, float: what the hashes are kept under
    std::int64_t frames = 0;
    std::string digest; ///< of all frames' hashes
    BaselineTotals totals;
    std::vector<KeyFrame> keys;
    RecordedHashes hashes;
};

/// A scenario's runs.
struct BaselineScenario {
    std::string name;
    std::filesystem::path file;
    std::vector<BaselineRun> runs;
};

struct Baseline {
    std::string version; ///< of the program that recorded it
    std::string commit;
    std::vector<BaselineScenario> scenarios;
};

/// \param data  the folder data/
/// \throws InputError for a file that isn't as it was written; hashes that don't belong to baseline.json
Baseline read_baseline(const std::filesystem::path& data);

/// Replaces data/baseline.json and data/hashes/ of its runs.
void write_baseline(const std::filesystem::path& data, const Baseline& baseline);

/// Makes the run again. \return nothing when `after_frame` ended it early
std::optional<BaselineRun> run_again(const Scenario& scenario, const backends::BackendChoice& choice,
                                     std::int64_t frames, const AfterFrame& after_frame);

/// In words how a run differs from the recorded one: first frame and fields with other bits, and by how much
/// which numbers differ. Empty: identical.
std::string difference(const BaselineRun& recorded, const BaselineRun& now);

} // namespace aneurysm::comparison
