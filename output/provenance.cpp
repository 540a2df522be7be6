// SPDX-License-Identifier: Apache-2.0
#include "output/provenance.hpp"

#include "common/parallel.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <link.h>
#include <sys/utsname.h>
#include <vector>

namespace aneurysm::output
{
namespace
{

/// As Linux calls it.
std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            const auto colon = line.find(": ");
            return colon == std::string::npos ? line : line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

/// The first line of a file; empty where there is none.
std::string first_line(const char* file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

/// As it would be typed.
std::string command_line()
{
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) {
        words.push_back(shell_word(word));
    }
    return joined(words, " ");
}

/// Of a batch system; empty outside.
std::string batch_job()
{
    for (const char* variable : {"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "JOB_ID"}) {
        if (const char* const id = std::getenv(variable)) { // NOLINT(concurrency-mt-unsafe)
            return std::string(variable) + "=" + id;
        }
    }
    return "";
}

/// The files of the shared libraries that the program runs with; their names carry the versions.
std::vector<std::string> libraries()
{
    std::vector<std::string> names;
    const auto add = [](dl_phdr_info* library, std::size_t, void* list) {
        std::error_code error;
        const std::filesystem::path file = std::filesystem::canonical(library->dlpi_name, error);
        if (!error) { // the program itself has no name, and what the kernel brings no file
            static_cast<std::vector<std::string>*>(list)->push_back(file.filename().string());
        }
        return 0;
    };
    dl_iterate_phdr(add, &names);
    std::ranges::sort(names);
    return names;
}

} // namespace

std::string host()
{
    utsname system{};
    return uname(&system) == 0 ? system.nodename : "unknown";
}

nlohmann::ordered_json surroundings()
{
    const std::string driver = first_line("/proc/driver/nvidia/version");
    return {{"host", host()},       {"job", batch_job()},       {"command", command_line()},
            {"machine", machine()}, {"libraries", libraries()}, {"driver", driver.empty() ? "none" : driver}};
}

nlohmann::ordered_json provenance()
{
    const BuildInfo build = build_info();
    return {{"program", "aneurysm"},
            {"version", build.version},
            {"commit", build.commit},
            {"compiler", build.compiler},
            {"flags", build.flags}};
}

std::string now_utc()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), size};
}

std::string machine()
{
    utsname system{};
    const bool known = uname(&system) == 0;
    const std::string os = known ? std::string(system.sysname) + " " + system.machine : "unknown system";
    return processor() + ", " + std::to_string(paying_threads()) + " threads, " + os;
}

} // namespace aneurysm::output
