// SPDX-License-Identifier: Apache-2.0
// What the commands share: options, and a program's way from the command line to its exit code.
#pragma once

#include "app/exit_codes.hpp"
#include "verification/backends/make_simulation.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::app
{

/// The words of an enumeration, as a check of an option's value.
template <std::size_t n>
CLI::IsMember one_of(const std::array<std::string_view, n>& names)
{
    return CLI::IsMember(std::vector<std::string>(names.begin(), names.end()));
}

/// An option whose value is an enumeration's; `names` are its words, in its order.
template <class Enum, std::size_t n>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Enum& value,
                        const std::array<std::string_view, n>& names, const std::string& help)
{
    return app
        .add_option_function<std::string>(
            option, [&value, &names](const std::string& word) { value = *value_of<Enum>(word, names); }, help)
        ->check(one_of(names))
        ->default_str(std::string(names.at(static_cast<std::size_t>(value))));
}

/// The same for several values, by commas.
template <class Enum, std::size_t n>
CLI::Option* add_choices(CLI::App& app, const std::string& option, std::vector<Enum>& values,
                         const std::array<std::string_view, n>& names, const std::string& help)
{
    return app
        .add_option_function<std::vector<std::string>>(
            option,
            [&values, &names](const std::vector<std::string>& words) {
                for (const std::string& word : words) {
                    values.push_back(*value_of<Enum>(word, names));
                }
            },
            help)
        ->delimiter(',')
        ->check(one_of(names));
}

/// --backend (or another name for it) and --precision.
void add_backend(CLI::App& app, backends::BackendChoice& choice, const std::string& option = "--backend",
                 const std::string& help = "who computes");
/// --threads and --block-size.
void add_tuning(CLI::App& app, backends::BackendChoice& choice);

/// A count from `least` on.
CLI::Validator at_least(std::int64_t least);
/// A file in a folder that exists; found out before hours of work.
CLI::Validator file_in_folder();

/// Makes an --out, or takes an empty one. \throws InputError
void make_report_directory(const std::filesystem::path& directory);

/// A program's whole course: reads the command line, whose callbacks do the work and set `code`. What goes
/// wrong is one line on stderr.
/// \return the exit code
int run_program(CLI::App& app, const std::optional<int>& code, int argc, const char* const* argv);

} // namespace aneurysm::app
