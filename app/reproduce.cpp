// SPDX-License-Identifier: Apache-2.0
#include "app/reproduce.hpp"

#include "app/options.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/scenario/shipped.hpp"
#include "output/file.hpp"
#include "output/lock.hpp"
#include "verification/reproduction/calibrate.hpp"
#include "verification/reproduction/items.hpp"

#include <algorithm>
#include <iostream>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;

struct ReproduceOptions {
    std::vector<std::string> items; ///< table1 ... fig10; empty or "all": all
    fs::path out = "results/paper";
    fs::path data; ///< of the project; empty: the shipped one
    backends::BackendChoice backend{Backend::cpu, Precision::float_};
    int seeds = 24;                ///< members of an ensemble
    std::optional<int> first_seed; ///< of the ensemble, or with `calibrate` of the calibration
    int jobs = 0;                  ///< runs at once; 0: as many as pay
    bool calibrate = false;        ///< fit what the paper doesn't give instead
};

std::vector<reproduction::Item> chosen(const std::vector<std::string>& words)
{
    const auto has = [&words](std::string_view word) {
        return std::ranges::find(words, word) != words.end();
    };
    std::vector<reproduction::Item> items = reproduction::all_items();
    if (!words.empty() && !has("all")) {
        std::erase_if(items, [&has](const reproduction::Item& item) { return !has(item.id); });
    }
    return items;
}

std::string command_of(const ReproduceOptions& options)
{
    std::string command = "aneurysm reproduce";
    for (const std::string& item : options.items) {
        command += " " + item;
    }
    command += options.items.empty() ? " all" : "";
    command += " --backend " + name_of(options.backend.backend) + " --precision " +
               name_of(options.backend.precision);
    command += " --seeds " + std::to_string(options.seeds);
    command += options.first_seed ? " --first-seed " + std::to_string(*options.first_seed) : "";
    return command + " --out DIR";
}

void print(const reproduction::Section& section)
{
    std::cout << section.title << "\n";
    for (const std::string& line : section.text) {
        std::cout << "  " << line << "\n";
    }
    for (const reproduction::Claim& claim : section.claims) {
        std::cout << "  " << verdict_of(claim) << ", " << basis_of(claim) << ": " << claim.words << " ("
                  << claim.found << ")\n";
    }
    std::cout << std::flush;
}

void print(const reproduction::ResultTable& table)
{
    std::cout << "  " << table.title << "\n" << to_csv(table) << std::flush;
}

void make_items(reproduction::Reproduction& reproduction, const ReproduceOptions& options)
{
    std::vector<reproduction::Section> sections;
    for (const reproduction::Item& item : chosen(options.items)) {
        std::cerr << item.title << "\n";
        sections.push_back(item.make(reproduction));
        reproduction.write(sections.back());
        print(sections.back());
        // After each item, so that what there is can be read.
        output::write_atomically(options.out / "reproduction.html",
                                 reproduction::page(sections, command_of(options)));
    }
    std::cout << "Open " << (options.out / "reproduction.html").string() << std::endl;
}

int reproduce(const ReproduceOptions& options)
{
    if (!options.data.empty()) {
        use_data_directory(options.data);
    }
    require_data();
    const InterruptWatch watch;
    reproduction::RunStore runs(options.out / "runs", options.backend, options.jobs);
    reproduction::Reproduction reproduction{runs, reproduction::read_data("paper.json"), options.out,
                                            options.seeds, options.first_seed.value_or(1)};
    fs::create_directories(options.out); // what is in it is used again
    const output::Lock lock(options.out);
    try {
        if (options.calibrate) {
            const reproduction::Section section = reproduction::calibrate(
                reproduction, reproduction::read_data("calibration.json"), options.first_seed);
            reproduction.write(section);
            print(section);
            print(section.tables.front());
        } else {
            make_items(reproduction, options);
        }
    } catch (const Interrupted&) {
        std::cerr << "interrupted; the same command goes on\n";
        return exit_interrupted;
    }
    return exit_done;
}

} // namespace

void add_reproduce(CLI::App& app, std::optional<int>& code)
{
    const auto options = std::make_shared<ReproduceOptions>();
    std::vector<std::string> words{"all"};
    for (const reproduction::Item& item : reproduction::all_items()) {
        words.emplace_back(item.id);
    }
    CLI::App* reproduce_app = app.add_subcommand("reproduce", "Reproduce the paper's tables and figures");
    reproduce_app->add_option("ITEM", options->items, "of the paper (default: all)")
        ->check(CLI::IsMember(words));
    add_directory(*reproduce_app, "--out", options->out,
                  "directory for data, pictures and reproduction.html; its runs are used again")
        ->default_str(options->out.string());
    add_backend(*reproduce_app, options->backend);
    constexpr std::int64_t most_seeds = 10'000;
    add_count(*reproduce_app, "--seeds", options->seeds, "members of the ensembles", 1, most_seeds)
        ->default_str(std::to_string(options->seeds));
    add_count(*reproduce_app, "--first-seed", options->first_seed,
              "of the ensembles (default: 1); with --calibrate of the calibration", 0, most_frames);
    add_count(*reproduce_app, "--jobs", options->jobs, "runs at once; 0: as many as pay", 0, most_at_once)
        ->default_str("0");
    add_input(*reproduce_app, "--data", options->data,
              "folder of the project's data (default: the shipped one)");
    add_progress(*reproduce_app);
    reproduce_app->add_flag("--calibrate", options->calibrate,
                            "fit what the paper doesn't give, as data/calibration.json says, instead");
    reproduce_app->footer(
        "Examples:\n"
        "  aneurysm reproduce\n"
        "  aneurysm reproduce table4 fig9 --seeds 2 --out results/two_seeds\n"
        "  aneurysm reproduce --calibrate --out results/calibration\n"
        "Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted (the same command goes on).");
    reproduce_app->callback([options, &code] { code = reproduce(*options); });
}

} // namespace aneurysm::app
