// SPDX-License-Identifier: Apache-2.0
#include "app/options.hpp"

#include "common/error.hpp"
#include "common/exception.hpp"
#include "common/parallel.hpp"
#include "common/process/descriptors.hpp"
#include "common/text.hpp"
#include "output/file.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>

namespace aneurysm::app
{

namespace fs = std::filesystem;

void add_backend(CLI::App& app, backends::BackendChoice& choice, const std::string& option,
                 const std::string& help)
{
    add_choice(app, option, choice.backend, backend_names, help);
    add_choice(app, "--precision", choice.precision, precision_names, "of its flow");
}

void add_tuning(CLI::App& app, backends::BackendChoice& choice)
{
    add_count(app, "--threads", choice.threads, "of backend cpu; 0: as many as pay", 0, most_at_once)
        ->default_str("0");
    add_count(app, "--block-size", choice.block_size,
              "of backend cuda: GPU threads in a block, a multiple of 32; 0: the default", 0, most_at_once)
        ->default_str("0");
}

void settle_tuning(const CLI::App& app, backends::BackendChoice& choice)
{
    const auto refuse_unless = [&](Backend backend, const char* option) {
        if (choice.backend != backend && app.count(option) > 0) {
            throw InputError(option, "means nothing to backend " + name_of(choice.backend),
                             "allowed: with backend " + name_of(backend));
        }
    };
    refuse_unless(Backend::cpu, "--threads");
    refuse_unless(Backend::cuda, "--block-size");
    const int given = choice.threads > 1 ? startable_threads(choice.threads) : choice.threads;
    if (given < choice.threads) {
        std::cerr << "aneurysm: --threads: " << given << " instead of " << choice.threads
                  << ", as many as can work at once here; the bits don't depend on it\n";
        choice.threads = given;
    }
}

CLI::Validator whole_from(std::int64_t least, std::int64_t most)
{
    const std::string allowed = std::to_string(least) + " to " + std::to_string(most);
    return {[=](const std::string& text) {
                const std::optional<std::int64_t> number = whole_number(text);
                return number && *number >= least && *number <= most
                           ? std::string()
                           : "no whole number in range (" + text + "), allowed: " + allowed;
            },
            allowed};
}

namespace
{

std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> words;
    std::size_t start = 0;
    for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1) {
        comma = text.find(',', start);
        words.push_back(text.substr(start, comma - start));
    }
    return words;
}

} // namespace

CLI::Option* add_list(CLI::App& app, const std::string& option, const std::string& help,
                      const std::function<std::string(const std::string&)>& wrong,
                      const std::function<void(const std::string&)>& take)
{
    const auto check = [wrong](const std::string& text) {
        for (const std::string& word : split(text)) {
            const std::string why = word.empty() ? "an empty word (" + text + ")" : wrong(word);
            if (!why.empty()) {
                return why;
            }
        }
        return std::string();
    };
    const auto take_all = [take](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            std::ranges::for_each(split(text), take);
        }
    };
    // Not CLI11's own delimiter, which passes empty words over and goes on with the next argument.
    return app.add_option_function<std::vector<std::string>>(option, take_all, help)
        ->allow_extra_args(false)
        ->check(CLI::Validator(check, ""));
}

CLI::Option* add_words(CLI::App& app, const std::string& option, std::vector<std::string>& values,
                       const std::string& help)
{
    return add_list(
               app, option, help, [](const std::string&) { return std::string(); },
               [&values](const std::string& word) { values.push_back(word); })
        ->type_name("WORD,...");
}

CLI::Option* add_counts(CLI::App& app, const std::string& option, std::vector<std::int64_t>& values,
                        const std::string& help, std::int64_t least, std::int64_t most)
{
    const CLI::Validator check = whole_from(least, most);
    return add_list(
               app, option, help, [check](const std::string& word) { return check(word); },
               [&values](const std::string& word) { values.push_back(*whole_number(word)); })
        ->type_name("INT,...");
}

CLI::Option* add_numbers(CLI::App& app, const std::string& option, std::vector<double>& values,
                         const std::string& help)
{
    const auto wrong = [](const std::string& word) {
        return finite_number(word) ? std::string() : "no finite number (" + word + ")";
    };
    return add_list(app, option, help, wrong,
                    [&values](const std::string& word) { values.push_back(*finite_number(word)); })
        ->type_name("NUMBER,...");
}

namespace
{

const CLI::Validator& named()
{
    static const CLI::Validator check(
        [](const std::string& word) { return word.empty() ? std::string("an empty name") : std::string(); },
        "");
    return check;
}

CLI::Option* add_path(CLI::App& app, const std::string& option, const std::string& help,
                      const std::string& type, const std::function<void(const std::string&)>& take)
{
    return app.add_option_function<std::string>(option, take, help)->check(named())->type_name(type);
}

} // namespace

CLI::Option* add_input(CLI::App& app, const std::string& option, fs::path& value, const std::string& help)
{
    return add_path(app, option, help, "PATH", [&value](const std::string& word) { value = word; });
}

CLI::Option* add_inputs(CLI::App& app, const std::string& option, std::vector<fs::path>& values,
                        const std::string& help)
{
    const auto take = [&values](const std::vector<std::string>& words) {
        values.assign(words.begin(), words.end());
    };
    return app.add_option_function<std::vector<std::string>>(option, take, help)
        ->check(named())
        ->type_name("PATH");
}

CLI::Option* add_directory(CLI::App& app, const std::string& option, fs::path& value, const std::string& help)
{
    return add_path(app, option, help, "DIR",
                    [&value](const std::string& word) { value = output::plain(word); });
}

CLI::Option* add_output_file(CLI::App& app, const std::string& option, fs::path& value,
                             const std::string& help)
{
    return add_path(app, option, help, "FILE", [&value](const std::string& word) { value = word; })
        ->check(CLI::Validator([](const std::string& word) { return output::why_not_writable(word); }, ""));
}

std::shared_ptr<ProgressRhythm> add_progress(CLI::App& app)
{
    constexpr double most = 1e6;
    const auto rhythm = std::make_shared<ProgressRhythm>();
    const auto check = [](const std::string& word) {
        const std::optional<double> seconds = finite_number(word);
        return seconds && *seconds > 0 && *seconds <= most
                   ? std::string()
                   : "no number of seconds (" + word + "), allowed: above 0, up to 1000000";
    };
    CLI::Option* const progress =
        app.add_option_function<std::string>(
               "--progress",
               [rhythm](const std::string& word) {
                   rhythm->seconds = finite_number(word);
                   Progress::set_rhythm(*rhythm);
               },
               "say each so many seconds how far it is, in lines (default: 30 where stderr is no terminal)")
            ->check(CLI::Validator(check, ""))
            ->type_name("SECONDS");
    app.add_flag_callback(
           "--quiet",
           [rhythm] {
               rhythm->quiet = true;
               Progress::set_rhythm(*rhythm);
           },
           "never say how far it is")
        ->excludes(progress);
    return rhythm;
}

namespace
{

fs::path made_for_reports(const fs::path& directory)
{
    output::NewDirectory made(directory, output::NewDirectory::Allowed::empty_one);
    made.keep();
    return output::plain(directory);
}

} // namespace

ReportDirectory::ReportDirectory(const fs::path& directory) : lock_(made_for_reports(directory)) {}

int run_program(CLI::App& app, const std::optional<int>& code, int argc, const char* const* argv)
{
    fill_standard_descriptors();
    try {
        try {
            app.parse(argc, argv);
        } catch (const CLI::Success& help) {
            return app.exit(help); // --help, --version
        } catch (const CLI::ParseError& error) {
            throw InputError("command line", error.what(), "see " + app.get_name() + " --help");
        }
        if (!code) {
            throw InputError("command line", "no subcommand given", "see " + app.get_name() + " --help");
        }
        if (!std::cout.flush()) {
            throw Error("standard output", "cannot be written", "needed: a place with enough space");
        }
        return *code;
    } catch (const std::exception& error) {
        std::cerr << "aneurysm: " << one_line(text_of(error)) << "\n";
        return is_bad_input(error) ? exit_bad_input : exit_failed;
    }
}

} // namespace aneurysm::app
