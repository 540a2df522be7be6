// SPDX-License-Identifier: Apache-2.0
#include "app/cite.hpp"

#include "common/hash.hpp"
#include "common/scenario/shipped.hpp"
#include "output/build_info.hpp"
#include "verification/comparison/baseline.hpp"

#include <algorithm>
#include <iomanip>
#include <span>
#include <sstream>

namespace aneurysm::app
{
namespace
{

// As in CITATION.cff; a guard compares them.
constexpr const char* title =
    "Aneurysm: a verified reference implementation of an SPH simulation of aneurysm growth and rupture";
constexpr const char* author = "The aneurysm reference project";
constexpr const char* year = "2026";
constexpr const char* paper = R"(@article{wu2025aneurysms,
  title   = {Computational Simulation of Aneurysms Using Smoothed Particle Hydrodynamics},
  author  = {Wu, Yong and Wang, Fei and Sun, Xianhong and Liu, Zibo and Xiong, Zhi and Zhang, Mingzhi and
             Zhao, Baoquan and Zhou, Teng},
  journal = {Mathematics},
  volume  = {13},
  number  = {15},
  pages   = {2439},
  year    = {2025},
  doi     = {10.3390/math13152439}
}
)";

/// Of the digests of all recorded runs, in their order.
std::string digest_of(const comparison::Baseline& baseline)
{
    Fnv1a hash;
    for (const comparison::BaselineScenario& scenario : baseline.scenarios) {
        for (const comparison::BaselineRun& run : scenario.runs) {
            hash.add(std::as_bytes(std::span(run.digest)));
        }
    }
    return hash.hex();
}

std::string recorded_runs(const comparison::Baseline& baseline)
{
    std::ostringstream text;
    for (const comparison::BaselineScenario& scenario : baseline.scenarios) {
        for (const comparison::BaselineRun& run : scenario.runs) {
            text << "  " << std::left << std::setw(12) << scenario.name << std::setw(12) << run.recorded_as
                 << std::right << std::setw(5) << run.frames << " frames   " << run.digest << "\n";
        }
    }
    return text.str();
}

} // namespace

std::string citation()
{
    const output::BuildInfo build = output::build_info();
    const comparison::Baseline baseline = comparison::read_baseline(data_directory());
    const std::string digest = digest_of(baseline);
    std::string key = build.version;
    std::ranges::replace(key, '.', '_');
    std::ostringstream text;
    text << "To cite this program:\n\n"
         << author << " (" << year << "). " << title << " (version " << build.version << ", commit "
         << build.commit << ", digest of the baseline " << digest
         << "). It implements the model of Wu et al. (2025), https://doi.org/10.3390/math13152439.\n\n"
         << "@software{aneurysm_" << key << ",\n  title   = {" << title << "},\n  author  = {{" << author
         << "}},\n  version = {" << build.version << "},\n  year    = {" << year
         << "},\n  license = {Apache-2.0},\n  note    = {Commit " << build.commit
         << ", digest of the baseline " << digest << "}\n}\n\n"
         << paper
         << "\nWith a result, name the scenario, the backend and its precision, too, and the digest of the\n"
         << "recorded run that `aneurysm verify --baseline` found again (recorded by version "
         << baseline.version << "):\n\n"
         << recorded_runs(baseline)
         << "\nOf a run of your own, name scenario_hash and state_hash of its manifest.json.\n";
    return text.str();
}

} // namespace aneurysm::app
