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
    FrameCheck check(const Pair& pair, const bounds::FrameRange& range, Extent extent);
    void check_particles(const Pair& pair, Extent extent, FrameCheck& check) const;
    static void check_record(const Pair& pair, const bounds::FrameRange& range, Extent extent,
                             FrameCheck& check);
    void check_impact(const FrameRecord& record, const bounds::FrameRange& range, FrameCheck& check) const;
    void check_state(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check) const;
    void check_solve(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check);

    const Scenario& scenario_;
    Simulation& candidate_;
    bool is_double_;
    double unit_;
    bounds::Rounding rounding_;
    reference::Simulation reference_;
    bounds::FrameBounds bounds_;
    ComparisonResult result_;
    std::int64_t own_iterations_ = 0;
    double pressure_difference_ = 0; ///< between the candidate's solves and the reference's [Pa]
    double largest_pressure_ = 0;    ///< [Pa]
    std::int64_t unconverged_ = 0;   ///< frames whose solve ended at its iteration limit
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

/// The reference's own solve, for its number of iterations.
void Lockstep::solve_alone(const SimulationState& start)
{
    reference_.restart(start);
    own_iterations_ = reference_.advance().iterations;
    const std::vector<double>& own = reference_.solved_pressure();
    const std::vector<double>& p = candidate_.solved_pressure();
    for (std::size_t i = 0; i < std::min(own.size(), p.size()); ++i) {
        pressure_difference_ = std::max(pressure_difference_, std::abs(own[i] - p[i]));
        largest_pressure_ = std::max(largest_pressure_, std::abs(own[i]));
    }
}

FrameRecord Lockstep::frame()
{
    const SimulationState begin = start();
    const FrameRecord record = candidate_.advance();
    if (is_double_ && scenario_.pressure.model == PressureModel::dfsph) {
        solve_alone(begin);
    }
    reference_.restart(begin);
    bounds_.begin(begin.particles.size());
    const FrameRecord expected = reference_.advance(candidate_.solved_pressure(), bounds_);
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
    check_solve(pair, range, check);
    return check;
}

/// Places and velocities of what waits in the reserve, and the pressure of what isn't blood, mean nothing.
void Lockstep::check_particles(const Pair& pair, Extent extent, FrameCheck& check) const
{
    const Particles& p = pair.candidate.particles;
    const Particles& q = pair.reference.particles;
    const bounds::ParticleErrors& e = bounds_.errors();
    const reference::Period& box = reference_.vessel().period();
    check.field("position [m]");
    check.field("velocity [m/s]");
    check.field("pressure [Pa]");
    check.field("density [kg/m^3]");
    if (p.size() != q.size() || p.kind.size() != q.size() || p.velocity.size() != q.size() ||
        p.pressure.size() != q.size() || pair.candidate_density.size() != q.size()) {
        check.field("particles").add(1, 0);
        return;
    }
    for (std::size_t i = 0; i < q.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        if (extent == Extent::all) {
            check.field("kind").add(p.kind[i] == q.kind[i] || p.kind[i] == e.other_kind[i] ? 0 : 1, 0, index);
        } else if (p.kind[i] != q.kind[i] || q.kind[i] != pair.start.particles.kind[i]) {
            continue;
        }
        check.field("density [kg/m^3]")
            .add(std::abs(pair.candidate_density[i] - pair.reference_density[i]),
                 rounding_.absolute(e.density[i]), index);
        if (q.kind[i] != Kind::reserve && p.kind[i] != Kind::reserve) {
            check.field("position [m]")
                .add(length(reference::difference(p.position[i], q.position[i], box)),
                     rounding_.absolute(e.position[i]), index);
            check.field("velocity [m/s]")
                .add(length(p.velocity[i] - q.velocity[i]), rounding_.absolute(e.velocity[i]), index);
        }
        if (is_free(q.kind[i])) {
            check.field("pressure [Pa]")
                .add(std::abs(p.pressure[i] - q.pressure[i]), rounding_.absolute(e.pressure[i]), index);
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
        const bool elsewhere = name == "iterations" || name == "impact_particle";
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

/// That the candidate's pressures solve (3).
void Lockstep::check_solve(const Pair& pair, const bounds::FrameRange& range, FrameCheck& check)
{
    if (scenario_.pressure.model != PressureModel::dfsph) {
        return;
    }
    const FrameRecord& expected = pair.reference_record;
    const std::vector<double>& given = candidate_.solved_pressure();
    const std::vector<double>& taken = bounds_.taken_pressure();
    FieldCheck& pressure = check.field("solution of (3): pressure >= 0 [Pa]");
    for (std::size_t k = 0; k < taken.size(); ++k) {
        if (!std::isnan(taken[k]) || std::isnan(given[k])) {
            pressure.add(std::abs(given[k] - taken[k]) + std::max(0.0, -given[k]), 0,
                         static_cast<std::int64_t>(k % pair.start.particles.size()));
        }
    }
    if (pair.candidate_record.iterations >= scenario_.pressure.max_iterations) {
        ++unconverged_;
    } else {
        check.field("solution of (3): residual_mean [1/s]")
            .add(expected.residual_mean,
                 scenario_.pressure.tolerance_per_s + range.high.residual_mean - expected.residual_mean);
        check.field("solution of (3): residual_max [1/s]")
            .add(expected.residual_max,
                 scenario_.pressure.max_tolerance_per_s + range.high.residual_max - expected.residual_max);
    }
    if (is_double_) {
        check.number("iterations", static_cast<double>(pair.candidate_record.iterations),
                     static_cast<double>(own_iterations_), 0);
    }
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
    if (is_double_ && scenario_.pressure.model == PressureModel::dfsph) {
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
