// SPDX-License-Identifier: Apache-2.0
// frames.csv: what is taken is what the writer writes, byte by byte.
#include "output/frames.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace aneurysm;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text = test::text_of(data, size);
    const test::InputFile file(text);
    std::vector<FrameRecord> records;
    if (test::accepts([&] { records = output::read_frames(file.path()); })) {
        std::string again = output::frames_header() + "\n";
        for (const FrameRecord& record : records) {
            again += output::frames_row(record) + "\n";
        }
        test::require(again == text, "a file as it was written");
    }
    return 0;
}
