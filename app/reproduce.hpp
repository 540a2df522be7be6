// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aneurysm::app
{

struct ReproduceOptions {
    std::vector<std::string> items; ///< table1 ... fig10; empty or "all": all
    std::filesystem::path out;
    backends::BackendChoice backend{Backend::cpu, Precision::float_};
    int seeds = 24;                ///< members of an ensemble
    std::optional<int> first_seed; ///< of the ensemble, or with `calibrate` of the calibration
    int jobs = 0;                  ///< runs at once; 0: one a core
    bool calibrate = false;        ///< fit what the paper doesn't give instead
};

/// `aneurysm reproduce`: runs what the items need, and writes data, pictures and reproduction.html. Runs that
/// are there already are used again.
/// \return 0; 130 when it was interrupted
/// \throws InputError, Error
int reproduce(const ReproduceOptions& options);

} // namespace aneurysm::app
