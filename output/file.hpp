// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/process/descriptors.hpp"
#include "output/lock.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::output
{

/// Replaces the file in one step: a temporary file beside it, synced, then renamed. Until then the old one stays. A link
/// is followed, and stays one. Into a device, a pipe, or what is our standard output or error, it writes as it is.
/// \throws Error that names the file and the system's reason
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// Why write_atomically couldn't write there; empty when it could.
std::string why_not_writable(const std::filesystem::path& file);

/// Directories that were made for a result. Gone again with their parents, as far as these were made for it, unless they
/// are kept.
class NewDirectory
{
public:
    enum class Allowed { nothing, empty_one };
    /// \param allowed  what may be there already
    /// \throws InputError, and nothing was made
    NewDirectory(std::filesystem::path directory, Allowed allowed);
    ~NewDirectory();
    NewDirectory(const NewDirectory&) = delete;
    NewDirectory(NewDirectory&&) = delete;
    NewDirectory& operator=(const NewDirectory&) = delete;
    NewDirectory& operator=(NewDirectory&&) = delete;

    void keep() { made_.clear(); }

private:
    void remove();

    std::vector<std::filesystem::path> made_; ///< the outermost first
};

/// The directory without slashes at its end and steps back (x/..), which would stand for another one once x is made.
std::filesystem::path plain(const std::filesystem::path& directory);

/// A text file that grows line by line. A line is in it whole or not
/// at all, and stays when the program is killed.
class LineFile
{
public:
    enum class Mode { create, append };
    /// \throws InputError; also when another process has the file open as a LineFile, see Lock
    LineFile(std::filesystem::path file, Mode mode);

    /// \throws Error; the lines before are then still there
    void append(const std::string& line);
    /// Onto the disk itself.
    void sync() const;
    /// Keeps the first `lines` lines. \throws InputError when there are fewer
    void keep(std::size_t lines);

private:
    std::filesystem::path file_;
    Descriptor descriptor_;
    std::int64_t size_ = 0; ///< of the whole lines [bytes]
    std::optional<Lock> lock_;
};

} // namespace aneurysm::output
