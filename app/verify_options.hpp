// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "common/process/progress.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace aneurysm::app
{

/// Of `aneurysm verify`, in all that it can be asked for.
struct VerifyOptions {
    std::filesystem::path out;         ///< directory for the reports; must not exist, or be empty
    bool quick = false;                ///< only checks that take seconds; also without it
    bool full = false;                 ///< also checks that take minutes
    std::vector<std::string> only;     ///< see select; empty: all
    std::vector<Backend> backends;     ///< see make_subjects; empty: all
    std::vector<Precision> precisions; ///< of cpu and cuda; empty: both
    int jobs = 0;                      ///< checks at once; 0: as many as pay

    bool baseline = false;      ///< instead: recorded runs; `only` names scenarios then
    bool record = false;        ///< with `baseline`: write data/ anew
    std::filesystem::path data; ///< of the project; empty: the shipped one

    bool sensitivity = false;    ///< instead: faults planted in the equations
    std::string mutants = "all"; ///< which: all, ci

    std::shared_ptr<ProgressRhythm> progress; ///< as chosen
};

} // namespace aneurysm::app
