// SPDX-License-Identifier: Apache-2.0
#include "output/lock.hpp"

#include "common/error.hpp"
#include "common/number.hpp"
#include "output/provenance.hpp"

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

/// Two processes may find the same one gone: what is removed is a name of one's own, and what turns out to be another's
/// by then gets its name back.
void remove_stale(const fs::path& file)
{
    const std::string stale = file.string() + "." + std::to_string(::getpid());
    if (::rename(file.c_str(), stale.c_str()) != 0) {
        return;
    }
    if (!is_gone(read_owner(stale))) {
        static_cast<void>(::link(stale.c_str(), file.c_str())); // fails where somebody else has it already
    }
    ::unlink(stale.c_str());
}

[[noreturn]] void refuse(const fs::path& locked, const std::string& who, const std::string& advice)
{
    throw InputError(locked.string(), "another run writes here" + who,
                     "needed: wait for it, or another --out" + advice);
}

} // namespace

Lock::Lock(fs::path locked) : locked_(std::move(locked)), descriptor_(open_to_lock(locked_))
{
    if (!descriptor_.is_open()) {
        throw InputError(locked_.string(), std::string("cannot be opened (") + std::strerror(errno) + ")",
                         "needed: the run's own files");
    }
    if (::flock(descriptor_.number(), LOCK_EX | LOCK_NB) == 0) {
        return;
    }
    const bool taken = errno == EWOULDBLOCK;
    descriptor_.close();
    if (taken) {
        refuse(locked_, "", "");
    }
    make_file(); // ENOSYS, ENOLCK, EOPNOTSUPP, EBADF: this file system has no locks, or none of this kind
}

Lock::~Lock()
{
    if (!file_.empty()) {
        ::unlink(file_.c_str());
    }
}

Lock::Lock(Lock&& other) noexcept
    : locked_(std::move(other.locked_)), file_(std::exchange(other.file_, {})),
      descriptor_(std::move(other.descriptor_))
{
}

void Lock::make_file()
{
    const fs::path file =
        fs::is_directory(locked_) ? locked_ / ".lock" : fs::path(locked_.string() + ".lock");
    if (is_gone(read_owner(file))) {
        remove_stale(file);
    }
    const Descriptor made(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!made.is_open() && errno == EEXIST) {
        const Owner owner = read_owner(file);
        refuse(locked_, " (process " + std::to_string(owner.process) + " on " + owner.host + ")",
               "; if it is gone, remove " + file.string());
    }
    const std::string text = host() + " " + std::to_string(::getpid()) + "\n";
    if (!made.is_open() || ::write(made.number(), text.data(), text.size()) != std::ssize(text)) {
        const std::string why = std::strerror(errno);
        if (made.is_open()) {
            ::unlink(file.c_str());
        }
        throw InputError(file.string(), "cannot be written (" + why + ")", "needed: a writable place");
    }
    file_ = file;
}

} // namespace aneurysm::output
