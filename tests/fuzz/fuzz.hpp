// SPDX-License-Identifier: Apache-2.0
// What the fuzz targets share: an input as a file, and what a reader may do with one.
#pragma once

#include "common/error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace aneurysm::test
{

/// Ends the process as a crash, for libFuzzer to keep the input, unless `good`.
inline void require(bool good, const std::string& what)
{
    if (!good) {
        std::fprintf(stderr, "not as required: %s\n", what.c_str());
        std::abort();
    }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory that holds an input, for readers that take a path.
class InputFile
{
public:
    explicit InputFile(std::string_view bytes) : descriptor_(memfd_create("input", MFD_CLOEXEC))
    {
        require(descriptor_ >= 0 &&
                    write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
                "a file in memory");
        path_ = "/proc/self/fd/" + std::to_string(descriptor_);
    }
    ~InputFile() { close(descriptor_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    int descriptor_;
    std::filesystem::path path_;
};

/// An InputError's line: "where: what; advice", of a length that can be read, and nothing that a terminal acts on.
inline void check_message(const InputError& error)
{
    constexpr std::size_t longest = 4000; // some advice lists all keys of a scenario
    const std::string_view line = error.what();
    require(!error.where().empty() && !error.fault().empty() && !error.advice().empty(),
            "where: what; advice");
    require(line.size() <= longest, "a message of a length that can be read");
    const auto acts = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; };
    require(std::none_of(line.begin(), line.end(), acts), "a message of one line: " + std::string(line));
}

/// Whether `read` takes an input. What it doesn't take it has to refuse by an InputError; all else that it throws goes
/// up, and ends the process.
template <class Read>
bool accepts(const Read& read)
{
    try {
        read();
        return true;
    } catch (const InputError& error) {
        check_message(error);
        return false;
    }
}

} // namespace aneurysm::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
