// SPDX-License-Identifier: Apache-2.0
// Blood in the periodic box of data/scenarios/verify_box.json, whatever backend computes it: checks set it in
// motion, let it make a frame, and know what must come out.
#pragma once

#include "analytic/blood_flow.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/vectors.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace aneurysm::checks
{

/// Waves along each edge of the box.
using Mode = std::array<int, 3>;

/// The bound for a candidate that rounds by `u`, from an oracle's that bounds any text's rounding in double:
/// the oracle's own error and the candidate's.
constexpr double both(double oracle_error, double u)
{
    return oracle_error * (1 + u / 0x1p-53);
}

/// Moves each particle of these kinds by up to `way` [m] in each direction and gives it a velocity whose components are
/// up to `speed` [m/s]: multiples of 2^-9 of both, which single precision holds exactly where it holds the place.
void disturb(Particles& particles, std::initializer_list<Kind> kinds, double way, double speed,
             std::uint64_t seed);

class Box
{
public:
    /// Blood at rest on its lattice.
    Box(const Probe& probe, const Scenario& scenario);

    const Scenario& scenario() const { return scenario_; }
    const analytic::Medium& medium() const { return medium_; }
    double edge() const { return edge_; }                             ///< [m]
    Vec3 middle() const { return {edge_ / 2, edge_ / 2, edge_ / 2}; } ///< [m]
    std::size_t size() const { return state_.particles.size(); }
    SimulationState& state() { return state_; }
    const SimulationState& state() const { return state_; }

    Eigen::Vector3d wave_vector(const Mode& n) const; ///< [1/m]
    /// cos(k.r + turns of 2 pi) at each lattice point.
    std::vector<double> wave(const Mode& n, double turns = 0) const;
    /// 0 <= n_z <= n_y <= n_x <= cells/2 without 0: the lattice's symmetry gives the rest.
    std::vector<Mode> modes() const;

    void set_velocity(const std::vector<double>& wave, const Vec3& amplitude);
    /// All by up to `jitter` spacings.
    void disturb(double jitter, double speed, std::uint64_t seed);

    /// Leaves a cube of `edge` spacings in the middle; the rest waits in the reserve.
    void keep_drop(int edge);

    /// The oracle's view of a state, with the subject's own densities; what is in the reserve weighs nothing.
    analytic::Cloud cloud(const SimulationState& state, const std::vector<double>& density) const;

private:
    Scenario scenario_;
    SimulationState state_;
    double edge_;
    int cells_;
    analytic::Medium medium_;
};

/// Mean and largest |Drho/Dt|/rho_0 of a cloud's free particles, as a frame records them [1/s].
struct RecordedRates {
    double mean = 0;
    double largest = 0;
    double allowed = 0; ///< error of either: the sums' bounds for oracle and subject, the mean's additions

    void compare(Quantity& quantity, const FrameRecord& record, const std::string& where = {}) const;
};

/// By the sum (2) over all pairs, or by another oracle with an error of its own; `u`: roundoff of the subject.
RecordedRates recorded_rates(const analytic::Cloud& cloud, double rho_0, double u,
                             analytic::Estimate (*rate_of)(const analytic::Cloud&, std::size_t) = nullptr);

/// data/scenarios/verify_box.json with this kernel.
Scenario box_scenario(KernelName kernel = KernelName::cubic_spline, double ratio = 1);

} // namespace aneurysm::checks
