// SPDX-License-Identifier: Apache-2.0
#include "common/number.hpp"
#include "common/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sched.h>
#include <string>
#include <thread>
#include <vector>

namespace aneurysm
{
namespace
{

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Processors that the process may run on (taskset, a batch system).
double allowed_processors()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    const bool known = sched_getaffinity(0, sizeof(set), &set) == 0 && CPU_COUNT(&set) > 0;
    return known ? CPU_COUNT(&set) : std::max(1U, std::thread::hardware_concurrency());
}

/// The number in an environment variable; of a list, as OMP_NUM_THREADS may be, the first.
double number_from(const char* variable)
{
    const char* const text = std::getenv(variable); // NOLINT(concurrency-mt-unsafe)
    const std::string list = text == nullptr ? "" : text;
    const auto number = whole_number(list.substr(0, list.find(',')));
    return number && *number > 0 ? static_cast<double>(*number) : unlimited;
}

std::vector<std::string> words_of(const fs::path& file)
{
    std::ifstream stream(file);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// Processors' worth of time that a control group gets; both versions of the kernel's interface.
double quota_of(const fs::path& group)
{
    std::vector<std::string> words = words_of(group / "cpu.max");
    if (words.empty()) {
        for (const char* name : {"cpu.cfs_quota_us", "cpu.cfs_period_us"}) {
            const std::vector<std::string> word = words_of(group / name);
            words.insert(words.end(), word.begin(), word.end());
        }
    }
    const auto quota = words.size() == 2 ? whole_number(words[0]) : std::nullopt; // or max
    const auto period = words.size() == 2 ? whole_number(words[1]) : std::nullopt;
    const bool limited = quota && period && *quota > 0 && *period > 0;
    return limited ? static_cast<double>(*quota) / static_cast<double>(*period) : unlimited;
}

/// The least quota of the process's groups and of those around them.
double least_quota()
{
    double least = unlimited;
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) { // number:controllers:/path
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) {
            continue;
        }
        const fs::path root = "/sys/fs/cgroup";
        for (const fs::path& mount :
             {root, root / line.substr(first + 1, second - first - 1), root / "cpu", root / "unified"}) {
            for (fs::path group = line.substr(second + 1);; group = group.parent_path()) {
                least = std::min(least, quota_of(mount / group.relative_path()));
                if (group.relative_path().empty()) {
                    break;
                }
            }
        }
    }
    return least;
}

} // namespace

int paying_threads()
{
    const double count = std::min({allowed_processors(), std::ceil(least_quota()),
                                   number_from("SLURM_CPUS_PER_TASK"), number_from("OMP_NUM_THREADS")});
    return std::max(1, static_cast<int>(count));
}

} // namespace aneurysm
