// SPDX-License-Identifier: Apache-2.0
#include "output/lock.hpp"

#include "common/error.hpp"
#include "common/number.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

std::string host()
{
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// To write where that is possible: the locks of network file systems ask for it.
int open_to_lock(const fs::path& file)
{
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    return descriptor >= 0 ? descriptor : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
}

/// What a lock file says of who made it.
struct Owner {
    std::string host;
    pid_t process = 0;
};

Owner read_owner(const fs::path& file)
{
    Owner owner;
    std::ifstream stream(file);
    std::string process;
    stream >> owner.host >> process;
    owner.process = static_cast<pid_t>(whole_number(process).value_or(0));
    return owner;
}

/// A process of this host that has ended, and so can't have left the file on purpose.
bool is_gone(const Owner& owner)
{
    return owner.process > 0 && owner.host == host() && ::kill(owner.process, 0) != 0 && errno == ESRCH;
}

[[noreturn]] void refuse(const fs::path& locked, const std::string& who, const std::string& advice)
{
    throw InputError(locked.string(), "another run writes here" + who,
                     "needed: wait for it, or another --out" + advice);
}

} // namespace

Lock::Lock(fs::path locked) : locked_(std::move(locked)), descriptor_(open_to_lock(locked_))
{
    if (descriptor_ < 0) {
        throw InputError(locked_.string(), std::string("cannot be opened (") + std::strerror(errno) + ")",
                         "needed: the run's own files");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
        return;
    }
    const bool taken = errno == EWOULDBLOCK;
    ::close(std::exchange(descriptor_, -1));
    if (taken) {
        refuse(locked_, "", "");
    }
    make_file(); // ENOSYS, ENOLCK, EOPNOTSUPP, EBADF: this file system has no locks, or none of this kind
}

Lock::~Lock()
{
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!file_.empty()) {
        ::unlink(file_.c_str());
    }
}

Lock::Lock(Lock&& other) noexcept
    : locked_(std::move(other.locked_)), file_(std::exchange(other.file_, {})),
      descriptor_(std::exchange(other.descriptor_, -1))
{
}

void Lock::make_file()
{
    const fs::path file =
        fs::is_directory(locked_) ? locked_ / ".lock" : fs::path(locked_.string() + ".lock");
    if (is_gone(read_owner(file))) {
        ::unlink(file.c_str());
    }
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) {
        const Owner owner = read_owner(file);
        refuse(locked_, " (process " + std::to_string(owner.process) + " on " + owner.host + ")",
               "; if it is gone, remove " + file.string());
    }
    const std::string text = host() + " " + std::to_string(::getpid()) + "\n";
    if (descriptor < 0 || ::write(descriptor, text.data(), text.size()) != std::ssize(text)) {
        const std::string why = std::strerror(errno);
        if (descriptor >= 0) {
            ::close(descriptor);
            ::unlink(file.c_str());
        }
        throw InputError(file.string(), "cannot be written (" + why + ")", "needed: a writable place");
    }
    ::close(descriptor);
    file_ = file;
}

} // namespace aneurysm::output
