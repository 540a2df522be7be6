// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::app
{

struct VerifyOptions {
    std::filesystem::path out;         ///< directory for the reports; must not exist, or be empty
    bool quick = false;                ///< only checks that take seconds; also without it
    bool full = false;                 ///< also checks that take minutes
    std::vector<std::string> only;     ///< see select; empty: all
    std::vector<Backend> backends;     ///< see make_subjects; empty: all
    std::vector<Precision> precisions; ///< of cpu and cuda; empty: both
    int jobs = 0;                      ///< checks at once; 0: as many as there are cores

    bool baseline = false;      ///< instead: recorded runs; `only` names scenarios then
    bool record = false;        ///< with `baseline`: write data/ anew
    std::filesystem::path data; ///< where the baseline is; empty: data_directory

    bool sensitivity = false;   ///< instead: faults planted in the equations
    std::string faults = "all"; ///< which: all, ci
};

/// `aneurysm verify`: runs the suite, prints a summary, writes report.html, .json, .md and junit.xml; or does
/// what another of the options asks for.
/// \return 0 when all that was run holds, exit_failed when not, exit_interrupted
/// \throws InputError before anything is computed or written
int verify(const VerifyOptions& options);

inline constexpr int exit_failed = 3;
inline constexpr int exit_interrupted = 130;

/// Makes an --out, or takes an empty one. \throws InputError
void make_report_directory(const std::filesystem::path& directory);
/// `jobs`, or as many as there are cores for 0. \throws InputError when negative
int threads_of(int jobs);
std::string joined(const std::vector<std::string>& words); ///< by commas

} // namespace aneurysm::app
