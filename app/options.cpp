// SPDX-License-Identifier: Apache-2.0
#include "app/options.hpp"

#include "common/error.hpp"

#include <charconv>
#include <exception>
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
    app.add_option("--threads", choice.threads, "of backend cpu; 0: as many as pay")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--block-size", choice.block_size,
                   "of backend cuda: GPU threads in a block, a multiple of 32; 0: the default")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
}

CLI::Validator at_least(std::int64_t least)
{
    const std::string allowed = "at least " + std::to_string(least);
    return {[least, allowed](const std::string& text) {
                std::int64_t number = 0;
                const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
                const bool good = end.ec == std::errc() && end.ptr == text.data() + text.size();
                return good && number >= least
                           ? std::string()
                           : "no whole number in range (" + text + "), allowed: " + allowed;
            },
            allowed};
}

CLI::Validator file_in_folder()
{
    return {[](const std::string& file) {
                const fs::path folder = fs::path(file).parent_path();
                return folder.empty() || fs::is_directory(folder)
                           ? std::string()
                           : "no such directory (" + folder.string() + "), needed: a file in one that exists";
            },
            "FILE"};
}

void make_report_directory(const fs::path& directory)
{
    std::error_code error;
    const bool exists = fs::exists(directory, error);
    if (exists && !(fs::is_directory(directory, error) && fs::is_empty(directory, error))) {
        throw InputError(directory.string(), "output directory exists and isn't empty",
                         "needed: another --out");
    }
    fs::create_directories(directory, error);
    if (error) {
        throw InputError(directory.string(), "output directory cannot be made (" + error.message() + ")",
                         "needed: a writable place");
    }
}

int run_program(CLI::App& app, const std::optional<int>& code, int argc, const char* const* argv)
{
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
    } catch (const InputError& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return exit_bad_input;
    } catch (const std::exception& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return exit_failed;
    }
}

} // namespace aneurysm::app
