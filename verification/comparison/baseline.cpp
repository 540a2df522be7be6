// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/baseline.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/hash.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"
#include "output/file.hpp"
#include "output/json.hpp"
#include "output/report/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace aneurysm::comparison
{
namespace
{

namespace fs = std::filesystem;

constexpr std::int64_t key_frames = 10; ///< of a run, evenly spaced

std::vector<double> key_values(const FrameRecord& r)
{
    return {r.impact_force, r.critical_pressure, r.radius, r.thickness, r.kinetic_energy};
}

std::string digest_of(const RecordedHashes& hashes)
{
    Fnv1a digest;
    for (const auto& [frame, row] : hashes.frames) {
        for (const std::string& hash : row) {
            digest.add(std::as_bytes(std::span(hash)));
        }
    }
    return digest.hex();
}

BaselineTotals totals_of(const FrameRecord& last, std::int64_t rupture_frame, std::int64_t iterations)
{
    const Ledger& l = last.ledger;
    return {rupture_frame, l.inlet_in + l.outlet_in, l.inlet_out + l.outlet_out, l.escaped,
            static_cast<double>(iterations) / static_cast<double>(std::max<std::int64_t>(last.frame, 1))};
}

output::Json to_json(const BaselineRun& run)
{
    output::Json keys = output::Json::array();
    for (const KeyFrame& key : run.keys) {
        output::Json row{{"frame", key.frame}};
        for (std::size_t k = 0; k < key.values.size(); ++k) {
            row[key_names()[k]] = output::json_number(key.values[k]);
        }
        keys.push_back(row);
    }
    const BaselineTotals& t = run.totals;
    return {{"recorded_as", run.recorded_as},
            {"frames", run.frames},
            {"digest", run.digest},
            {"scenario_hash", run.hashes.scenario_hash},
            {"rupture_frame", t.rupture_frame},
            {"particles_in", t.particles_in},
            {"particles_out", t.particles_out},
            {"particles_escaped", t.particles_escaped},
            {"iterations_mean", t.iterations},
            {"key_frames", keys}};
}

/// What a scenario to be recorded for the first time doesn't have yet stays empty.
BaselineRun run_from(const output::Json& json)
{
    BaselineRun run;
    run.recorded_as = json.at("recorded_as").get<std::string>();
    run.frames = json.at("frames").get<std::int64_t>();
    run.digest = json.value("digest", "");
    BaselineTotals& t = run.totals;
    t.rupture_frame = json.value("rupture_frame", t.rupture_frame);
    t.particles_in = json.value("particles_in", t.particles_in);
    t.particles_out = json.value("particles_out", t.particles_out);
    t.particles_escaped = json.value("particles_escaped", t.particles_escaped);
    t.iterations = json.value("iterations_mean", t.iterations);
    for (const output::Json& row : json.value("key_frames", output::Json::array())) {
        KeyFrame key{row.at("frame").get<std::int64_t>(), {}};
        for (const std::string& name : key_names()) {
            key.values.push_back(row.at(name).get<double>());
        }
        run.keys.push_back(key);
    }
    return run;
}

Baseline baseline_from(const output::Json& json, const fs::path& data)
{
    Baseline baseline{json.at("version").get<std::string>(), json.at("commit").get<std::string>(), {}};
    for (const output::Json& s : json.at("scenarios")) {
        BaselineScenario scenario{
            s.at("name").get<std::string>(), data / s.at("file").get<std::string>(), {}};
        for (const output::Json& run : s.at("runs")) {
            scenario.runs.push_back(run_from(run));
        }
        baseline.scenarios.push_back(std::move(scenario));
    }
    return baseline;
}

fs::path hashes_of_run(const fs::path& data, const BaselineScenario& scenario, const BaselineRun& run)
{
    return data / "hashes" / (scenario.name + "." + run.recorded_as + ".csv");
}

std::string relative(double recorded, double now)
{
    const double difference = std::abs(now - recorded);
    return recorded != 0 ? report::shown(difference / std::abs(recorded))
                         : report::shown(difference) + " absolute";
}

/// First frame with other bits, and the fields; empty: none.
std::string bits_difference(const RecordedHashes& recorded, const RecordedHashes& now)
{
    for (const auto& [frame, row] : recorded.frames) {
        const auto found = now.frames.find(frame);
        if (found == now.frames.end()) {
            return "no frame " + std::to_string(frame);
        }
        std::vector<std::string> fields = differing_columns(row, found->second);
        if (fields.size() > 1) {
            std::erase(fields, "state"); // it differs with every field
        }
        if (!fields.empty()) {
            return "other bits from frame " + std::to_string(frame) + " on (" + joined(fields) + ")";
        }
    }
    return {};
}

/// Of each number the key frame where it differs most, relative to the recorded one.
std::string key_difference(const std::vector<KeyFrame>& recorded, const std::vector<KeyFrame>& now)
{
    std::string text;
    for (std::size_t k = 0; k < key_names().size(); ++k) {
        double most = 0;
        std::string worst;
        for (std::size_t n = 0; n < std::min(recorded.size(), now.size()); ++n) {
            const double a = recorded[n].values[k];
            const double b = now[n].values[k];
            const double size = std::abs(b - a) / (a != 0 ? std::abs(a) : 1);
            if (!(size <= most)) { // also a NaN
                most = std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
                worst = key_names()[k] + " by " + relative(a, b) + " in frame " +
                        std::to_string(recorded[n].frame);
            }
        }
        text.append(text.empty() || worst.empty() ? "" : ", ").append(worst);
    }
    return text;
}

} // namespace

const std::vector<std::string>& key_names()
{
    static const std::vector<std::string> names{"F_b [N]", "P_c [Pa]", "R [m]", "h [m]",
                                                "kinetic energy [J]"};
    return names;
}

Baseline read_baseline(const fs::path& data)
{
    const fs::path file = data / "baseline.json";
    Baseline baseline =
        output::read_json_as(file, "needed: a recorded baseline",
                             [&data](const output::Json& json) { return baseline_from(json, data); });
    for (BaselineScenario& scenario : baseline.scenarios) {
        for (BaselineRun& run : scenario.runs) {
            if (run.digest.empty()) {
                continue; // to be recorded
            }
            const fs::path hashes = hashes_of_run(data, scenario, run);
            run.hashes = read_hashes(
                hashes, scenario.name,
                value_of<Precision>(run.recorded_as, precision_names).value_or(Precision::double_));
            if (digest_of(run.hashes) != run.digest) {
                throw InputError(hashes.string(), "its digest is another (" + digest_of(run.hashes) + ")",
                                 "needed: the one recorded with " + file.string() + " (" + run.digest + ")");
            }
        }
    }
    return baseline;
}

void write_baseline(const fs::path& data, const Baseline& baseline)
{
    output::Json scenarios = output::Json::array();
    for (const BaselineScenario& scenario : baseline.scenarios) {
        output::Json runs = output::Json::array();
        for (const BaselineRun& run : scenario.runs) {
            output::write_atomically(hashes_of_run(data, scenario, run), to_csv(run.hashes));
            runs.push_back(to_json(run));
        }
        scenarios.push_back({{"name", scenario.name},
                             {"file", fs::relative(scenario.file, data).generic_string()},
                             {"runs", runs}});
    }
    output::write_atomically(data / "baseline.json", output::json_text({{"program", "aneurysm"},
                                                                        {"version", baseline.version},
                                                                        {"commit", baseline.commit},
                                                                        {"scenarios", scenarios}}));
}

std::optional<BaselineRun> run_again(const Scenario& scenario, const backends::BackendChoice& choice,
                                     std::int64_t frames, const AfterFrame& after_frame)
{
    const std::unique_ptr<Simulation> backend = backends::make_simulation(choice, scenario, std::nullopt);
    BaselineRun run;
    run.recorded_as = recorded_as(choice);
    run.frames = frames;
    run.hashes = {scenario.name, scenario_hash(scenario), choice.precision, {}};
    const std::int64_t every = std::max<std::int64_t>(1, frames / key_frames);
    std::int64_t iterations = 0;
    FrameRecord record;
    while (record.frame < frames) {
        record = backend->advance();
        run.hashes.frames[record.frame] = hashes_of(backend->state());
        iterations += record.iterations;
        if (record.frame % every == 0) {
            run.keys.push_back({record.frame, key_values(record)});
        }
        if (!after_frame(record)) {
            return std::nullopt;
        }
    }
    run.totals = totals_of(record, backend->state().aneurysm.rupture_frame, iterations);
    run.digest = digest_of(run.hashes);
    return run;
}

std::string difference(const BaselineRun& recorded, const BaselineRun& now)
{
    std::string text = bits_difference(recorded.hashes, now.hashes);
    const auto add = [&](const std::string& more) {
        text.append(text.empty() || more.empty() ? "" : "; ").append(more);
    };
    add(key_difference(recorded.keys, now.keys));
    const auto add_count = [&](const char* name, std::int64_t then, std::int64_t here) {
        if (then != here) {
            add(std::string(name) + " " + std::to_string(here) + " instead of " + std::to_string(then));
        }
    };
    const BaselineTotals& then = recorded.totals;
    const BaselineTotals& here = now.totals;
    add_count("rupture in frame", then.rupture_frame, here.rupture_frame);
    add_count("particles in:", then.particles_in, here.particles_in);
    add_count("particles out:", then.particles_out, here.particles_out);
    add_count("particles through the breach:", then.particles_escaped, here.particles_escaped);
    if (then.iterations != here.iterations) {
        add("mean iterations by " + relative(then.iterations, here.iterations));
    }
    return text;
}

} // namespace aneurysm::comparison
