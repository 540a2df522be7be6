// SPDX-License-Identifier: Apache-2.0
// Table 4: in which frame walls of other Poisson's ratios and porosities rupture.
#include "common/error.hpp"
#include "reference/rupture.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/resolution.hpp"
#include "verification/reproduction/variants.hpp"
#include "verification/reproduction/wall_history.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace aneurysm::reproduction
{
namespace
{

/// A row of the table, as the ensemble has it.
struct RowResult {
    RuptureRow row;
    bool fitted = false;          ///< the calibration has seen it
    std::vector<double> frames{}; ///< of rupture, by member; where it holds, one more than there are frames
    std::int64_t held = 0;        ///< members whose wall holds to the end
    std::int64_t earlier = 0;     ///< members that rupture before the paper's frame
    double own_yield = 0;         ///< Y with which the mean would be the paper's [Pa]
    double wall = 0;              ///< P_c in the paper's frame, mean over the members [Pa]
    double blow = 0;              ///< hardest impact up to there per conversion area, mean [Pa]
    std::int64_t developed = 0;   ///< members that rupture after full development

    Spread spread() const { return reproduction::spread(frames); }
};

/// Y at which the mean frame of rupture is the paper's, by bisection of its logarithm.
double own_yield(const std::vector<RuptureTimes>& times, double wanted, double around)
{
    constexpr double far = 10;
    constexpr int steps = 60;
    double low = std::log(around / far);
    double high = std::log(around * far);
    for (int k = 0; k < steps; ++k) {
        const double middle = (low + high) / 2;
        const auto frame = [Y = std::exp(middle)](const RuptureTimes& t) { return t.frame(Y); };
        (mean(times, frame) < wanted ? low : high) = middle;
    }
    return std::exp((low + high) / 2);
}

/// What the wall of a member is like in the paper's frame of rupture, were it still whole.
void look_at_paper_frame(RowResult& result, const Scenario& wall, const Member& member, double share)
{
    const std::vector<WallFrame> whole = whole_wall(wall, member).frames;
    const std::size_t frame = std::min(static_cast<std::size_t>(result.row.paper), whole.size());
    double blow = 0;
    for (std::size_t k = 0; k < frame; ++k) {
        blow = whole[k].phase == Phase::warm_up ? 0 : std::max(blow, member.records[k].wall_load);
    }
    result.wall += share * whole[frame - 1].critical_pressure;
    result.blow += share * blow / wall.rupture.conversion_area_m2;
}

RowResult evaluate(const RuptureRow& row, const Scenario& scenario, const std::vector<Member>& members,
                   bool fitted)
{
    RowResult result{row, fitted};
    const Scenario wall = with_wall(scenario, row);
    std::vector<RuptureTimes> times;
    for (const Member& member : members) {
        const WallHistory history = wall_along(wall, member.records);
        const auto end = static_cast<std::int64_t>(member.records.size()) + 1;
        result.frames.push_back(static_cast<double>(history.rupture_frame.value_or(end)));
        result.held += history.rupture_frame ? 0 : 1;
        result.earlier += history.rupture_frame.value_or(end) < row.paper ? 1 : 0;
        result.developed +=
            history.developed && history.developed < history.rupture_frame.value_or(end) ? 1 : 0;
        times.emplace_back(wall, member);
        look_at_paper_frame(result, wall, member, 1 / static_cast<double>(members.size()));
    }
    result.own_yield = own_yield(times, static_cast<double>(row.paper), scenario.rupture.yield_limit_pa);
    return result;
}

bool is_fitted(const RuptureRow& row, const nlohmann::json& plan)
{
    return std::ranges::any_of(plan.at("rows"), [&row](const nlohmann::json& r) {
        return r.at("sigma") == row.sigma && r.at("phi") == row.phi;
    });
}

/// Whether the calibration has seen some of the ensemble's seeds.
bool shares_seeds(const nlohmann::json& plan, const Reproduction& reproduction)
{
    const auto first = plan.at("first_seed").get<std::int64_t>();
    const auto end = first + plan.at("seeds").get<std::int64_t>();
    return reproduction.first_seed < end && first < reproduction.first_seed + reproduction.seeds;
}

ResultTable frames_table(const std::vector<RowResult>& results)
{
    ResultTable table{"Frame of rupture, mean over the seeds",
                      {"sigma", "phi", "paper", "here", "off", "standard deviation", "of the mean",
                       "earliest", "latest", "seeds earlier than the paper", "share after full development",
                       "use"}};
    for (const RowResult& r : results) {
        const Spread s = r.spread();
        const auto n = static_cast<double>(r.frames.size());
        const std::string of = "/" + std::to_string(r.frames.size());
        table.add(r.row.sigma, r.row.phi, r.row.paper, (r.held > 0 ? ">= " : "") + whole(s.mean),
                  percent_off(s.mean, static_cast<double>(r.row.paper)), whole(s.deviation),
                  whole(s.deviation / std::sqrt(n)), whole(s.least),
                  r.held > 0 ? "holds: " + std::to_string(r.held) : whole(s.most),
                  std::to_string(r.earlier) + of, std::to_string(r.developed) + of,
                  r.fitted ? "calibration" : "prediction");
    }
    return table;
}

ResultTable seeds_table(const std::vector<RowResult>& results, const std::vector<Member>& members)
{
    ResultTable table{"Frame of rupture by seed", {"seed"}};
    for (const RowResult& r : results) {
        table.columns.push_back(r.row.name());
    }
    for (std::size_t m = 0; m < members.size(); ++m) {
        table.add(members[m].seed());
        for (const RowResult& r : results) {
            table.rows.back().push_back(number(r.frames[m], 6));
        }
    }
    return table;
}

/// Why a row is off: how near wall and impacts are in the paper's frame, and how little of Y the error is.
ResultTable reasons_table(const std::vector<RowResult>& results, double yield_limit)
{
    ResultTable table{"The same in terms of the wall: in the paper's frame of rupture",
                      {"row", "P_c [Pa]", "hardest impact so far [Pa]", "ratio",
                       "Y that would meet the paper's frame [Pa]", "against Y"}};
    for (const RowResult& r : results) {
        table.add(r.row.name(), r.wall, r.blow, number(r.blow / r.wall, 3), number(r.own_yield, 3),
                  percent_off(r.own_yield, yield_limit));
    }
    return table;
}

/// Largest load of the wall in each cycle after the first, over the members [N].
Spread crests(const std::vector<Member>& members, std::size_t cycle)
{
    std::vector<double> largest;
    for (const Member& member : members) {
        for (std::size_t k = cycle; k + cycle <= member.records.size(); k += cycle) {
            const auto part = std::span(member.records).subspan(k, cycle);
            largest.push_back(std::ranges::max(part, {}, &FrameRecord::wall_load).wall_load);
        }
    }
    return spread(largest);
}

/// By how much P_c of (13) falls from row to row at the same R and h, as in "13 %, 2 %".
std::string falls(const std::vector<RowResult>& results)
{
    std::vector<double> strengths;
    for (const RowResult& r : results) {
        strengths.push_back(reference::critical_pressure(1, 1, 1, r.row.sigma, r.row.phi));
    }
    std::ranges::sort(strengths, std::greater<>());
    std::string words;
    for (std::size_t k = 1; k < strengths.size(); ++k) {
        words += (k > 1 ? ", " : "") + number(100 * (1 - strengths[k] / strengths[k - 1]), 2) + " %";
    }
    return words;
}

/// Why a mean can't be expected to meet a row.
std::string scatter(const Scenario& scenario, const std::vector<RowResult>& results,
                    const std::vector<Member>& members)
{
    const double cycle = scenario.inlet.cycle_s / scenario.time.frame_s;
    const Spread s = crests(members, static_cast<std::size_t>(std::llround(cycle)));
    return "The largest load of the wall in a cycle is " + number(s.mean) +
           " N with a standard deviation of " + number(100 * s.deviation / s.mean, 2) +
           " %. From each row to the next weaker one P_c of (13) falls by about as much at the same R and "
           "h: " +
           falls(results) +
           ". So which crest breaks a wall is partly chance, and a mean over seeds is spread over several "
           "crests.";
}

double mean_of(const std::vector<RowResult>& results, double sigma, double phi)
{
    const auto found = std::ranges::find_if(
        results, [=](const RowResult& r) { return r.row.sigma == sigma && r.row.phi == phi; });
    return found->spread().mean;
}

/// Whether the means fall from row to row.
Claim falling(const std::string& words, const std::vector<double>& means)
{
    std::string found;
    for (const double mean : means) {
        found += (found.empty() ? "" : " > ") + whole(mean);
    }
    return {words, std::ranges::is_sorted(means, std::ranges::greater_equal()), found};
}

std::vector<Claim> claims_about(const std::vector<RowResult>& results)
{
    std::vector<double> by_sigma;
    std::vector<double> by_phi;
    std::int64_t late = 0;
    std::int64_t members = 0;
    for (const RowResult& r : results) {
        (r.row.phi == 0.003 ? by_sigma : by_phi).push_back(r.spread().mean);
        if (r.row.sigma < 0.35) {
            late += r.developed;
            members += static_cast<std::int64_t>(r.frames.size());
        }
    }
    by_phi.insert(by_phi.begin(), mean_of(results, 0.4, 0.003));
    return {falling("The smaller sigma, the later the rupture", by_sigma),
            falling("The larger phi, the earlier the rupture", by_phi),
            {"With sigma 0.2 and 0.3 the wall ruptures only after full development", late == members,
             std::to_string(late) + " of " + std::to_string(members) + " runs"}};
}

/// One wall for real, breach and all.
struct LiveRun {
    Scenario scenario;
    const RowResult* row = nullptr;
    const Member* member = nullptr;
    std::int64_t worked_out = 0; ///< frame of rupture; one more than there are frames: it holds
};

/// Two of the walls, of either half of the table.
std::vector<LiveRun> choose_live_runs(const Scenario& scenario, const std::vector<RowResult>& results,
                                      const std::vector<Member>& members)
{
    constexpr std::int64_t after = 20; // frames of bleeding
    std::vector<LiveRun> runs;
    for (std::size_t k = 0; k < 2; ++k) {
        const RowResult& row = results[results.size() - 1 - 3 * k];
        const std::size_t m = k % members.size();
        LiveRun run{with_seed(with_wall(scenario, row.row), members[m].seed()), &row, &members[m],
                    static_cast<std::int64_t>(row.frames[m])};
        run.scenario.name += "_live_sigma" + number(row.row.sigma) + "_phi" + number(row.row.phi);
        run.scenario.time.frames = std::min(run.worked_out + after, std::ssize(members[m].records));
        runs.push_back(run);
    }
    return runs;
}

/// They must rupture in the very frames that were worked out.
ResultTable live_table(Reproduction& reproduction, const std::vector<LiveRun>& runs)
{
    ResultTable table{"Live runs of single walls against the same walls worked out",
                      {"row", "seed", "worked out", "live", "frames with the same F_b to the bit"}};
    for (const LiveRun& run : runs) {
        reproduction.runs.make({run.scenario});
        const std::vector<FrameRecord> records = reproduction.runs.records(run.scenario);
        const auto ruptured = std::ranges::find(records, Phase::ruptured, &FrameRecord::phase);
        const std::int64_t live = ruptured == records.end() ? std::ssize(records) + 1 : ruptured->frame;
        if (live != run.worked_out) {
            throw Error(run.scenario.name,
                        "ruptures in frame " + std::to_string(live) + ", not " +
                            std::to_string(run.worked_out),
                        "the evaluation along recorded impacts is wrong: this is a fault of the program");
        }
        const auto [end, unused] = std::ranges::mismatch(
            records, run.member->records, {}, &FrameRecord::impact_force, &FrameRecord::impact_force);
        table.add(run.row->row.name(), run.member->seed(), run.worked_out, live, end - records.begin());
    }
    return table;
}

/// The rows that differ from sigma 0.4, phi 0.003 in one of the two alone.
PlotPanel panel(const std::vector<RowResult>& results, const std::string& title, const std::string& label,
                double RuptureRow::*varied, double RuptureRow::*fixed)
{
    PlotSeries theirs{"paper", {}, {}, "points", 1};
    PlotSeries ours{"mean of the seeds", {}, {}, "points", 0};
    PlotSeries single{"single seeds", {}, {}, "dots", 5};
    const RuptureRow common{0.4, 0.003};
    for (const RowResult& r : results) {
        if (r.row.*fixed == common.*fixed) {
            theirs.add(r.row.*varied, static_cast<double>(r.row.paper));
            ours.add(r.row.*varied, r.spread().mean);
            for (const double frame : r.frames) {
                single.add(r.row.*varied, frame);
            }
        }
    }
    return {title, label, "frame of rupture", {single, ours, theirs}, true};
}

} // namespace

Section table4(Reproduction& reproduction)
{
    const nlohmann::json plan = read_data("calibration.json");
    const Scenario scenario = calibrated_scenario();
    const std::vector<Member> members =
        ensemble(reproduction.runs, scenario, reproduction.first_seed, reproduction.seeds);
    std::vector<RowResult> results;
    std::vector<double> here;
    std::vector<double> paper;
    for (const RuptureRow& row : table4_rows(reproduction.paper)) {
        results.push_back(evaluate(row, scenario, members, is_fitted(row, plan)));
        here.push_back(results.back().spread().mean);
        paper.push_back(static_cast<double>(row.paper));
    }
    Section section{"table4", "Table 4: frame of rupture by Poisson's ratio and porosity"};
    section.text = {
        "Log-RMS error over the eight rows: " + number(log_rms(here, paper), 3) + ", over " +
            std::to_string(members.size()) + " seeds from " + std::to_string(members.front().seed()) +
            " on. R_0 and Y were calibrated on " +
            std::to_string(std::ranges::count_if(results, &RowResult::fitted)) + " of the rows and on " +
            (shares_seeds(plan, reproduction) ? "some of these" : "other") +
            " seeds; the other rows are predictions with these. The length unit, "
            "v_0 and the wave at the inlet were chosen beforehand in sight of the whole table (docs/reproduction.md).",
        "Rupture is the first time that the load of an impact, a maximum over few particles, exceeds a falling "
        "threshold. One run scatters by the standard deviation in the table; a single number as in the paper "
        "can't be expected to be nearer: it is one more draw, and the table says how many of the seeds are "
        "earlier. How little it takes is in the second table: the relative change of Y that would move a "
        "row's mean onto the paper's frame.",
        scatter(scenario, results, members),
        "Before the rupture neither sigma, phi nor Y acts on the flow, so one run of each seed gives all "
        "rows exactly; the live runs below rupture in the same frames."};
    section.tables = {frames_table(results), reasons_table(results, scenario.rupture.yield_limit_pa),
                      live_table(reproduction, choose_live_runs(scenario, results, members)),
                      seeds_table(results, members), resolution_study(reproduction, section.text)};
    section.claims = claims_about(results);
    section.pictures.push_back(plot(
        reproduction.folder("table4") / "table4.png",
        "Frame of rupture: of single seeds, their mean, and the paper's, by either variable of Table 4.", 2,
        {panel(results, "phi 0.003", "sigma", &RuptureRow::sigma, &RuptureRow::phi),
         panel(results, "sigma 0.4", "phi", &RuptureRow::phi, &RuptureRow::sigma)}));
    return section;
}

} // namespace aneurysm::reproduction
