// SPDX-License-Identifier: Apache-2.0
#include "output/provenance.hpp"

#include "output/build_info.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <ctime>
#include <fstream>
#include <sys/utsname.h>
#include <thread>

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

} // namespace

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
    return processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads, " + os;
}

} // namespace aneurysm::output
