// SPDX-License-Identifier: Apache-2.0
// How a run differs from a recorded one: in bits, in the numbers of key frames, in its totals.
#include "verification/comparison/baseline.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace aneurysm;

namespace
{

const std::string other(16, '0');

/// Two frames of hashes that say nothing else.
comparison::BaselineRun sample()
{
    comparison::BaselineRun run;
    run.recorded_as = "float";
    run.frames = 2;
    for (const std::int64_t frame : {1, 2}) {
        run.hashes.frames[frame] =
            std::vector<std::string>(comparison::hash_columns().size(), "0123456789abcdef");
        run.keys.push_back({frame, {100, 4000, 0.25, 0.0125, 9000}});
    }
    run.totals = {144, 927, 864, 89, 7.5};
    return run;
}

/// What is said of a run with a fault.
std::string said(const std::function<void(comparison::BaselineRun&)>& fault)
{
    comparison::BaselineRun now = sample();
    fault(now);
    return comparison::difference(sample(), now);
}

} // namespace

BOOST_AUTO_TEST_CASE(identical_runs_have_no_difference)
{
    BOOST_TEST(said([](comparison::BaselineRun&) {}).empty());
    // Another text of the scenario is no other run.
    BOOST_TEST(said([](comparison::BaselineRun& run) { run.hashes.scenario_hash = other; }).empty());
}

BOOST_AUTO_TEST_CASE(other_bits_are_named_by_frame_and_field)
{
    BOOST_TEST(said([](comparison::BaselineRun& run) {
                   run.hashes.frames[2][1] = other;
                   run.hashes.frames[2].back() = other;
               }) == "other bits from frame 2 on (velocity)");
    BOOST_TEST(said([](comparison::BaselineRun& run) { run.hashes.frames[1].back() = other; }) ==
               "other bits from frame 1 on (state)");
    BOOST_TEST(said([](comparison::BaselineRun& run) { run.hashes.frames.erase(2); }) == "no frame 2");
}

BOOST_AUTO_TEST_CASE(numbers_are_named_with_how_much_they_differ)
{
    BOOST_TEST(said([](comparison::BaselineRun& run) {
                   run.keys[0].values[0] = 101;
                   run.keys[1].values[0] = 102;
                   run.keys[1].values[4] = 4500;
               }) == "F_b [N] by 0.02 in frame 2, kinetic energy [J] by 0.5 in frame 2");
    BOOST_TEST(said([](comparison::BaselineRun& run) { run.keys[0].values[2] = std::nan(""); }) ==
               "R [m] by nan in frame 1");
    BOOST_TEST(said([](comparison::BaselineRun& run) {
                   run.totals = {-1, 928, 865, 90, 15};
               }) ==
               "rupture in frame -1 instead of 144; particles in: 928 instead of 927; particles out: 865 "
               "instead of 864; particles through the breach: 90 instead of 89; mean iterations by 1");
}
