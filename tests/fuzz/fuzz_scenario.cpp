// SPDX-License-Identifier: Apache-2.0
// Scenarios: what is taken says all that the text says, and is the same when it is written and read again.
#include "tests/fuzz/same_scenario.hpp"

#include <filesystem>
#include <fstream>
#include <string>

using namespace aneurysm;
namespace fs = std::filesystem;

namespace
{

/// A folder with the scenarios that are shipped, and the input beside them, so that it can build on them.
class Folder
{
public:
    Folder() : path_(fs::temp_directory_path() / ("aneurysm_fuzz_" + std::to_string(getpid())))
    {
        fs::copy(ANEURYSM_SCENARIOS, path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path input() const { return path_ / "input.json"; }

private:
    fs::path path_;
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const Folder folder;
    const std::string text = test::text_of(data, size);
    std::ofstream(folder.input(), std::ios::binary) << text;
    Scenario scenario;
    if (test::accepts([&] { scenario = read_scenario(folder.input()); })) {
        test::require_in_range(scenario);
        test::require_same_again(scenario);
        test::require_all_taken(nlohmann::json::parse(text), scenario);
    }
    return 0;
}
