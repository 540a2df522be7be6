// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/check.hpp"

#include "common/process/interrupt.hpp"
#include "output/report/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aneurysm::suite
{
namespace
{

/// A flow that ends at Ctrl-C: checks make many frames.
class Stoppable final : public Simulation
{
public:
    explicit Stoppable(std::unique_ptr<Simulation> backend) : backend_(std::move(backend)) {}

    Engine engine() const override { return backend_->engine(); }
    FrameRecord advance() override
    {
        if (InterruptWatch::interrupted()) {
            throw Interrupted();
        }
        return backend_->advance();
    }
    const SimulationState& state() const override { return backend_->state(); }
    const std::vector<double>& density() const override { return backend_->density(); }
    const std::vector<double>& solved_pressure() const override { return backend_->solved_pressure(); }
    const std::vector<double>& solved_kappa() const override { return backend_->solved_kappa(); }

private:
    std::unique_ptr<Simulation> backend_;
};

} // namespace

Quantity::Quantity(std::string name, Source source, std::string derivation)
    : name_(std::move(name)), source_(source), derivation_(std::move(derivation))
{
    if (derivation_.empty()) {
        throw std::logic_error("quantity '" + name_ + "' has no derivation of its bound");
    }
}

bool Quantity::within(double value, double expected, double allowed, std::string_view where)
{
    const double error = std::abs(value - expected);
    const bool good = error <= allowed; // false for a NaN
    const double infinite = std::numeric_limits<double>::infinity();
    const double ratio = error == 0 && allowed >= 0         ? 0
                         : allowed > 0 && error <= infinite ? error / allowed
                                                            : infinite;
    ++compared_;
    failed_ += good ? 0 : 1;
    if (ratio > worst_.ratio || worst_.ratio < 0) {
        worst_ = {value, expected, error, allowed, ratio, std::string(where)};
    }
    return judged(good);
}

bool Quantity::judged(bool good) const
{
    if (!good && first_failure_ends) {
        throw FirstFailure(name_);
    }
    return good;
}

bool Quantity::within(double value, const analytic::Estimate& expected, double relative,
                      std::string_view where)
{
    return within(value, expected.value, expected.error + relative * std::abs(expected.value), where);
}

bool Quantity::within(const Vec3& value, const Vec3& expected, double allowed, std::string_view where)
{
    const bool x = within(value.x, expected.x, allowed, where);
    const bool y = within(value.y, expected.y, allowed, where);
    const bool z = within(value.z, expected.z, allowed, where);
    return x && y && z;
}

bool Quantity::equal(std::int64_t value, std::int64_t expected, std::string_view where)
{
    return within(static_cast<double>(value), static_cast<double>(expected), 0, where);
}

bool Quantity::found(std::int64_t compared, std::int64_t failed, double error, double allowed,
                     std::string_view where)
{
    if (compared == 0) {
        return false;
    }
    const bool good = within(error, 0, allowed, where) && failed == 0;
    compared_ += compared - 1;
    failed_ += std::max<std::int64_t>(failed - (error <= allowed ? 0 : 1), 0);
    return judged(good);
}

bool Quantity::holds(bool claim, std::string_view where)
{
    return within(claim ? 1 : 0, 1, 0, where);
}

bool Quantity::loose() const
{
    constexpr double much = 1000;
    return worst_.allowed > much * std::max(worst_.error, 0x1p-53 * std::abs(worst_.expected));
}

std::string Subject::name() const
{
    return name_of(choice);
}

std::unique_ptr<Simulation> Probe::simulate(const Scenario& scenario,
                                            std::optional<SimulationState> state) const
{
    return std::make_unique<Stoppable>(
        backends::make_simulation(subject_->choice, scenario, std::move(state)));
}

Quantity& Probe::quantity(std::string name, Source source, std::string derivation)
{
    return result_->quantities.emplace_back(std::move(name), source, std::move(derivation));
}

void Probe::accuracy(Accuracy accuracy)
{
    const std::string limit = accuracy.allowed() > accuracy.asked
                                  ? "; not met yet, and not to exceed what it was: " + accuracy.known->source
                                  : "";
    quantity(accuracy.name, Source::nature,
             "asked of the model: at most " + report::shown(accuracy.asked) + limit)
        .within(accuracy.value, 0, accuracy.allowed());
    result_->accuracies.push_back(std::move(accuracy));
}

void Probe::note(std::string name, double value, std::string remark)
{
    result_->notes.push_back({std::move(name), value, std::move(remark)});
}

void Probe::plot(Plot plot)
{
    result_->plots.push_back(std::move(plot));
}

void Probe::not_run(std::string reason)
{
    result_->message = std::move(reason);
}

} // namespace aneurysm::suite
