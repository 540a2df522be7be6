// SPDX-License-Identifier: Apache-2.0
// What the commands share: options, and a program's way from the command line to its exit code.
#pragma once

#include "app/exit_codes.hpp"
#include "common/number.hpp"
#include "common/process/progress.hpp"
#include "output/lock.hpp"
#include "verification/backends/make_simulation.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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

/// Values by commas, none of them empty; the option may be given several times.
/// \param wrong  what is wrong with one of them; empty: nothing
/// \param take   gets one after the other
CLI::Option* add_list(CLI::App& app, const std::string& option, const std::string& help,
                      const std::function<std::string(const std::string&)>& wrong,
                      const std::function<void(const std::string&)>& take);

/// Words by commas.
CLI::Option* add_words(CLI::App& app, const std::string& option, std::vector<std::string>& values,
                       const std::string& help);

/// Values of an enumeration by commas.
template <class Enum, std::size_t n>
CLI::Option* add_choices(CLI::App& app, const std::string& option, std::vector<Enum>& values,
                         const std::array<std::string_view, n>& names, const std::string& help)
{
    const CLI::Validator check = one_of(names);
    return add_list(
               app, option, help, [check](const std::string& word) { return check(word); },
               [&values, &names](const std::string& word) { values.push_back(*value_of<Enum>(word, names)); })
        ->type_name(check.get_description() + ",...");
}

/// A whole number from `least` to `most`, as whole_number reads it.
CLI::Validator whole_from(std::int64_t least, std::int64_t most);

/// An option whose value is a whole number; `value` may be optional. Read as by the two
/// functions below: decimal, whole, in range.
template <class Value>
CLI::Option* add_count(CLI::App& app, const std::string& option, Value& value, const std::string& help,
                       std::int64_t least, std::int64_t most)
{
    return app
        .add_option_function<std::string>(
            option,
            [&value](const std::string& word) {
                if constexpr (std::is_integral_v<Value>) {
                    value = static_cast<Value>(*whole_number(word));
                } else {
                    value = static_cast<typename Value::value_type>(*whole_number(word));
                }
            },
            help)
        ->check(whole_from(least, most))
        ->type_name("INT");
}

/// Several whole numbers, by commas.
CLI::Option* add_counts(CLI::App& app, const std::string& option, std::vector<std::int64_t>& values,
                        const std::string& help, std::int64_t least, std::int64_t most);
/// Several finite numbers, by commas.
CLI::Option* add_numbers(CLI::App& app, const std::string& option, std::vector<double>& values,
                         const std::string& help);

inline constexpr std::int64_t most_frames = 1'000'000'000; ///< of a run, as of a scenario
inline constexpr std::int64_t most_at_once = 100'000;      ///< threads, runs, members: no machine has more

/// A file or directory that is read.
CLI::Option* add_input(CLI::App& app, const std::string& option, std::filesystem::path& value,
                       const std::string& help);
/// Several of them.
CLI::Option* add_inputs(CLI::App& app, const std::string& option, std::vector<std::filesystem::path>& values,
                        const std::string& help);
/// A directory that is made; a slash at its end is none of its name.
CLI::Option* add_directory(CLI::App& app, const std::string& option, std::filesystem::path& value,
                           const std::string& help);
/// A file that write_atomically writes; whether it can is found out before hours of work.
CLI::Option* add_output_file(CLI::App& app, const std::string& option, std::filesystem::path& value,
                             const std::string& help);

/// --progress and --quiet, which hold from then on.
std::shared_ptr<ProgressRhythm> add_progress(CLI::App& app);

/// --backend (or another name for it) and --precision.
void add_backend(CLI::App& app, backends::BackendChoice& choice, const std::string& option = "--backend",
                 const std::string& help = "who computes");
/// --threads and --block-size.
void add_tuning(CLI::App& app, backends::BackendChoice& choice);
/// Refuses those of the two that mean nothing to the backend, and takes as many threads as the system gives; a word on
/// stderr when these are fewer than asked for. \throws InputError
void settle_tuning(const CLI::App& app, backends::BackendChoice& choice);

/// An --out for reports, made or taken empty, where no other process writes meanwhile.
class ReportDirectory
{
public:
    /// \throws InputError
    explicit ReportDirectory(const std::filesystem::path& directory);

private:
    output::Lock lock_;
};

/// A program's whole course: reads the command line, whose callbacks do the work and set `code`. What goes
/// wrong is one line on stderr.
/// \return the exit code
int run_program(CLI::App& app, const std::optional<int>& code, int argc, const char* const* argv);

} // namespace aneurysm::app
