// SPDX-License-Identifier: Apache-2.0
// Frames per second of the reference at the particle counts of the paper's Table 3. Prints the iterations and
// the density error beside each, for a speed without its error says nothing. Scenario files are named on the
// command line:
//
//     bench_reference data/scenarios/paper_tc1.json data/scenarios/paper_tc2.json
#include "common/error.hpp"
#include "common/scenario.hpp"
#include "reference/simulation.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace
{

/// Frames of the developed flow: the first 20, in which the blood starts to move, are not timed.
void frames(benchmark::State& state, const std::string& file)
{
    constexpr int start_up = 20;
    const aneurysm::Scenario scenario = aneurysm::read_scenario(file);
    aneurysm::reference::Simulation simulation(scenario);
    for (int frame = 0; frame < start_up; ++frame) {
        simulation.advance();
    }
    double iterations = 0;
    double error_mean = 0;
    double error_max = 0;
    double count = 0;
    for ([[maybe_unused]] auto _ : state) { // NOLINT(clang-analyzer-deadcode.DeadStores)
        const aneurysm::FrameRecord record = simulation.advance();
        iterations += static_cast<double>(record.iterations);
        error_mean += record.density_error_mean;
        error_max = std::max(error_max, record.density_error_max);
        ++count;
    }
    state.counters["FPS"] = benchmark::Counter(count, benchmark::Counter::kIsRate);
    state.counters["particles"] = static_cast<double>(scenario.particles.count);
    state.counters["iterations"] = iterations / count;
    state.counters["density_error_mean"] = error_mean / count;
    state.counters["density_error_max"] = error_max;
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    try {
        for (int i = 1; i < argc; ++i) {
            const std::string file = argv[i];
            aneurysm::read_scenario(file); // report a bad file before anything is timed
            benchmark::RegisterBenchmark(file.c_str(), frames, file)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
        benchmark::RunSpecifiedBenchmarks();
    } catch (const aneurysm::Error& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    return 0;
}
