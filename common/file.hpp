// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace aneurysm
{

/// All bytes of a file. \throws InputError with `advice`
std::string read_text(const std::filesystem::path& file,
                      const std::string& advice = "needed: a readable file");

} // namespace aneurysm
