// SPDX-License-Identifier: Apache-2.0
// The CUDA code on an emulated GPU: the same bits as the CPU's, whatever the size of its blocks, and in
// whatever order its threads run. What a real one does with it `verification/gpu_check.sh` shows.
#include "common/scenario/shipped.hpp"
#include "cuda/executor/executor_cpu.hpp"
#include "cuda/simulation.hpp"
#include "output/frames.hpp"
#include "tests/emulated_gpu/simulation.hpp"
#include "tests/support.hpp"

#include <cuda_runtime.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace aneurysm;

namespace
{

Scenario quick()
{
    Scenario scenario = shipped_scenario("quick");
    scenario.particles.count = 700;
    scenario.rupture.yield_limit_pa /= 2; // ruptures in the first 200 frames
    return scenario;
}

std::unique_ptr<Simulation> on_cpu(const Scenario& scenario, Precision precision,
                                   const std::optional<SimulationState>& state)
{
    return device::make_cpu_simulation(scenario, precision, {}, state);
}

struct Way {
    int block_size = 0;
    bool backwards = false; ///< the last thread first
    bool computes_gradients = false;
};

/// The first frame runs as it is asked for, the second is recorded, the third replayed.
constexpr int frames = 3;

void check_frames(const Scenario& scenario, Precision precision, const SimulationState& start, const Way& way)
{
    emulated_gpu::behavior.runs_backwards = way.backwards;
    const auto gpu =
        emulated_gpu::simulate(scenario, {precision, way.block_size, way.computes_gradients}, start);
    const auto cpu = on_cpu(scenario, precision, start);
    for (int n = 0; n < frames; ++n) {
        const FrameRecord record = gpu->advance();
        BOOST_TEST_CONTEXT(name_of(precision) << ", frame " << record.frame << ", blocks of "
                                              << way.block_size << (way.backwards ? ", backwards" : ""))
        {
            BOOST_TEST(output::frames_row(record) == output::frames_row(cpu->advance()));
            BOOST_TEST(output::state_hash(gpu->state()) == output::state_hash(cpu->state()));
        }
    }
    emulated_gpu::behavior.runs_backwards = false;
}

/// The state two frames before the first one that `is_wanted`: the graph that makes that one is replayed.
template <class Predicate>
SimulationState state_before(const Scenario& scenario, Precision precision, Predicate is_wanted)
{
    const auto cpu = on_cpu(scenario, precision, {});
    std::vector<SimulationState> states{cpu->state()};
    FrameRecord last;
    for (int n = 0; n < 500; ++n) {
        const FrameRecord record = cpu->advance();
        if (states.size() >= frames && is_wanted(last, record)) {
            return states[states.size() - frames];
        }
        states.push_back(cpu->state());
        last = record;
    }
    BOOST_FAIL("no such frame in 500");
    return {};
}

/// With as many digits as fit, so that another order mostly gives another sum.
std::vector<double> long_numbers(int count, unsigned seed)
{
    std::mt19937_64 random(seed); // the same everywhere
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(std::ldexp(static_cast<double>(random() >> 11U), -53) - 0.5);
    }
    return values;
}
std::vector<int> small_numbers(int count, int end)
{
    std::mt19937 random(2);
    std::vector<int> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(static_cast<int>(random() % static_cast<unsigned>(end)));
    }
    return values;
}

constexpr int sizes[] = {1, 7, 8, 255, 256, 257, 5'000, 70'000}; // 70,000: sums of sums of sums

double sum_on_cpu(const std::vector<double>& values, int actual)
{
    const device::CpuExecutor cpu(1);
    std::vector<double> scratch(values.size() + 8);
    double sum = 0;
    cpu.reduce(
        device::Extent(actual), [&values](int i) { return values[static_cast<std::size_t>(i)]; },
        scratch.data(), &sum);
    return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(sums_have_the_bits_of_the_cpus)
{
    for (const int n : sizes) {
        const std::vector<double> values = long_numbers(n, 1);
        for (const int actual : {n, n - n / 3, 0}) {
            for (const bool backwards : {false, true}) {
                emulated_gpu::behavior.runs_backwards = backwards;
                BOOST_TEST(emulated_gpu::sum(values, actual, 64) == sum_on_cpu(values, actual));
            }
        }
    }
    emulated_gpu::behavior.runs_backwards = false;
    int misread = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const std::vector<double> values = long_numbers(100, seed);
        BOOST_TEST(emulated_gpu::sum(values, 100, 64) == sum_on_cpu(values, 100));
        emulated_gpu::behavior.misreads_lanes = true;
        misread += emulated_gpu::sum(values, 100, 64) != sum_on_cpu(values, 100) ? 1 : 0;
        emulated_gpu::behavior.misreads_lanes = false;
    }
    BOOST_TEST(misread > 10);
}

/// Behind the actual end stands what an earlier use left: here numbers that would spoil every total.
BOOST_AUTO_TEST_CASE(prefix_sums_and_sorting_are_the_cpus)
{
    device::CpuExecutor cpu(1);
    for (const int n : sizes) {
        std::vector<int> values = small_numbers(n, 9);
        const int actual = n - n / 3;
        std::fill(values.begin() + actual, values.end(), 2'000'000'000);
        std::vector<int> sums(values.size() + 1);
        cpu.scan(device::Extent(actual), values.data(), sums.data());
        const std::vector<int> of_gpu = emulated_gpu::scan(values, actual);
        BOOST_TEST(std::equal(sums.begin(), sums.begin() + actual + 1, of_gpu.begin()));

        constexpr int end = 1'000;
        const std::vector<int> keys = small_numbers(n, end);
        emulated_gpu::Sorted expected{keys, keys, std::vector<int>(end + 1)};
        cpu.sort(n, keys.data(), expected.keys.data(), expected.order.data(), end);
        cpu.find_starts(n, expected.keys.data(), expected.starts.data(), end);
        const emulated_gpu::Sorted sorted = emulated_gpu::sort(keys, end);
        BOOST_TEST((sorted.keys == expected.keys));
        BOOST_TEST((sorted.order == expected.order));
        BOOST_TEST((sorted.starts == expected.starts));
    }
}

BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_at_the_start)
{
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const SimulationState start = on_cpu(quick(), precision, {})->state();
        check_frames(quick(), precision, start, {});
        check_frames(quick(), precision, start, {.block_size = 32, .backwards = true});
        check_frames(quick(), precision, start, {.block_size = 256, .computes_gradients = true});
    }
}

BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_when_the_outlets_turn_round)
{
    const auto turns = [](const FrameRecord& last, const FrameRecord& record) {
        return last.outlet_velocity > 0 && record.outlet_velocity < 0;
    };
    const SimulationState start = state_before(quick(), Precision::float_, turns);
    check_frames(quick(), Precision::float_, start, {});
    check_frames(quick(), Precision::float_, start, {.block_size = 64, .backwards = true});
}

BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_through_rupture_and_escape)
{
    const auto ruptures = [](const FrameRecord& last, const FrameRecord& record) {
        return last.phase != Phase::ruptured && record.phase == Phase::ruptured;
    };
    const auto returns = [](const FrameRecord& last, const FrameRecord& record) {
        return record.ledger.escaped > last.ledger.escaped && record.ledger.inlet_in > last.ledger.inlet_in;
    };
    check_frames(quick(), Precision::double_, state_before(quick(), Precision::double_, ruptures), {});
    check_frames(quick(), Precision::double_, state_before(quick(), Precision::double_, returns),
                 {.backwards = true});
}

BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_with_two_steps_a_frame_and_another_kernel)
{
    Scenario scenario = quick();
    scenario.time.substeps = 2;
    scenario.kernel.function = KernelName::wendland_c2;
    scenario.pressure.relaxation = 0.3;
    check_frames(scenario, Precision::float_, on_cpu(scenario, Precision::float_, {})->state(), {});
}

BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_with_an_equation_of_state)
{
    Scenario scenario = quick();
    scenario.pressure.model = PressureModel::eos;
    scenario.pressure.stiffness_m2_s2 = 2000;
    scenario.time.substeps = 4;
    check_frames(scenario, Precision::float_, on_cpu(scenario, Precision::float_, {})->state(), {});
}

/// Blood that goes through seams, and open ends beside them.
BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_in_periodic_domains)
{
    const std::pair<std::string, Precision> runs[] = {
        {"box", Precision::double_}, {"slip_channel", Precision::float_}, {"duct", Precision::float_}};
    for (const auto& [name, precision] : runs) {
        Scenario scenario = shipped_scenario("verify_" + name);
        scenario.pressure.max_iterations = 20;
        SimulationState start = on_cpu(scenario, precision, {})->state();
        for (std::size_t i = 0; i < start.particles.size(); ++i) {
            const double phase = 40 * start.particles.position[i].y;
            start.particles.velocity[i] = {4 * std::sin(phase), 0, -4 * std::cos(phase)};
        }
        check_frames(scenario, precision, start, {.backwards = true});
    }
}

/// More neighbors than there is room for at first: the frame is made again with longer lists.
BOOST_AUTO_TEST_CASE(same_bits_as_the_cpu_when_lists_grow)
{
    Scenario scenario = quick();
    scenario.kernel.smoothing_length_spacings = 1.4;
    scenario.pressure.relaxation = 0.1;
    check_frames(scenario, Precision::float_, on_cpu(scenario, Precision::float_, {})->state(), {});
}

BOOST_AUTO_TEST_CASE(a_sum_of_lanes_in_another_order_is_noticed)
{
    const SimulationState start = on_cpu(quick(), Precision::float_, {})->state();
    emulated_gpu::behavior.misreads_lanes = true;
    const auto gpu = emulated_gpu::simulate(quick(), {Precision::float_}, start);
    const auto cpu = on_cpu(quick(), Precision::float_, start);
    gpu->advance();
    cpu->advance();
    emulated_gpu::behavior.misreads_lanes = false;
    BOOST_TEST((gpu->state().particles.velocity != cpu->state().particles.velocity));
}

BOOST_AUTO_TEST_CASE(errors_name_device_call_place_and_cause)
{
    const SimulationState start = on_cpu(quick(), Precision::float_, {})->state();
    const auto message = [&start](int block_size) {
        return test::message_of([&] {
            emulated_gpu::simulate(quick(), {Precision::float_, block_size}, start);
        });
    };
    BOOST_TEST(message(0).empty());
    for (const int block_size : {-32, 100, 512}) {
        BOOST_TEST(message(block_size).starts_with("--block-size: " + std::to_string(block_size)));
    }
    emulated_gpu::behavior.refuses_memory = true;
    const std::string refused = message(0);
    emulated_gpu::behavior.refuses_memory = false;
    for (const char* part : {"GPU 0 (emulated): cudaMalloc of ", " bytes failed at executor_gpu.hpp:",
                             ": an error of the emulated GPU", "; fewer particles"}) {
        BOOST_TEST(test::contains(refused, part));
    }
}

/// What a frame asks of a GPU doesn't depend on the number of particles, but for passes of the sort.
BOOST_AUTO_TEST_CASE(a_frame_is_one_graph_of_as_many_kernels_for_any_number_of_particles)
{
    std::vector<emulated_gpu::Asked> asked;
    for (const int count : {700, 1500}) {
        Scenario scenario = quick();
        scenario.particles.count = count;
        const SimulationState start = on_cpu(scenario, Precision::float_, {})->state();
        emulated_gpu::behavior.executes = false;
        const auto gpu = emulated_gpu::simulate(scenario, {Precision::float_}, start);
        gpu->advance();
        emulated_gpu::asked = {};
        gpu->advance(); // as a graph
        asked.push_back(emulated_gpu::asked);
        emulated_gpu::behavior.executes = true;
    }
    BOOST_TEST(asked[0].kernels > 0);
    BOOST_TEST(asked[0].kernels == asked[1].kernels);
    BOOST_TEST(asked[0].loops == asked[1].loops, boost::test_tools::per_element());
    BOOST_TEST(asked[0].to_device == asked[1].to_device);
    BOOST_TEST(asked[0].to_host == asked[1].to_host);
    BOOST_TEST(asked[0].to_host < 1000U);
}
