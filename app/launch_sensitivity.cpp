// SPDX-License-Identifier: Apache-2.0
#include "app/launch_sensitivity.hpp"

#include "app/launch.hpp"

namespace aneurysm::app
{

void launch_sensitivity(const VerifyOptions& options)
{
    std::vector<std::string> words{"--out",  options.out.string(),        "--faults", options.faults,
                                   "--jobs", std::to_string(options.jobs)};
    for (const std::string& word : options.only) {
        words.insert(words.end(), {"--only", word});
    }
    if (options.full) {
        words.emplace_back("--full");
    }
    launch("aneurysm-sensitivity", words, "--sensitivity", "the build target has the same name");
}

} // namespace aneurysm::app
