// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/run_store.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/parallel.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/build_info.hpp"
#include "output/frames.hpp"
#include "output/json.hpp"
#include "output/lock.hpp"
#include "output/run_directory.hpp"
#include "output/run_frames.hpp"
#include "reference/bifurcation.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

namespace aneurysm::reproduction
{
namespace
{

namespace fs = std::filesystem;

/// What decides a run's bits, and how far it is; nothing where no readable manifest is.
struct Made {
    bool same = false;
    bool finished = false;
};

Made made(const fs::path& directory, const Scenario& scenario, const backends::BackendChoice& backend)
{
    const fs::path file = output::RunDirectory::manifest_file(directory);
    if (!is_there(file)) {
        return {};
    }
    const auto read = [&](const output::Json& json) -> Made {
        const auto is = [&json](const char* key, const std::string& value) {
            return json.value(key, std::string()) == value;
        };
        const output::BuildInfo build = output::build_info();
        const bool same = is("scenario_hash", scenario_hash(scenario)) &&
                          is("backend", name_of(backend.backend)) &&
                          is("precision", name_of(backend.precision)) && is("commit", build.commit) &&
                          is("version", build.version);
        return {same,
                is("status", "finished") && json.value("frames", std::int64_t{0}) == scenario.time.frames};
    };
    try {
        return output::read_json_as(file, "", read);
    } catch (const InputError&) {
        return {}; // damaged: made anew
    }
}

/// A run of the store, begun or gone on with.
void make_run(const fs::path& directory, const Scenario& scenario, const backends::BackendChoice& choice,
              const output::OnFrame& on_frame)
{
    std::optional<output::Checkpoint> checkpoint;
    if (made(directory, scenario, choice).same &&
        is_there(output::RunDirectory::checkpoint_file(directory))) {
        checkpoint = output::read_checkpoint(output::RunDirectory::checkpoint_file(directory));
    } else if (is_there(directory)) { // of another scenario or program, or without anything to go on from
        const output::Lock lock(is_there(output::RunDirectory::frames_file(directory))
                                    ? output::RunDirectory::frames_file(directory)
                                    : directory); // `aneurysm run --resume` may be at work there
        fs::remove_all(directory);
    }
    const std::unique_ptr<Simulation> backend = backends::make_simulation(
        choice, scenario, checkpoint ? std::optional(checkpoint->state) : std::nullopt);
    output::RunDirectory run = checkpoint
                                   ? output::RunDirectory::resume(directory, *checkpoint, backend->engine())
                                   : output::RunDirectory::create(directory, scenario, backend->engine());
    const Vessel vessel = reference::vessel_of(scenario);
    output::run_frames(scenario, vessel, scenario.time.frames, *backend, run, on_frame);
}

} // namespace

RunStore::RunStore(fs::path directory, backends::BackendChoice backend, int jobs)
    : directory_(std::move(directory)), backend_(backend), jobs_(thread_count(jobs))
{
}

fs::path RunStore::directory(const Scenario& scenario) const
{
    return directory_ / scenario.name;
}

bool RunStore::complete(const Scenario& scenario) const
{
    const Made run = made(directory(scenario), scenario, backend_);
    return run.same && run.finished;
}

void RunStore::make(const std::vector<Scenario>& scenarios)
{
    std::vector<Scenario> missing;
    std::ranges::copy_if(scenarios, std::back_inserter(missing),
                         [this](const Scenario& s) { return !complete(s); });
    if (missing.empty()) {
        return;
    }
    // A GPU makes one run at a time; on a CPU runs side by side are faster than threads in each.
    const int at_once =
        backend_.backend == Backend::cuda ? 1 : std::min(static_cast<int>(missing.size()), jobs_);
    backends::BackendChoice choice = backend_;
    choice.threads = std::max(1, jobs_ / at_once);
    std::int64_t frames = 0;
    for (const Scenario& scenario : missing) {
        frames += scenario.time.frames;
    }
    Progress progress("frame", 0, frames);
    std::atomic<std::int64_t> done = 0;
    std::atomic<int> finished = 0;
    const auto make_one = [&](std::size_t k) {
        if (InterruptWatch::interrupted()) {
            return;
        }
        std::int64_t shown = 0;
        make_run(directory(missing[k]), missing[k], choice, [&](const FrameRecord& record) {
            done += record.frame - shown;
            shown = record.frame;
        });
        ++finished;
    };
    in_parallel(missing.size(), at_once, make_one, [&] {
        progress.show(done, std::to_string(finished) + " of " + std::to_string(missing.size()) + " runs");
    });
    if (InterruptWatch::interrupted()) {
        throw Interrupted();
    }
}

std::vector<FrameRecord> RunStore::records(const Scenario& scenario) const
{
    std::vector<FrameRecord> records =
        output::read_frames(output::RunDirectory::frames_file(directory(scenario)));
    if (static_cast<std::int64_t>(records.size()) != scenario.time.frames) {
        throw InputError(output::RunDirectory::frames_file(directory(scenario)).string(),
                         std::to_string(records.size()) + " frames",
                         "needed: " + std::to_string(scenario.time.frames) + "; delete the run's directory");
    }
    return records;
}

} // namespace aneurysm::reproduction
