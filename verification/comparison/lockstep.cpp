// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/lockstep.hpp"

#include "common/error.hpp"
#include "output/columns.hpp"
#include "reference/simulation.hpp"
#include "verification/backends/float_state.hpp"
#include "verification/bounds/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aneurysm::comparison
{
namespace
{

constexpr double open_share = 0.01; ///< of frames, and of particles, that rounding may leave undecided

/// What is compared when rounding decides something: all, or only what doesn't depend on the exchange.
enum class Extent { all, without_exchange };

/// The candidate's frame beside the reference's.
struct Pair {
    const SimulationState& start;
    const SimulationState& candidate;
    const SimulationState& reference;
    const std::vector<double>& candidate_density;
    const std::vector<double>& reference_density;
    const FrameRecord& candidate_record;
    const FrameRecord& reference_record;
};

/// The named numbers of a record or a state, in their order.
struct Column {
    std::string_view name;
    double value = 0;
};
auto collector(std::vector<Column>& columns)
{
    return [&columns](std::string_view name, const auto& value) {
        columns.push_back({name, static_cast<double>(value)});
    };
}
std::vector<Column> columns_of(const FrameRecord& record)
{
    std::vector<Column> columns;
    output::visit_record(record, collector(columns));
    return columns;
}
std::vector<Column> columns_of(const AneurysmState& aneurysm)
{
    std::vector<Column> columns;
    output::visit_aneurysm(aneurysm, collector(columns));
    return columns;
}
std::vector<std::string_view> exchange_columns()
{
    std::vector<std::string_view> names{"fluid", "active"};
    const Ledger ledger;
    output::visit_ledger(ledger, [&](std::string_view name, const auto&) { names.push_back(name); });
    return names;
}

class Lockstep
{
public:
    Lockstep(const Scenario& scenario, Simulation& candidate)
        : scenario_(scenario), candidate_(candidate),
          is_double_(candidate.engine().precision == Precision::double_),
          unit_(bounds::unit_roundoff(candidate.engine().precision)), rounding_(unit_),
          reference_(scenario, candidate.state()),
          bounds_(scenario, reference_.vessel(), candidate.state().spacing, rounding_)
    {
    }

    FrameRecord frame();
    ComparisonResult result();

private:
    SimulationState start() const;
    void solve_alone(const SimulationState& start);
    std::vector<double> pressure_from(const SimulationState& start) const;
    FrameCheck check(const Pair& pair, const bounds::FrameRange& range, Extent extent);
    void check_particles(const Pair& pair, Extent extent, FrameCheck& check) const;
    static void check_record(const Pair& pair, const bounds::FrameRange& range, Extent extent,
                             FrameCheck& check);
    void check_impact(const FrameRecord& record, const bounds::FrameRange& range, FrameCheck& check) const;
    void check_state(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check) const;
    bool solves() const { return scenario_.pressure.model == PressureModel::dfsph; }
    bool corrects() const { return solves() && scenario_.pressure.density_correction > 0; }
    void check_solutions(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check);
    void check_taken(const Pair& pair, FrameCheck& check) const;
    void check_iterations(const FrameRecord& record, FrameCheck& check) const;

    const Scenario& scenario_;
    Simulation& candidate_;
    bool is_double_;
    double unit_;
    bounds::Rounding rounding_;
    reference::Simulation reference_;
    bounds::FrameBounds bounds_;
    ComparisonResult result_;
    FrameRecord own_;                ///< of the reference with its own solves
    double pressure_difference_ = 0; ///< between the candidate's solves and the reference's [Pa]
    double largest_pressure_ = 0;    ///< [Pa]
    std::int64_t unconverged_ = 0;   ///< frames in which a solve ended at its iteration limit
};

/// The candidate's state in its own bits: one that it was only given, and hasn't advanced yet, may have more.
/// A fully developed radius is a constant, which the candidate may hold rounded.
SimulationState Lockstep::start() const
{
    SimulationState state = candidate_.state();
    if (!is_double_) {
        backends::round_to_float(state.particles);
    }
    const double largest = reference_.vessel().largest_radius();
    double& R = state.aneurysm.radius;
    if (std::abs(R - largest) <= unit_ * largest) {
        R = largest;
    }
    return state;
}

/// The reference's own solves, for their numbers of iterations.
void Lockstep::solve_alone(const SimulationState& start)
{
    reference_.restart(start);
    own_ = reference_.advance();
    const std::vector<double>& own = reference_.solved_pressure();
    const std::vector<double>& p = candidate_.solved_pressure();
    for (std::size_t i = 0; i < std::min(own.size(), p.size()); ++i) {
        pressure_difference_ = std::max(pressure_difference_, std::abs(own[i] - p[i]));
        largest_pressure_ = std::max(largest_pressure_, std::abs(own[i]));
    }
}

/// The candidate's solved pressures. One at its lowest value is there for the reference, too, whose lowest
/// value may differ by rounding: else it would take it for one that still acts.
std::vector<double> Lockstep::pressure_from(const SimulationState& start) const
{
    std::vector<double> pressure = candidate_.solved_pressure();
    const std::size_t count = start.particles.size();
    const auto substeps = static_cast<double>(scenario_.time.substeps);
    for (std::size_t k = 0; k < pressure.size(); ++k) {
        const double steps = static_cast<double>(start.frame) + static_cast<double>(k / count + 1) / substeps;
        const bounds::Inexact lowest =
            bounds_.lowest_pressure(start.aneurysm.phase, steps * scenario_.time.frame_s);
        const bool is_lowest = std::abs(pressure[k] - lowest.value) <= rounding_.absolute(lowest.error);
        pressure[k] = is_lowest ? lowest.value : pressure[k];
    }
    return pressure;
}

FrameRecord Lockstep::frame()
{
    const SimulationState begin = start();
    const FrameRecord record = candidate_.advance();
    if (is_double_ && solves()) {
        solve_alone(begin);
    }
    reference_.restart(begin);
    bounds_.begin(begin.particles.size());
    const std::vector<double> pressure = pressure_from(begin);
    const FrameRecord expected = reference_.advance({pressure, candidate_.solved_kappa()}, bounds_);
    const bounds::FrameRange range = bounds_.finish(begin, reference_.state(), expected);
    const bounds::ParticleErrors& errors = bounds_.errors();
    result_.open_particles += std::ranges::count(errors.open, true);
    result_.particles += static_cast<std::int64_t>(errors.open.size());

    const Pair pair{
        begin,   candidate_.state(), reference_.state(), candidate_.density(), reference_.density(), record,
        expected};
    const FrameCheck all = check(pair, range, Extent::all);
    if (all.passed() || !(errors.frame_open || errors.exchange_open)) {
        result_.add(all);
        return record;
    }
    result_.open_frames.push_back(record.frame);
    if (!errors.frame_open) {
        result_.add(check(pair, range, Extent::without_exchange));
    }
    return record;
}

FrameCheck Lockstep::check(const Pair& pair, const bounds::FrameRange& range, Extent extent)
{
    FrameCheck check(pair.candidate_record.frame, pair.candidate_record.phase);
    check_particles(pair, extent, check);
    check_state(pair, range, check);
    check_record(pair, range, extent, check);
    check_impact(pair.candidate_record, range, check);
    check_solutions(pair, range, check);
    return check;
}

/// What waits in the reserve has neither place, velocity nor potential that means something.
void Lockstep::check_particles(const Pair& pair, Extent extent, FrameCheck& check) const
{
    const Particles& p = pair.candidate.particles;
    const Particles& q = pair.reference.particles;
    const bounds::ParticleErrors& e = bounds_.errors();
    const reference::Period& box = reference_.vessel().period();
    const auto same_size = [&](const auto&... fields) { return (... && (fields.size() == q.size())); };
    if (!same_size(p, p.kind, p.velocity, p.pressure, p.kappa, p.drift, pair.candidate_density)) {
        check.field("particles").add(1, 0);
        return;
    }
    for (std::size_t i = 0; i < q.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        const auto compare = [&](const char* field, double difference, double units) {
            check.field(field).add(difference, rounding_.absolute(units), index);
        };
        if (extent == Extent::all) {
            compare("kind", p.kind[i] == q.kind[i] || p.kind[i] == e.other_kind[i] ? 0 : 1, 0);
        } else if (p.kind[i] != q.kind[i] || q.kind[i] != pair.start.particles.kind[i] || e.open[i]) {
            continue;
        }
        compare("density [kg/m^3]", std::abs(pair.candidate_density[i] - pair.reference_density[i]),
                e.density[i]);
        if (q.kind[i] == Kind::reserve || p.kind[i] == Kind::reserve) {
            continue;
        }
        compare("position [m]", length(reference::difference(p.position[i], q.position[i], box)),
                e.position[i]);
        compare("velocity [m/s]", length(p.velocity[i] - q.velocity[i]), e.velocity[i]);
        compare("kappa [Pa]", std::abs(p.kappa[i] - q.kappa[i]), 0);
        compare("drift [kg/m^3]", std::abs(p.drift[i] - q.drift[i]), e.drift[i]);
        if (is_free(q.kind[i]) && p.kind[i] == q.kind[i]) {
            compare("pressure [Pa]", std::abs(p.pressure[i] - q.pressure[i]), e.pressure[i]);
        }
    }
}

void Lockstep::check_record(const Pair& pair, const bounds::FrameRange& range, Extent extent,
                            FrameCheck& check)
{
    const std::vector<Column> value = columns_of(pair.candidate_record);
    const std::vector<Column> expected = columns_of(pair.reference_record);
    const std::vector<Column> low = columns_of(range.low);
    const std::vector<Column> high = columns_of(range.high);
    const std::vector<std::string_view> exchange = exchange_columns();
    for (std::size_t k = 0; k < value.size(); ++k) {
        const std::string_view name = value[k].name;
        const bool elsewhere = name == "iterations" || name == "corrections" || name == "impact_particle";
        const bool dropped = extent != Extent::all && std::ranges::find(exchange, name) != exchange.end();
        if (!elsewhere && !dropped) {
            check.number(name, value[k].value, expected[k].value, low[k].value, high[k].value);
        }
    }
}

/// The particle that made F_b is one that may be in S, whose force is F_b and may be the largest.
void Lockstep::check_impact(const FrameRecord& record, const bounds::FrameRange& range,
                            FrameCheck& check) const
{
    FieldCheck& field = check.field("force of impact_particle [N]");
    if (record.impact_particle < 0) {
        field.add(range.low.impact_force, 0, record.impact_particle);
        return;
    }
    double best = std::numeric_limits<double>::infinity();
    double allowed = 0;
    for (const bounds::Hit& hit : bounds_.hits()) {
        const double error = rounding_.absolute(hit.force.error);
        const double difference = std::abs(record.impact_force - hit.force.value);
        if (hit.particle == record.impact_particle && hit.force.value + error >= range.low.impact_force &&
            difference <= best) {
            best = difference;
            allowed = error;
        }
    }
    field.add(best, allowed, record.impact_particle);
}

void Lockstep::check_state(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check) const
{
    const std::vector<Column> value = columns_of(pair.candidate.aneurysm);
    const std::vector<Column> expected = columns_of(pair.reference.aneurysm);
    AneurysmState errors = range.aneurysm_error;
    errors.phase = Phase{};
    errors.rupture_frame = 0;
    const std::vector<Column> error = columns_of(errors);
    for (std::size_t k = 0; k < value.size(); ++k) {
        check.number("state: " + std::string(value[k].name), value[k].value, expected[k].value,
                     error[k].value);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        check.number("state: outlet velocities [m/s]", pair.candidate.outlet_velocity.at(k),
                     pair.reference.outlet_velocity.at(k),
                     rounding_.absolute(bounds_.errors().outlet_velocity.at(k)));
    }
}

/// That the candidate's pressures and its correction of the density solve (3).
void Lockstep::check_solutions(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check)
{
    if (!solves()) {
        return;
    }
    check_taken(pair, check);
    const FrameRecord& expected = pair.reference_record;
    const auto& limits = scenario_.pressure;
    const auto within = [&](const char* name, double residual, double tolerance, double error) {
        check.field("solution of (3): " + std::string(name) + " [1/s]").add(residual, tolerance + error);
    };
    const bool is_solved = pair.candidate_record.iterations < limits.max_iterations;
    const bool is_corrected =
        !corrects() || pair.candidate_record.corrections < limits.correction_max_iterations;
    unconverged_ += is_solved && is_corrected ? 0 : 1;
    if (is_solved) {
        within("residual_mean", expected.residual_mean, limits.tolerance_per_s,
               range.high.residual_mean - expected.residual_mean);
        within("residual_max", expected.residual_max, limits.max_tolerance_per_s,
               range.high.residual_max - expected.residual_max);
    }
    const bounds::SolveEnd& correction = bounds_.correction();
    if (corrects() && is_corrected) {
        within("correction's mean residual", correction.mean, limits.correction_tolerance_per_s,
               correction.mean_error);
        within("correction's largest residual", correction.largest, limits.correction_max_tolerance_per_s,
               correction.largest_error);
    }
    if (is_double_) {
        check_iterations(pair.candidate_record, check);
    }
}

/// The reference takes no potential below its lowest value, and none of spray: what the candidate gives must
/// be what it has taken.
void Lockstep::check_taken(const Pair& pair, FrameCheck& check) const
{
    const std::size_t count = pair.start.particles.size();
    const auto check_all = [&](const char* name, const std::vector<double>& given,
                               const std::vector<double>& taken) {
        FieldCheck& field = check.field(name);
        for (std::size_t k = 0; k < taken.size(); ++k) {
            if (!std::isnan(taken[k]) || std::isnan(given[k])) {
                field.add(std::abs(given[k] - taken[k]), 0, static_cast<std::int64_t>(k % count));
            }
        }
    };
    check_all("solution of (3): pressure >= lowest [Pa]", pressure_from(pair.start),
              bounds_.taken_pressure());
    if (corrects()) {
        check_all("solution of (3): kappa >= lowest [Pa]", candidate_.solved_kappa(), bounds_.taken_kappa());
    }
}

void Lockstep::check_iterations(const FrameRecord& record, FrameCheck& check) const
{
    const auto same = [&](const char* name, std::int64_t value, std::int64_t expected) {
        check.number(name, static_cast<double>(value), static_cast<double>(expected), 0);
    };
    same("iterations", record.iterations, own_.iterations);
    same("corrections", record.corrections, own_.corrections);
}

ComparisonResult Lockstep::result()
{
    const auto frames = static_cast<double>(result_.frames.size() + result_.open_frames.size());
    if (static_cast<double>(result_.open_frames.size()) > std::ceil(open_share * frames)) {
        result_.problems.push_back("rounding decides what happens in " +
                                   std::to_string(result_.open_frames.size()) + " frames, more than 1 %");
    }
    if (static_cast<double>(result_.open_particles) > open_share * static_cast<double>(result_.particles)) {
        result_.problems.push_back("rounding decides about " + std::to_string(result_.open_particles) +
                                   " of " + std::to_string(result_.particles) + " particles, more than 1 %");
    }
    if (unconverged_ > 0) {
        result_.notes.push_back(std::to_string(unconverged_) + " frames at the limit of iterations");
    }
    if (is_double_ && solves()) {
        result_.notes.push_back("pressures differ from the reference's own solves by at most " +
                                std::to_string(pressure_difference_) + " Pa of " +
                                std::to_string(largest_pressure_) + " Pa");
    }
    return std::move(result_);
}

} // namespace

ComparisonResult compare_lockstep(const Scenario& scenario, Simulation& candidate, std::int64_t frames,
                                  const AfterFrame& after_frame)
{
    Lockstep lockstep(scenario, candidate);
    std::string problem;
    try {
        for (std::int64_t n = 0; n < frames; ++n) {
            if (!after_frame(lockstep.frame())) {
                break;
            }
        }
    } catch (const SimulationError& error) {
        problem = error.what();
    }
    ComparisonResult result = lockstep.result();
    if (!problem.empty()) {
        result.problems.push_back("stopped: " + problem);
    }
    return result;
}

} // namespace aneurysm::comparison
