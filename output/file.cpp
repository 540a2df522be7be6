// SPDX-License-Identifier: Apache-2.0
#include "output/file.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/process/interrupt.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <sys/stat.h>
#include <thread>
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
    /// \param mode  of the file that is replaced, or what umask leaves of 0666
    Temporary(const fs::path& final_name, std::optional<mode_t> mode)
        : final_(final_name), path_(name_beside(final_name)),
          descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666))
    {
        if (descriptor_.is_open() && mode) {
            static_cast<void>(::fchmod(descriptor_.number(), *mode));
        }
    }
    ~Temporary()
    {
        if (!kept_) {
            ::unlink(path_.c_str());
        }
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    bool made() const { return descriptor_.is_open(); }
    void write(std::string_view bytes) const
    {
        if (!write_all(descriptor_.number(), bytes)) {
            fail_write(final_);
        }
    }
    /// \return whether it has the file's name; errno says why not
    bool keep()
    {
        if (::fsync(descriptor_.number()) != 0 || !descriptor_.close()) {
            fail_write(final_);
        }
        kept_ = std::rename(path_.c_str(), final_.c_str()) == 0;
        return kept_;
    }

private:
    static fs::path name_beside(const fs::path& file)
    {
        constexpr std::size_t longest = 255;
        const std::string name = file.filename().string() + ".tmp";
        return file.parent_path() / (name.size() > longest ? ".aneurysm.tmp" : name);
    }

    fs::path final_;
    fs::path path_;
    Descriptor descriptor_;
    bool kept_ = false;
};

/// What a name leads to, links followed; it needn't be there. \throws fs::filesystem_error for a ring of links
fs::path target_of(fs::path file)
{
    constexpr int most_links = 40;
    for (int k = 0; k < most_links && fs::is_symlink(fs::symlink_status(file)); ++k) {
        const fs::path to = fs::read_symlink(file);
        file = to.is_absolute() ? to : file.parent_path() / to;
    }
    return file;
}

/// Standard output or error, when the file is that; else -1.
int standard_descriptor(const struct stat& file)
{
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat own {
        };
        if (::fstat(descriptor, &own) == 0 && own.st_dev == file.st_dev && own.st_ino == file.st_ino) {
            return descriptor;
        }
    }
    return -1;
}

/// A pipe without a reader is waited for, until somebody presses Ctrl-C.
int open_pipe(const fs::path& file)
{
    while (true) {
        const int descriptor = ::open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor >= 0) {
            ::fcntl(descriptor, F_SETFL, O_WRONLY);
            return descriptor;
        }
        if (errno != ENXIO || InterruptWatch::interrupted()) {
            return -1;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// Whether errno says that a file can't be replaced where it is, though it may be written: it lies in a folder that may not
/// be, or is mounted by itself. Not that the disk is full, which would cost the old file.
bool is_fixed_there()
{
    return errno == EACCES || errno == EPERM || errno == EROFS || errno == EBUSY || errno == EXDEV;
}

/// Into what is there: a device, a pipe, an own descriptor, or a file that can't be replaced.
void write_into(const fs::path& file, const struct stat& status, std::string_view bytes)
{
    const int own = standard_descriptor(status);
    const Descriptor opened(own >= 0 ? ::dup(own)
                            : S_ISFIFO(status.st_mode)
                                ? open_pipe(file)
                                : ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC | O_NOCTTY));
    if (!opened.is_open() || !write_all(opened.number(), bytes)) {
        fail_write(file);
    }
}

/// Makes a rename in this directory last; not every file system can, and none needs it to be readable.
void sync_directory(const fs::path& directory)
{
    const Descriptor descriptor(
        ::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    static_cast<void>(::fsync(descriptor.number()));
}

} // namespace

void write_atomically(const fs::path& file, std::string_view bytes)
{
    struct stat status {
    };
    const bool exists = ::stat(file.c_str(), &status) == 0;
    if (exists && (!S_ISREG(status.st_mode) || standard_descriptor(status) >= 0)) {
        write_into(file, status, bytes);
        return;
    }
    const fs::path target = target_of(file);
    Temporary temporary(target, exists ? std::optional(status.st_mode & 07777) : std::nullopt);
    bool kept = false;
    if (temporary.made()) {
        temporary.write(bytes);
        kept = temporary.keep();
    }
    if (!kept) {
        if (!exists || !is_fixed_there()) {
            fail_write(file);
        }
        write_into(file, status, bytes);
    }
    sync_directory(target.parent_path());
}

std::string why_not_writable(const fs::path& file)
{
    if (!file.has_filename()) {
        return "no name of a file (" + file.string() + ")";
    }
    struct stat status {
    };
    if (::stat(file.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) {
            return "a directory (" + file.string() + ")";
        }
        return ::access(file.c_str(), W_OK) == 0 ? "" : reason() + " (" + file.string() + ")";
    }
    if (errno != ENOENT) {
        return reason() + " (" + file.string() + ")";
    }
    const fs::path target = target_of(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (std::error_code unused; !fs::is_directory(folder, unused)) {
        return "no such directory (" + folder.string() + ")";
    }
    return ::access(folder.c_str(), W_OK | X_OK) == 0 ? "" : reason() + " (" + folder.string() + ")";
}

fs::path plain(const fs::path& directory)
{
    fs::path path = directory;
    if (std::ranges::find(path, "..") != path.end()) {
        std::error_code error;
        const fs::path known = fs::weakly_canonical(path, error);
        path = error ? path.lexically_normal() : known;
    }
    while (!path.has_filename() && path.has_relative_path()) {
        path = path.parent_path();
    }
    return path;
}

NewDirectory::NewDirectory(fs::path directory, Allowed allowed)
{
    directory = plain(directory);
    const auto fail = [&](const std::string& why) {
        const bool of_a_run = allowed == Allowed::nothing;
        throw InputError(directory.string(), "output directory cannot be made (" + why + ")",
                         std::string("needed: a name that doesn't exist yet, in a writable place") +
                             (of_a_run ? ", or --resume" : ""));
    };
    if (directory.empty()) {
        fail("empty name");
    }
    std::vector<fs::path> missing;
    for (fs::path path = directory; !path.empty() && !is_there(path); path = path.parent_path()) {
        missing.push_back(path);
    }
    std::error_code error;
    if (missing.empty() && allowed == Allowed::nothing) {
        fail("it exists");
    }
    if (missing.empty() && !(fs::is_directory(directory, error) && fs::is_empty(directory, error))) {
        throw InputError(directory.string(), "output directory exists and isn't empty",
                         "needed: another --out");
    }
    for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
        const bool made = fs::create_directory(*path, error);
        if (made) {
            made_.push_back(*path);
        }
        // Another process may make a parent at the same time, but not the directory itself.
        if (error || (!made && std::next(path) == missing.rend())) {
            const std::string why = error ? error.message() : "it exists";
            remove();
            fail(why);
        }
    }
}

NewDirectory::~NewDirectory()
{
    remove();
}

/// Only what is empty: others may have put something there.
void NewDirectory::remove()
{
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
        ::rmdir(path->c_str());
    }
    made_.clear();
}

LineFile::LineFile(fs::path file, Mode mode)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(),
                         O_RDWR | O_APPEND | O_CLOEXEC | (mode == Mode::create ? O_CREAT | O_EXCL : 0), 0666))
{
    const auto fail = [this](const std::string& why) {
        throw InputError(file_.string(), "cannot be written (" + why + ")", "needed: a writable place");
    };
    if (!descriptor_.is_open()) {
        fail(reason());
    }
    lock_.emplace(file_);
    struct stat status {
    };
    if (::fstat(descriptor_.number(), &status) != 0) {
        fail(reason());
    }
    size_ = status.st_size;
}

void LineFile::append(const std::string& line)
{
    const std::string text = line + "\n";
    if (!write_all(descriptor_.number(), text)) {
        const int error = errno;
        const bool whole_lines = ::ftruncate(descriptor_.number(), size_) == 0;
        errno = error;
        fail_write(whole_lines ? file_ : fs::path(file_.string() + " (the last line is not whole)"));
    }
    size_ += static_cast<std::int64_t>(text.size());
}

void LineFile::sync() const
{
    if (::fsync(descriptor_.number()) != 0 && errno != EINVAL) { // EINVAL: not a disk file, such as /dev/full
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
    if (::ftruncate(descriptor_.number(), size_) != 0) {
        fail_write(file_);
    }
}

} // namespace aneurysm::output
