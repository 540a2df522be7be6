// SPDX-License-Identifier: Apache-2.0
// The comparison of bits: against another executor and against recorded hashes; one bit is a failure.
#include "tests/files.hpp"
#include "tests/verification/candidates.hpp"
#include "verification/comparison/bits.hpp"

#include <cmath>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr int frames = 3;

const Scenario& quick()
{
    static const Scenario result = shipped_scenario("quick");
    return result;
}

const SimulationState& start()
{
    static const SimulationState state = reference::Simulation(quick()).state();
    return state;
}

/// The last bit of one number, in frame 2 only.
void flip(Frame& f)
{
    double& x = f.state.particles.velocity[7].y;
    if (f.record.frame == 2) {
        x = std::nextafter(x, 1e9);
    }
}

comparison::ComparisonResult compare_with_twin(const Faults& faults)
{
    Candidate candidate(quick(), start(), Precision::float_, faults);
    Candidate twin(quick(), start(), Precision::float_);
    return comparison::compare_bits(candidate, {&twin, {}}, frames, go_on);
}

const comparison::RecordedHashes& recorded()
{
    static const comparison::RecordedHashes result = [] {
        comparison::RecordedHashes hashes{"quick", scenario_hash(quick()), Precision::float_, {}};
        Candidate candidate(quick(), start(), Precision::float_);
        comparison::compare_bits(candidate, {}, frames, go_on, &hashes);
        return hashes;
    }();
    return result;
}

comparison::ComparisonResult compare_with_record(const Faults& faults, int count = frames)
{
    Candidate candidate(quick(), start(), Precision::float_, faults);
    return comparison::compare_bits(candidate, {nullptr, recorded()}, count, go_on);
}

bool says(const comparison::ComparisonResult& result, const std::string& text)
{
    return std::ranges::any_of(result.problems, [&](const std::string& p) { return contains(p, text); });
}

} // namespace

BOOST_AUTO_TEST_CASE(bits_of_the_same_run_are_the_same)
{
    BOOST_TEST(compare_with_twin({}).passed());
    BOOST_TEST(compare_with_record({}).passed());
}

BOOST_AUTO_TEST_CASE(bits_one_of_them_is_found_and_named)
{
    const Faults faults{{}, flip};
    for (const comparison::ComparisonResult& result :
         {compare_with_twin(faults), compare_with_record(faults)}) {
        BOOST_TEST(!result.passed());
        BOOST_TEST(says(result, "first in frame 2: velocity, state"));
    }
}

BOOST_AUTO_TEST_CASE(bits_without_anything_to_compare_with_fail)
{
    Candidate candidate(quick(), start(), Precision::float_);
    BOOST_TEST(!comparison::compare_bits(candidate, {}, frames, go_on).passed());
    BOOST_TEST(!compare_with_record({}, 0).passed());
    comparison::RecordedHashes other = recorded();
    other.frames.clear();
    BOOST_TEST(!comparison::compare_bits(candidate, {nullptr, other}, frames, go_on).passed());
}

BOOST_AUTO_TEST_CASE(bits_frames_beyond_the_record_are_said)
{
    const comparison::ComparisonResult result = compare_with_record({}, frames + 1);
    BOOST_TEST(result.passed());
    BOOST_TEST(result.notes.size() == 1U);
}

BOOST_AUTO_TEST_CASE(bits_recorded_hashes_are_read_back_and_checked)
{
    const Scratch scratch;
    const auto file = scratch.path / "hashes.csv";
    const std::string text = comparison::to_csv(recorded());
    write_text(file, text);
    BOOST_TEST((comparison::read_hashes(file, "quick", Precision::float_).frames == recorded().frames));
    BOOST_TEST(comparison::read_hashes(file, "quick", Precision::float_).scenario_hash ==
               scenario_hash(quick()));
    const auto message = [&](const std::string& scenario, Precision precision) {
        return message_of([&] { comparison::read_hashes(file, scenario, precision); });
    };
    BOOST_TEST(contains(message("slow", Precision::float_), "line 1: of another scenario"));
    BOOST_TEST(contains(message("quick", Precision::double_), "line 3: of another precision"));
    const auto message_to = [&](const std::string& other) {
        write_text(file, other);
        return message("quick", Precision::float_);
    };
    BOOST_TEST(contains(message_to(text.substr(0, text.size() - 20)), "line 8: cut short"));
    BOOST_TEST(contains(message_to(text.substr(0, text.size() - 1)), "line 8: cut short"));
    BOOST_TEST(contains(message_to("frame\n1\n"), "line 1: no scenario (frame)"));
    // A frame twice, hashes that are none, one too many, a frame with a zero before it.
    const std::string header = text.substr(0, text.find("\n1,") + 1);
    const std::string row = text.substr(header.size(), text.find('\n', header.size()) + 1 - header.size());
    BOOST_TEST(message_to(header + row).empty());
    for (const std::string& bad :
         {row + row, "0" + row, row.substr(0, row.size() - 1) + ",\n", row.substr(0, row.size() - 2) + "\n",
          row.substr(0, row.size() - 2) + "g\n", row.substr(0, row.size() - 1) + "\r\n"}) {
        BOOST_TEST(contains(message_to(header + bad), "unreadable, or a frame that isn't after"), bad);
    }
}
