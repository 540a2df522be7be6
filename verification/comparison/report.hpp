// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/comparison.hpp"

#include <string>

namespace aneurysm::comparison
{

/// What was compared with what.
struct ComparisonTitle {
    std::string mode; ///< lockstep, free, bits
    std::string scenario;
    std::string scenario_hash;
    backends::BackendChoice candidate;
    std::string device;
};

/// A table of all fields and the verdict, as text.
std::string report_text(const ComparisonTitle& title, const ComparisonResult& result);
/// The same and more as JSON: build, frames, and the worst ratio of each field in each frame.
std::string report_json(const ComparisonTitle& title, const ComparisonResult& result);

} // namespace aneurysm::comparison
