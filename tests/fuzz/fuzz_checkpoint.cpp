// SPDX-License-Identifier: Apache-2.0
// Checkpoints. An input is read as it is, and once more with the hash in its first line put right, since no mutation
// finds it: else nothing would get past it to what reads HDF5. What is taken gives the same state when it is written
// and read again, and one that a run can go on from.
#include "common/hash.hpp"
#include "output/checkpoint.hpp"
#include "output/frames.hpp"
#include "tests/fuzz/same_scenario.hpp"

#include <cmath>
#include <filesystem>
#include <span>
#include <string>

using namespace aneurysm;
namespace fs = std::filesystem;

namespace
{

constexpr std::size_t block_size = 512; ///< what comes before HDF5's part
constexpr std::size_t hash_at = sizeof "aneurysm checkpoint 2 " - 1;

std::string with_its_hash(std::string bytes)
{
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(bytes).subspan(block_size)));
    return bytes.replace(hash_at, hash.hex().size(), hash.hex());
}

void check(const output::Checkpoint& c)
{
    test::require_in_range(c.scenario);
    test::require_same_again(c.scenario);
    const Particles& p = c.state.particles;
    test::require(static_cast<std::int64_t>(p.size()) == c.scenario.particles.count, "as many particles");
    test::require(c.state.frame >= 0 && c.state.spacing > 0 && p.mass > 0, "a state of a run");
    for (std::size_t i = 0; i < p.size(); ++i) {
        test::require(std::isfinite(p.position[i].x + p.velocity[i].y), "finite numbers");
        test::require(p.kind[i] <= Kind::outlet_2, "a kind that there is");
    }
    static const fs::path again =
        fs::temp_directory_path() / ("aneurysm_fuzz_" + std::to_string(getpid()) + ".h5");
    output::write_checkpoint(again, c.scenario, c.state);
    test::require(output::state_hash(output::read_checkpoint(again).state) == output::state_hash(c.state),
                  "the same state again");
    fs::remove(again);
}

void read(const std::string& bytes)
{
    const test::InputFile file(bytes);
    output::Checkpoint checkpoint;
    if (test::accepts([&] { checkpoint = output::read_checkpoint(file.path()); })) {
        check(checkpoint);
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string bytes = test::text_of(data, size);
    read(bytes);
    if (bytes.size() > block_size) {
        read(with_its_hash(bytes));
    }
    return 0;
}
