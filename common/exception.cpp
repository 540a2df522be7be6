// SPDX-License-Identifier: Apache-2.0
#include "common/exception.hpp"

#include "common/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <system_error>

namespace aneurysm
{
namespace
{

/// What the system says of a path that it was given, rather than of the disk below it.
bool blames_path(const std::error_code& code)
{
    constexpr std::array reasons{std::errc::filename_too_long,
                                 std::errc::too_many_symbolic_link_levels,
                                 std::errc::no_such_file_or_directory,
                                 std::errc::not_a_directory,
                                 std::errc::permission_denied,
                                 std::errc::operation_not_permitted,
                                 std::errc::invalid_argument,
                                 std::errc::file_exists,
                                 std::errc::is_a_directory,
                                 std::errc::directory_not_empty};
    return std::ranges::any_of(reasons, [&code](std::errc reason) { return code == reason; });
}

std::string text(const std::string& where, const std::string& fault, const std::string& advice)
{
    return Error(where, fault, advice).what();
}

} // namespace

bool is_bad_input(const std::exception& error)
{
    const auto* const file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    return dynamic_cast<const InputError*>(&error) != nullptr ||
           (file != nullptr && blames_path(file->code()));
}

std::string text_of(const std::exception& error)
{
    if (dynamic_cast<const Error*>(&error) != nullptr) {
        return error.what();
    }
    if (const auto* const file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
        return text(file->path1().string(), "cannot be used (" + file->code().message() + ")",
                    "needed: a path that the system takes, in a place with enough space");
    }
    if (const auto* const system = dynamic_cast<const std::system_error*>(&error)) {
        return system->code() == std::errc::resource_unavailable_try_again
                   ? text(
                         "threads", "the system gives no more of them (" + system->code().message() + ")",
                         "needed: fewer by --threads or --jobs, or a higher limit (ulimit -u, pids of a container)")
                   : text("the system", system->what(), "needed: that it lets the program go on");
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
        dynamic_cast<const std::length_error*>(&error) != nullptr) {
        return text("memory", std::string("there is not enough (") + error.what() + ")",
                    "needed: more, or fewer particles (particles.count) or runs at once (--jobs)");
    }
    if (dynamic_cast<const nlohmann::json::exception*>(&error) != nullptr) {
        return text("JSON", error.what(), "needed: files as they were written");
    }
    return text("program", std::string("an unforeseen fault (") + error.what() + ")",
                "please report it with the command and the scenario");
}

} // namespace aneurysm
