// SPDX-License-Identifier: Apache-2.0
#include "common/file.hpp"

#include "common/error.hpp"
#include "common/process/descriptors.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace aneurysm
{
namespace
{

namespace fs = std::filesystem;

/// A file that is read.
class Opened
{
public:
    explicit Opened(const fs::path& file) : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY))
    {
    }

    /// \return whether it was read up to its end, or up to one byte more than `most`; errno says why not
    bool read(std::string& text, std::size_t most) const
    {
        std::array<char, 1 << 16> piece{};
        while (text.size() <= most) {
            const ssize_t n =
                ::read(descriptor_.number(), piece.data(), std::min(piece.size(), most + 1 - text.size()));
            if (n < 0 && errno != EINTR) {
                return false;
            }
            if (n == 0) {
                return true;
            }
            text.append(piece.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
        }
        return true;
    }
    bool status(struct stat& found) const
    {
        return descriptor_.is_open() && ::fstat(descriptor_.number(), &found) == 0;
    }

private:
    Descriptor descriptor_;
};

} // namespace

std::string read_text(const fs::path& file, const std::string& advice, std::int64_t most)
{
    const auto fail = [&](const std::string& why) {
        throw InputError(file.string(), "cannot be read (" + why + ")", advice);
    };
    if (file.native().find('\0') != std::string::npos) {
        fail("no file has a NUL in its name");
    }
    const Opened opened(file);
    struct stat status {
    };
    if (!opened.status(status)) {
        fail(std::strerror(errno));
    }
    if (S_ISDIR(status.st_mode)) {
        fail("it is a directory");
    }
    const std::int64_t limit = S_ISREG(status.st_mode) ? most : std::min(most, most_text);
    std::string text;
    if (status.st_size <= limit) {
        text.reserve(static_cast<std::size_t>(status.st_size));
        if (!opened.read(text, static_cast<std::size_t>(limit))) {
            fail(std::strerror(errno));
        }
    }
    if (std::max<std::int64_t>(status.st_size, std::ssize(text)) > limit) {
        fail("it is larger than " + std::to_string(limit >> 20) + " MiB");
    }
    return text;
}

bool is_there(const fs::path& file)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::none) {
        throw InputError(file.string(), "cannot be used (" + error.message() + ")",
                         "needed: a name that the system takes, in a place that may be read");
    }
    return fs::exists(status);
}

bool same_file(const fs::path& a, const fs::path& b)
{
    std::error_code unused;
    return fs::equivalent(a, b, unused);
}

} // namespace aneurysm
