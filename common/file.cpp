// SPDX-License-Identifier: Apache-2.0
#include "common/file.hpp"

#include "common/error.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace aneurysm
{

std::string read_text(const std::filesystem::path& file, const std::string& advice)
{
    if (std::error_code unused; std::filesystem::is_directory(file, unused)) {
        throw InputError(file.string(), "cannot be read (it is a directory)", advice);
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || (stream.peek() != std::ifstream::traits_type::eof() && !(text << stream.rdbuf()))) {
        throw InputError(file.string(), std::string("cannot be read (") + std::strerror(errno) + ")", advice);
    }
    return text.str();
}

} // namespace aneurysm
