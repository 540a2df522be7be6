// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/comparison.hpp"
#include "verification/comparison/hash_file.hpp"
#include "verification/comparison/lockstep.hpp"

#include <optional>

namespace aneurysm::comparison
{

/// What the candidate's bits must be.
struct BitsOracles {
    Simulation* twin = nullptr;             ///< another executor of the same precision, at the same frame
    std::optional<RecordedHashes> recorded; ///< of an earlier run
};

/// Whether the hashes of all fields are the same in every frame. Nothing is allowed: one bit is a failure.
/// \param recording  not null: takes the candidate's hashes
ComparisonResult compare_bits(Simulation& candidate, const BitsOracles& oracles, std::int64_t frames,
                              const AfterFrame& after_frame, RecordedHashes* recording = nullptr);

} // namespace aneurysm::comparison
