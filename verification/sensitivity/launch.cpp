// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/launch.hpp"

#include "common/error.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace aneurysm::verification
{

void launch_sensitivity(const VerifyOptions& options)
{
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe");
    const std::string program = here.parent_path() / "aneurysm-sensitivity";
    std::vector<std::string> words{program,        "--out",  options.out.string(),        "--faults",
                                   options.faults, "--jobs", std::to_string(options.jobs)};
    for (const std::string& word : options.only) {
        words.insert(words.end(), {"--only", word});
    }
    if (options.full) {
        words.emplace_back("--full");
    }
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    throw InputError("--sensitivity", program + " can't be started (" + std::strerror(errno) + ")",
                     "needed: the program of that name beside this one; the build target has the same name");
}

} // namespace aneurysm::verification
