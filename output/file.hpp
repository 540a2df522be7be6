// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace aneurysm::output
{

/// Replaces the file in one step: a temporary file beside it, synced, then renamed. Until then the old one
/// stays. \throws Error that names the file and the system's reason
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

/// A text file that grows line by line. A line is in it whole or not
/// at all, and stays when the program is killed.
class LineFile
{
public:
    enum class Mode { create, append };
    /// \throws InputError; also when another process has the file open as a LineFile
    LineFile(std::filesystem::path file, Mode mode);
    ~LineFile();
    LineFile(LineFile&& other) noexcept;
    LineFile(const LineFile&) = delete;
    LineFile& operator=(const LineFile&) = delete;
    LineFile& operator=(LineFile&&) = delete;

    /// \throws Error; the lines before are then still there
    void append(const std::string& line);
    /// Onto the disk itself.
    void sync() const;
    /// Keeps the first `lines` lines. \throws InputError when there are fewer
    void keep(std::size_t lines);

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
    std::int64_t size_ = 0; ///< of the whole lines [bytes]
};

} // namespace aneurysm::output
