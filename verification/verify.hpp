// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::verification
{

struct VerifyOptions {
    std::filesystem::path out;           ///< directory for the reports; must not exist, or be empty
    bool quick = false;                  ///< only checks that take seconds; also without it
    bool full = false;                   ///< also checks that take minutes
    std::vector<std::string> only;       ///< see select; empty: all
    std::vector<std::string> backends;   ///< see make_subjects; empty: all
    std::vector<std::string> precisions; ///< of cpu and cuda; empty: both
    int jobs = 0;                        ///< checks at once; 0: as many as there are cores
};

/// `aneurysm verify`: runs the suite, prints a summary, writes report.html, .json, .md and junit.xml.
/// \return 0 when all that was run holds, 3 when not, 130 when interrupted
/// \throws InputError before anything is computed or written
int verify(const VerifyOptions& options);

} // namespace aneurysm::verification
