// SPDX-License-Identifier: Apache-2.0
#include "app/reproduce.hpp"

#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "output/file.hpp"
#include "verification/reproduction/calibrate.hpp"
#include "verification/reproduction/items.hpp"

#include <algorithm>
#include <iostream>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;

constexpr int interrupted = 130;

std::vector<reproduction::Item> chosen(const std::vector<std::string>& words)
{
    const bool all = words.empty() || std::ranges::find(words, "all") != words.end();
    std::vector<reproduction::Item> items;
    std::string names = "all";
    for (const reproduction::Item& item : reproduction::all_items()) {
        names += ", " + std::string(item.id);
        if (all || std::ranges::find(words, item.id) != words.end()) {
            items.push_back(item);
        }
    }
    for (const std::string& word : words) {
        if (word != "all" && std::ranges::find(reproduction::all_items(), word, &reproduction::Item::id) ==
                                 reproduction::all_items().end()) {
            throw InputError("ITEM", "unknown (" + word + ")", "allowed: " + names);
        }
    }
    return items;
}

void check(const ReproduceOptions& options)
{
    if (options.out.empty()) {
        throw InputError("--out", "no directory given",
                         "needed: --out DIR, new or of an earlier reproduction");
    }
    if (options.seeds < 1 || options.first_seed.value_or(1) < 0 || options.jobs < 0) {
        throw InputError("--seeds, --first-seed, --jobs", "out of range", "allowed: at least 1, 0 and 0");
    }
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
        std::cout << "  " << (claim.holds ? "holds: " : "DOES NOT HOLD: ") << claim.words << " ("
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

} // namespace

int reproduce(const ReproduceOptions& options)
{
    check(options);
    chosen(options.items);
    const InterruptWatch watch;
    reproduction::RunStore runs(options.out / "runs", options.backend, options.jobs);
    reproduction::Reproduction reproduction{runs, reproduction::read_data("paper.json"), options.out,
                                            options.seeds, options.first_seed.value_or(1)};
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
        return interrupted;
    }
    return 0;
}

const std::vector<reproduction::Item>& all_items()
{
    static const std::vector<reproduction::Item> items{
        {"table1", "Table 1: given values", reproduction::table1},
        {"table2", "Table 2: shapes", reproduction::table2},
        {"table3", "Table 3: frames per second", reproduction::table3},
        {"table4", "Table 4: frames of rupture", reproduction::table4},
        {"fig4", "Fig. 4: particles", reproduction::figure4},
        {"fig5", "Fig. 5: blood", reproduction::figure5},
        {"fig6", "Fig. 6: shapes", reproduction::figure6},
        {"fig7", "Fig. 7: impact, thickness and critical pressure by shape", reproduction::figure7},
        {"fig8", "Fig. 8: angles", reproduction::figure8},
        {"fig9", "Fig. 9: impact, critical pressure and thickness by Poisson's ratio", reproduction::figure9},
        {"fig10", "Fig. 10: radius and thickness at fixed growth", reproduction::figure10},
        {"errata", "Errata", reproduction::errata},
    };
    return items;
}

} // namespace aneurysm::app
