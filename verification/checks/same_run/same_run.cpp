// SPDX-License-Identifier: Apache-2.0
// The same run with its particles numbered otherwise, in memory full
// of other bytes, in half steps: to the same bits.
#include "common/scenario/shipped.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/comparison/bits.hpp"
#include "verification/comparison/hash_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace aneurysm::checks
{
namespace
{

/// A third of the box, three layers of nine, gets the last numbers instead of the first.
template <class T>
std::vector<T> renumbered(std::vector<T> values)
{
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 3),
                values.end());
    return values;
}

SimulationState relabeled(SimulationState state)
{
    Particles& p = state.particles;
    p.position = renumbered(std::move(p.position));
    p.velocity = renumbered(std::move(p.velocity));
    p.pressure = renumbered(std::move(p.pressure));
    p.kappa = renumbered(std::move(p.kappa));
    p.drift = renumbered(std::move(p.drift));
    p.kind = renumbered(std::move(p.kind));
    return state;
}

/// In the optimized backends' order of cells, three along each edge, every sum stays as it was; the reference
/// adds in the order of the numbers.
void labels(Probe& probe)
{
    const bool by_cell = probe.subject().choice.backend != Backend::reference;
    const double u = probe.roundoff();
    Quantity& velocity =
        by_cell ? probe.quantity("velocities of the relabeled box [m/s]", Source::exact,
                                 "bits: sums run in the order of cells, and within a cell in that of the "
                                 "numbers, which the new ones keep")
                : probe.quantity("velocities of the relabeled box [m/s]", Source::rounding,
                                 "twice dt/rho times the bounds of the sums (6) and (7) for any order of "
                                 "their terms, and gamma_8 of |v| + dt |a|");
    std::vector<PressureModel> models{PressureModel::eos};
    if (by_cell) {
        models.push_back(PressureModel::dfsph);
    }
    for (const PressureModel model : models) {
        Scenario s = box_scenario(KernelName::cubic_spline, 1.3);
        s.domain.cells_x = s.domain.cells_y = s.domain.cells_z = 9;
        s.particles.count = 9 * 9 * 9;
        s.time.frame_s = 0x1p-12;
        s.pressure.model = model;
        s.pressure.stiffness_m2_s2 = 256;
        s.pressure.density_correction = 0.5;
        s.pressure.tolerance_per_s = 1e-3;
        s.fluid.viscosity_pa_s = 64;
        Box box(probe, s);
        box.disturb(0.25, 0.5, 2446);
        const auto one = probe.simulate(s, box.state());
        const auto other = probe.simulate(s, relabeled(box.state()));
        one->advance();
        other->advance();
        auto cloud = box.cloud(box.state(), one->density());
        for (std::size_t i = 0; i < box.size(); ++i) {
            cloud.pressure[i] = s.pressure.stiffness_m2_s2 * (cloud.density[i] - s.fluid.density_kg_m3);
        }
        const std::vector<Vec3> expected = renumbered(one->state().particles.velocity);
        for (std::size_t i = 0; i < box.size(); ++i) {
            const std::size_t k = (i + box.size() / 3) % box.size(); // its old number
            double allowed = 0;
            if (!by_cell) {
                const auto pressing = analytic::pair_pressure_force(cloud, k);
                const auto viscous = analytic::pair_viscosity_force(cloud, s.fluid.viscosity_pa_s, k);
                const double dt = s.time.frame_s;
                const double change = dt / cloud.density[k] * (pressing.value + viscous.value).norm();
                allowed = 2 * (dt / cloud.density[k] * both(pressing.error + viscous.error, u) +
                               probe.gamma(8) * (length(expected[i]) + change));
            }
            velocity.within(other->state().particles.velocity[i], expected[i], allowed,
                            "particle " + std::to_string(k));
        }
    }
}

/// Fills what is allocated from now on with a byte, as long as it lives.
class Filled
{
public:
#ifdef __GLIBC__
    explicit Filled(int byte)
    {
        mallopt(M_PERTURB, byte);
    }
    ~Filled()
    {
        mallopt(M_PERTURB, 0);
    }
    static constexpr bool works = true;
#else
    explicit Filled(int) {}
    ~Filled() = default;
    static constexpr bool works = false;
#endif
    Filled(const Filled&) = delete;
    Filled(Filled&&) = delete;
    Filled& operator=(const Filled&) = delete;
    Filled& operator=(Filled&&) = delete;
};

std::vector<std::string> hashes_in_memory_of(const Probe& probe, const Scenario& s, int byte)
{
    const Filled filled(byte);
    const auto flow = probe.simulate(s);
    for (int n = 0; n < 8; ++n) {
        flow->advance();
    }
    return comparison::hashes_of(flow->state());
}

/// glibc fills fresh memory with the complement of the byte, and freed memory with the byte. The optimized
/// backends' arrays are full of NaN in every run, see cuda/executor.hpp.
void memory(Probe& probe)
{
    if (!Filled::works) {
        probe.not_run("this C library can't fill fresh memory");
        return;
    }
    Quantity& hashes = probe.quantity("hashes of a run in memory full of other bytes", Source::exact,
                                      "bits: nothing is read before it is written");
    Scenario s = shipped_scenario("quick");
    s.growth.warm_up_frames = 4;
    const std::vector<std::string> expected = hashes_in_memory_of(probe, s, 0);
    for (const int byte : {0x01, 0xff}) {
        hashes.holds(hashes_in_memory_of(probe, s, byte) == expected, "byte " + std::to_string(byte));
    }
}

/// Until the wall moves, a frame of two flow steps is two frames of half the length.
void substeps(Probe& probe)
{
    Quantity& hashes =
        probe.quantity("hashes of frames of two flow steps", Source::exact,
                       "bits: half of the frame's length is exact, and so is the time at which a step ends");
    Quantity& record =
        probe.quantity("F_b, iterations and ledger of a frame of two flow steps", Source::exact,
                       "bits: the harder of two impacts, the sum of two numbers of iterations, the same "
                       "particles in and out");
    Scenario halves = shipped_scenario("quick");
    halves.growth.warm_up_frames = 1000;
    halves.time.frame_s /= 2;
    Scenario whole = halves;
    whole.time.frame_s *= 2;
    whole.time.substeps = 2;
    const auto one = probe.simulate(halves);
    const auto two = probe.simulate(whole);
    for (int n = 1; n <= 8; ++n) {
        const FrameRecord first = one->advance();
        const FrameRecord second = one->advance();
        const FrameRecord both = two->advance();
        const std::string where = "frame " + std::to_string(n);
        SimulationState counted = one->state();
        counted.frame = two->state().frame;
        hashes.holds(comparison::hashes_of(counted) == comparison::hashes_of(two->state()), where);
        record.within(both.impact_force, std::max(first.impact_force, second.impact_force), 0, where);
        record.within(both.time, second.time, 0, where);
        record.equal(both.iterations, first.iterations + second.iterations, where);
        record.equal(both.corrections, first.corrections + second.corrections, where);
        record.equal(both.collisions, first.collisions + second.collisions, where);
        record.equal(both.ledger.inlet_in, second.ledger.inlet_in, where);
        record.equal(both.ledger.recycled, second.ledger.recycled, where);
    }
}

} // namespace

std::vector<Check> same_run_checks()
{
    const std::vector<std::string_view> flow{"1", "2", "3", "5", "6", "7", "15", "EOS"};
    return {
        same_run_check("labels", flow, "a box whose particles have other numbers behaves as before",
                       {"the box as it was numbered"}, labels),
        same_run_check("memory", flow, "a run doesn't depend on what was in memory before",
                       {"the run in fresh memory"}, memory),
        same_run_check("substeps", {"1", "3", "7", "15", "16", "25", "26"},
                       "a frame of two flow steps is two frames of half the length, until the wall moves",
                       {"the run in short frames"}, substeps),
    };
}

} // namespace aneurysm::checks
