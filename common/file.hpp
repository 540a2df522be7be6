// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace aneurysm
{

constexpr std::int64_t most_text = std::int64_t{64} << 20; ///< of what people write, and of a pipe [bytes]

/// All bytes of a file, or of a pipe or device up to its end.
/// \param most  bytes of a regular file; one of others is never longer than most_text
/// \throws InputError with `advice`
std::string read_text(const std::filesystem::path& file,
                      const std::string& advice = "needed: a readable file",
                      std::int64_t most = std::int64_t{1} << 40);

/// Whether something of that name is there. \throws InputError for a name that the system doesn't take
bool is_there(const std::filesystem::path& file);

/// Whether two names are those of one file that is there.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

} // namespace aneurysm
