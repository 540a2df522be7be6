// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm::output
{

/// What this program was built from and how.
struct BuildInfo {
    const char* version;
    /// "unknown" without a repository of their own or git's mark in an archive; ends in -dirty when sources differ from it.
    const char* commit;
    const char* compiler;
    const char* flags;
};

BuildInfo build_info();

} // namespace aneurysm::output
