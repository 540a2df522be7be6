// SPDX-License-Identifier: Apache-2.0
// Recorded hashes: what is taken is what the writer writes, but for the version that wrote it.
#include "output/build_info.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "verification/comparison/hash_file.hpp"

#include <algorithm>

using namespace aneurysm;

namespace
{

/// Without the line that names a version.
std::string without_version(std::string text)
{
    const std::string key = "# version ";
    const std::size_t from = text.find(key);
    const std::size_t to = std::min(text.find('\n', from), text.size());
    return from == std::string::npos ? text : text.erase(from, to - from);
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text = test::text_of(data, size);
    const test::InputFile file(text);
    comparison::RecordedHashes hashes;
    if (test::accepts([&] { hashes = comparison::read_hashes(file.path(), "quick", Precision::float_); })) {
        test::require(without_version(comparison::to_csv(hashes)) == without_version(text),
                      "a file as it was written");
        for (const auto& [frame, row] : hashes.frames) {
            test::require(frame > 0 && row.size() == comparison::hash_columns().size(),
                          "a row of each frame");
            for (const std::string& hash : row) {
                test::require(hash.size() == 16 &&
                                  hash.find_first_not_of("0123456789abcdef") == std::string::npos,
                              "64 bits in hexadecimal digits");
            }
        }
    }
    return 0;
}
