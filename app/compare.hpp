// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace aneurysm::app
{

struct CompareOptions {
    std::filesystem::path scenario;
    backends::BackendChoice candidate;
    std::string mode = "lockstep";      ///< lockstep, free, bits
    std::optional<std::int64_t> frames; ///< to compare, instead of up to the scenario's last
    std::int64_t from = 0;              ///< the candidate makes this many frames first
    int ensemble = 8;                   ///< members, in mode free
    std::filesystem::path record;       ///< file for the candidate's hashes, in mode bits; empty: none
    std::filesystem::path report;       ///< JSON; empty: none
};

/// `aneurysm compare`: a candidate against the reference. Prints a table and the verdict.
/// \return 0 when all is within its bounds, 3 when not, 130 when interrupted
/// \throws InputError before anything is computed
int compare(const CompareOptions& options);

} // namespace aneurysm::app
