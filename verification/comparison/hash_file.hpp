// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "verification/backends/make_simulation.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace aneurysm::comparison
{

/// The columns of a file of recorded hashes, without the frame's number: the fields of hashes.csv, and
/// `state`, the hash of everything.
std::vector<std::string> hash_columns();
/// 64-bit FNV-1a of each of them.
std::vector<std::string> hashes_of(const SimulationState& state);

/// The columns in which two of these differ.
std::vector<std::string> differing_columns(const std::vector<std::string>& a,
                                           const std::vector<std::string>& b);

/// Hashes that a run once had, by frame.
struct RecordedHashes {
    std::string scenario;      ///< its name
    std::string scenario_hash; ///< of its text then; another text, say with a new key, can have the same bits
    Precision precision = Precision::double_;
    std::map<std::int64_t, std::vector<std::string>> frames;
};

/// What a backend's bits are kept under: the optimized backends of one precision share theirs, those of the
/// reference are its own.
std::string recorded_as(const backends::BackendChoice& choice);

/// Where the hashes of a scenario file are kept: ../hashes/NAME.RECORDED_AS.csv beside its folder.
std::filesystem::path hash_file(const std::filesystem::path& scenario_file, const Scenario& scenario,
                                const backends::BackendChoice& choice);

/// CSV behind a comment that names scenario, the hash of its text,
/// the precision and the version that made them.
std::string to_csv(const RecordedHashes& hashes);

/// \throws InputError that names file and line when the file isn't as it was written, or is of another
/// scenario or precision
RecordedHashes read_hashes(const std::filesystem::path& file, const std::string& scenario,
                           Precision precision);

} // namespace aneurysm::comparison
