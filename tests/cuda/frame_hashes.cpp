// SPDX-License-Identifier: Apache-2.0
// Runs a scenario on the CPU executor as this program was compiled, and compares the hashes of every frame
// with the recorded ones:
//
//     frame_hashes SCENARIO FRAMES
//
// CMake builds it several times: with other optimization, without vectors, by another compiler.
#include "common/error.hpp"
#include "cuda/simulation.hpp"
#include "verification/comparison/hash_file.hpp"

#include <charconv>
#include <iostream>
#include <string>

namespace
{

using namespace aneurysm;

/// Frames whose hashes are not the recorded ones; every frame must be recorded.
int differing(const std::string& file, Precision precision, int threads, int frames)
{
    const Scenario scenario = read_scenario(file);
    const auto recorded = comparison::read_hashes(
        comparison::hash_file(file, scenario, {Backend::cpu, precision}), scenario.name, precision);
    device::Tuning tuning;
    tuning.threads = threads;
    const auto simulation = device::make_cpu_simulation(scenario, precision, tuning, std::nullopt);
    int wrong = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        simulation->advance();
        const auto expected = recorded.frames.find(frame);
        const bool same = expected != recorded.frames.end() &&
                          comparison::hashes_of(simulation->state()) == expected->second;
        wrong += same ? 0 : 1;
    }
    std::cout << scenario.name << ", " << name_of(precision) << ", " << threads
              << " threads: " << frames - wrong << " of " << frames << " frames have the recorded bits\n";
    return wrong;
}

} // namespace

int main(int argc, char** argv)
{
    int frames = 0;
    if (argc == 3) {
        const std::string text = argv[2];
        std::from_chars(text.data(), text.data() + text.size(), frames);
    }
    if (frames < 1) {
        std::cerr << "usage: frame_hashes SCENARIO FRAMES\n";
        return 2;
    }
    try {
        int wrong = 0;
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            for (const int threads : {1, 2}) {
                wrong += differing(argv[1], precision, threads, frames);
            }
        }
        return wrong == 0 ? 0 : 1;
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
