// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/run_store.hpp"

#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/build_info.hpp"
#include "output/file.hpp"
#include "output/frames.hpp"
#include "output/run_directory.hpp"
#include "output/run_frames.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace aneurysm::reproduction
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What decides a run's bits, and how far it is; nothing where no readable manifest is.
struct Made {
    bool same = false;
    bool finished = false;
};

Made made(const fs::path& directory, const Scenario& scenario, const backends::BackendChoice& backend)
{
    const fs::path file = directory / "manifest.json";
    if (!fs::exists(file)) {
        return {};
    }
    const std::vector<std::byte> bytes = output::read_bytes(file);
    const auto* text = reinterpret_cast<const char*>(bytes.data()); // NOLINT
    const Json json = Json::parse(text, text + bytes.size(), nullptr, false);
    if (!json.is_object()) {
        return {};
    }
    const auto is = [&json](const char* key, const std::string& value) {
        return json.value(key, "") == value;
    };
    const bool same =
        is("scenario_hash", scenario_hash(scenario)) && is("backend", name_of(backend.backend)) &&
        is("precision", name_of(backend.precision)) && is("commit", output::build_info().commit);
    return {same, is("status", "finished") && json.value("frames", 0) == scenario.time.frames};
}

/// A run of the store, begun or gone on with.
void make_run(const fs::path& directory, const Scenario& scenario, const backends::BackendChoice& choice,
              const output::OnFrame& on_frame)
{
    std::optional<output::Checkpoint> checkpoint;
    if (made(directory, scenario, choice).same &&
        fs::exists(output::RunDirectory::checkpoint_file(directory))) {
        checkpoint = output::read_checkpoint(output::RunDirectory::checkpoint_file(directory));
    } else {
        fs::remove_all(directory); // of another scenario or program, or without anything to go on from
    }
    const std::unique_ptr<Simulation> backend = backends::make_simulation(
        choice, scenario, checkpoint ? std::optional(checkpoint->state) : std::nullopt);
    output::RunDirectory run = checkpoint
                                   ? output::RunDirectory::resume(directory, *checkpoint, backend->engine())
                                   : output::RunDirectory::create(directory, scenario, backend->engine());
    output::run_frames(scenario, scenario.time.frames, *backend, run, on_frame);
}

/// Runs, taken by several threads one after the other; the first failure is kept and ends them all.
class Crew
{
public:
    Crew(const RunStore& store, std::vector<Scenario> scenarios, backends::BackendChoice choice)
        : store_(store), scenarios_(std::move(scenarios)), choice_(choice)
    {
        for (const Scenario& scenario : scenarios_) {
            frames_ += scenario.time.frames;
        }
    }

    void run(std::size_t threads)
    {
        working_ = threads;
        std::vector<std::jthread> crew;
        for (std::size_t t = 0; t < threads; ++t) {
            crew.emplace_back([this] { work(); });
        }
        Progress progress("frame", 0, frames_);
        while (working_ > 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            progress.show(done_,
                          std::to_string(finished_) + " of " + std::to_string(scenarios_.size()) + " runs");
        }
        crew.clear();
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

private:
    void work()
    {
        for (std::size_t k = next_++; k < scenarios_.size() && !InterruptWatch::interrupted() && !failed();
             k = next_++) {
            make(scenarios_[k]);
        }
        --working_;
    }
    void make(const Scenario& scenario)
    {
        try {
            std::int64_t shown = 0;
            make_run(store_.directory(scenario), scenario, choice_, [&](const FrameRecord& record) {
                done_ += record.frame - shown;
                shown = record.frame;
            });
            ++finished_;
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (!failure_) {
                failure_ = std::current_exception();
            }
        }
    }
    bool failed()
    {
        const std::scoped_lock lock(mutex_);
        return failure_ != nullptr;
    }

    const RunStore& store_;
    std::vector<Scenario> scenarios_;
    backends::BackendChoice choice_;
    std::int64_t frames_ = 0;
    std::atomic<std::size_t> next_{0};
    std::atomic<std::int64_t> done_{0};
    std::atomic<int> finished_{0};
    std::atomic<std::size_t> working_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

} // namespace

RunStore::RunStore(fs::path directory, backends::BackendChoice backend, int jobs)
    : directory_(std::move(directory)), backend_(backend),
      jobs_(jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency())))
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
    const std::size_t at_once =
        backend_.backend == Backend::cuda ? 1 : std::min(missing.size(), static_cast<std::size_t>(jobs_));
    backends::BackendChoice choice = backend_;
    choice.threads = std::max(1, jobs_ / static_cast<int>(at_once));
    Crew(*this, std::move(missing), choice).run(at_once);
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
