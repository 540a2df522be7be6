// SPDX-License-Identifier: Apache-2.0
#include "output/file.hpp"

#include "common/error.hpp"
#include "common/file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

std::string reason()
{
    return std::strerror(errno);
}

[[noreturn]] void fail_write(const fs::path& file)
{
    throw Error(file.string(), "cannot be written (" + reason() + ")",
                "needed: a writable place with enough space; what was complete is kept");
}

/// \return whether it could be written; errno says why not
bool write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(n > 0 ? static_cast<std::size_t>(n) : 0);
    }
    return true;
}

/// A file descriptor that is closed, and whose file is removed unless it was kept.
class Temporary
{
public:
    explicit Temporary(const fs::path& final_name)
        : final_(final_name), path_(final_name.string() + ".tmp"),
          descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
    {
        if (descriptor_ < 0) {
            fail_write(final_);
        }
    }
    ~Temporary()
    {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        if (!kept_) {
            ::unlink(path_.c_str());
        }
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    void write(std::string_view bytes) const
    {
        if (!write_all(descriptor_, bytes)) {
            fail_write(final_);
        }
    }
    void keep()
    {
        if (::fsync(descriptor_) != 0 || ::close(std::exchange(descriptor_, -1)) != 0 ||
            std::rename(path_.c_str(), final_.c_str()) != 0) {
            fail_write(final_);
        }
        kept_ = true;
    }

private:
    fs::path final_;
    fs::path path_;
    int descriptor_;
    bool kept_ = false;
};

/// Makes a rename in this directory last; not every file system can, and none needs it to be readable.
void sync_directory(const fs::path& directory)
{
    const int descriptor =
        ::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        static_cast<void>(::fsync(descriptor));
        ::close(descriptor);
    }
}

} // namespace

void write_atomically(const fs::path& file, std::string_view bytes)
{
    Temporary temporary(file);
    temporary.write(bytes);
    temporary.keep();
    sync_directory(file.parent_path());
}

LineFile::LineFile(fs::path file, Mode mode)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(),
                         O_RDWR | O_APPEND | O_CLOEXEC | (mode == Mode::create ? O_CREAT | O_EXCL : 0), 0666))
{
    const auto fail = [this](const std::string& why) {
        throw InputError(file_.string(), "cannot be written (" + why + ")", "needed: a writable place");
    };
    if (descriptor_ < 0) {
        fail(reason());
    }
    struct stat status {
    };
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 || ::fstat(descriptor_, &status) != 0) {
        const bool locked = errno == EWOULDBLOCK;
        const std::string why = reason();
        ::close(std::exchange(descriptor_, -1));
        if (locked) {
            throw InputError(file_.string(), "another run writes here",
                             "needed: wait for it, or another --out");
        }
        fail(why);
    }
    size_ = status.st_size;
}

LineFile::~LineFile()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

LineFile::LineFile(LineFile&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_)
{
}

void LineFile::append(const std::string& line)
{
    const std::string text = line + "\n";
    if (!write_all(descriptor_, text)) {
        const int error = errno;
        const bool whole_lines = ::ftruncate(descriptor_, size_) == 0;
        errno = error;
        fail_write(whole_lines ? file_ : fs::path(file_.string() + " (the last line is not whole)"));
    }
    size_ += static_cast<std::int64_t>(text.size());
}

void LineFile::sync() const
{
    if (::fsync(descriptor_) != 0 && errno != EINVAL) { // EINVAL: not a disk file, such as /dev/full
        fail_write(file_);
    }
}

void LineFile::keep(std::size_t lines)
{
    const std::string text = read_text(file_);
    std::size_t end = 0;
    for (std::size_t line = 0; line < lines; ++line) {
        end = text.find('\n', end);
        if (end == std::string::npos) {
            throw InputError(file_.string(),
                             "has fewer lines (" + std::to_string(line) +
                                 ") than its checkpoint's frame needs",
                             "needed: the file as the run left it, with at least " + std::to_string(lines));
        }
        ++end;
    }
    size_ = static_cast<std::int64_t>(end);
    if (::ftruncate(descriptor_, size_) != 0) {
        fail_write(file_);
    }
}

} // namespace aneurysm::output
