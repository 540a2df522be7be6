// SPDX-License-Identifier: Apache-2.0
// Rows of frames.csv and hashes.csv.
#pragma once

#include "common/frame.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::output
{

/// The columns' names, with their units.
std::string frames_header();
/// One frame; every double with as many digits as it needs to be read back to the same bits.
std::string frames_row(const FrameRecord& record);
/// \throws InputError that names file and line
std::vector<FrameRecord> read_frames(const std::filesystem::path& file);

/// 64-bit FNV-1a of each field of a state, as 16 hex digits.
std::string hashes_header();
std::string hashes_row(const SimulationState& state);
/// Of everything in the state.
std::string state_hash(const SimulationState& state);

} // namespace aneurysm::output
