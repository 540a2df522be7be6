// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/process/descriptors.hpp"

#include <filesystem>

namespace aneurysm::output
{

/// Keeps other processes from writing to a file, or into a folder, for as long as it lives. By flock; on a file system
/// that has none, by a file NAME.lock beside it (in a folder: .lock in it) that names the host and the process, and that
/// is taken over from a process of this host that is gone.
class Lock
{
public:
    /// \throws InputError when another process has it
    explicit Lock(std::filesystem::path locked);
    ~Lock();
    Lock(Lock&& other) noexcept;
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    Lock& operator=(Lock&&) = delete;

private:
    void make_file();

    std::filesystem::path locked_;
    std::filesystem::path file_; ///< empty: by flock
    Descriptor descriptor_;
};

} // namespace aneurysm::output
