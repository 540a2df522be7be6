// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/json.hpp"
#include "common/scenario/limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

namespace aneurysm
{
namespace
{

using fields::Field;
using fields::Json;
using fields::Origin;

/// The shortest text that is this number, without ".0".
std::string text(double x)
{
    constexpr double exact = 9007199254740992;
    const bool integer = x == std::floor(x) && std::abs(x) < exact;
    return integer ? std::to_string(static_cast<std::int64_t>(x)) : Json(x).dump();
}

class Checker
{
public:
    Checker(const Scenario& scenario, const std::string& origin) : s_(scenario), origin_(origin) {}

    void check() const
    {
        std::vector<std::string> without_reason;
        fields::visit(s_, [&](const Field& field, const auto& member) {
            check_range(field, member);
            if (lacks_reason(field, member)) {
                without_reason.emplace_back(field.path);
            }
        });
        refuse_without(without_reason);
        check_domain();
        check_sac();
        if (s_.domain.form == DomainForm::artery) {
            check_vessel();
            check_resolution();
        }
        check_openings();
        check_inlet();
        check_steps();
        check_rest();
    }

private:
    [[noreturn]] void refuse(const std::string& path, const std::string& what,
                             const std::string& allowed) const
    {
        throw InputError(fields::place(origin_, path), what, "allowed: " + allowed);
    }
    /// `value` is a member of the scenario.
    template <class Number>
    void require(bool good, const Number& value, const std::string& what, const std::string& allowed) const
    {
        if (!good) {
            refuse(path_of(value), what + " (" + text(static_cast<double>(value)) + ")", allowed);
        }
    }
    std::string path_of(const auto& value) const
    {
        std::string path;
        fields::visit(s_, [&](const Field& field, const auto& member) {
            if (static_cast<const void*>(&member) == &value) {
                path = field.path;
            }
        });
        return path;
    }

    template <class Member>
    static bool from_paper(const Origin& origin, const Member& member)
    {
        if constexpr (std::is_enum_v<Member>) {
            return origin.gives(fields::name_of(member));
        } else if constexpr (std::is_arithmetic_v<Member>) {
            return origin.gives(static_cast<double>(member));
        } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
            return origin.gives(static_cast<double>(member.size()));
        } else {
            return false;
        }
    }

    /// The reader's rule once more: a scenario may have been made by other means.
    template <class Member>
    void check_range(const Field& field, const Member& member) const
    {
        const auto check_number = [&](double x) {
            if (!field.range.contains(x)) {
                refuse(std::string(field.path), "out of range (" + text(x) + ")",
                       fields::describe(field.range, std::is_integral_v<Member>));
            }
        };
        if constexpr (std::is_same_v<Member, Vec3>) {
            check_number(member.x);
            check_number(member.y);
            check_number(member.z);
        } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
            std::ranges::for_each(member, check_number);
        } else if constexpr (std::is_arithmetic_v<Member>) {
            check_number(static_cast<double>(member));
        }
    }

    template <class Member>
    bool lacks_reason(const Field& field, const Member& member) const
    {
        return field.origin.kind != Origin::Kind::setting && !s_.assumed.contains(std::string(field.path)) &&
               !from_paper(field.origin, member);
    }

    /// All paths at once, as they are to be written.
    void refuse_without(const std::vector<std::string>& paths) const
    {
        if (paths.empty()) {
            return;
        }
        std::string entries;
        for (const std::string& path : paths) {
            entries += (entries.empty() ? "\"" : ", \"") + path + "\": \"...\"";
        }
        refuse(
            "assumed." + paths.front(), "missing reason for a value that the paper doesn't give",
            "one of the paper's values, or here why this one was taken; all that are missing: \"assumed\": {" +
                entries + "}");
    }

    void check_domain() const
    {
        const auto& d = s_.domain;
        const bool artery = d.form == DomainForm::artery;
        const std::string name(fields::name_of(d.form));
        require((d.spacing_m > 0) != artery, d.spacing_m, "not the spacing of this form",
                artery ? "0, since domain.form is artery" : "a number > 0 for a " + name);
        if (!artery && s_.aneurysm.shape != SacShape::none) {
            refuse("aneurysm.shape", "an aneurysm needs an artery", "none, since domain.form is " + name);
        }
        const bool round = d.form == DomainForm::tube || d.form == DomainForm::pipe;
        const bool open = d.form == DomainForm::duct || d.form == DomainForm::pipe;
        check_cells(d.cells_x, !round);
        check_cells(d.cells_y, d.form == DomainForm::box || d.form == DomainForm::tube);
        check_cells(d.cells_z, !round);
        // Of a round form half of the lattice at least is blood, of the others all.
        const double lattice =
            static_cast<double>(d.cells_x) * static_cast<double>(d.cells_y) * static_cast<double>(d.cells_z);
        require(lattice / 2 <= static_cast<double>(s_.particles.count), d.cells_x,
                "more cells than particles.count has particles",
                "domain.cells_x * cells_y * cells_z up to particles.count (" +
                    std::to_string(s_.particles.count) + ")");
        require(!round || d.cells_x == d.cells_z, d.cells_z, "not as many as across",
                "domain.cells_x (" + std::to_string(d.cells_x) + ") for a " + name);
        require(!open || s_.fluid.gravity_cycle_s == 0, s_.fluid.gravity_cycle_s,
                "open ends and a force with a cycle", "0 for a " + name);
    }
    /// A periodic direction must be as wide as three supports, so that no particle sees another one twice.
    void check_cells(const std::int64_t& cells, bool periodic) const
    {
        if (s_.domain.form == DomainForm::artery) {
            require(cells == 0, cells, "cells of no lattice", "0, since domain.form is artery");
            return;
        }
        const double support = 2 * s_.kernel.smoothing_length_spacings;
        const auto least = periodic ? static_cast<std::int64_t>(std::ceil(3 * support)) : 1;
        require(cells >= least, cells, "too few",
                "at least " + std::to_string(least) + (periodic ? ", three supports" : ""));
    }

    void check_sac() const
    {
        const auto& a = s_.aneurysm;
        if (a.shape == SacShape::none) {
            const std::string allowed = "0, since aneurysm.shape is none";
            require(a.neck_width_radii == 0, a.neck_width_radii, "width of no neck", allowed);
            require(a.base_width_radii == 0, a.base_width_radii, "width of no aneurysm", allowed);
            require(a.initial_radius_radii == 0, a.initial_radius_radii, "radius of no aneurysm", allowed);
            return;
        }
        require(a.neck_width_radii > 0, a.neck_width_radii, "an aneurysm without a neck",
                "a number > 0 unless aneurysm.shape is none");
        require(a.initial_radius_radii > 0, a.initial_radius_radii, "an aneurysm without a size",
                "a number > 0 unless aneurysm.shape is none");
        require(a.neck_width_radii <= a.base_width_radii, a.neck_width_radii, "neck wider than the aneurysm",
                "at most aneurysm.base_width_radii (" + text(a.base_width_radii) + ")");
        require(a.shape != SacShape::hemispherical || a.neck_width_radii == a.base_width_radii,
                a.neck_width_radii, "a hemisphere is as wide at its neck as at its base",
                "aneurysm.base_width_radii (" + text(a.base_width_radii) + ") for a hemispherical aneurysm");
        require(a.initial_radius_radii <= a.base_width_radii / 2, a.initial_radius_radii,
                "larger than the fully developed aneurysm",
                "at most half of aneurysm.base_width_radii (" + text(a.base_width_radii / 2) + ")");
    }

    /// In units of r_0; plain geometry, so that nothing is sampled for a vessel that cannot be.
    void check_vessel() const
    {
        const auto& v = s_.vessel;
        const double B = v.angle_deg * std::numbers::pi / 180;
        const double r_1 = 1 / std::cbrt(2.0);
        const double apart = 2 * v.daughter_length_radii * std::sin(B);
        require(apart >= 1.25 * 2 * r_1, v.angle_deg, "the daughters overlap at their open ends",
                "an angle that leads their axes at least " + text(2.5 * r_1) + " radii apart there (now " +
                    text(apart) + "), or longer daughters");
        if (s_.aneurysm.shape == SacShape::none) {
            return;
        }
        const double R = s_.aneurysm.base_width_radii / 2;
        const double n = s_.aneurysm.neck_width_radii / 2;
        const double center = s_.aneurysm.shape == SacShape::piriform ? 1.5 * R : std::sqrt(R * R - n * n);
        const double gap = center * std::sin(B) + 2 * r_1;
        require(R <= gap, s_.aneurysm.base_width_radii, "larger than the gap between the daughters",
                "at most " + text(2 * gap) + " at this angle");
        const double along_daughter = (r_1 / std::sin(B) + center) * std::cos(B) + R;
        require(along_daughter < v.daughter_length_radii, s_.aneurysm.base_width_radii,
                "the aneurysm reaches the planes of the outlets",
                "a smaller aneurysm, or vessel.daughter_length_radii > " + text(along_daughter));
    }

    void check_resolution() const
    {
        const double r_1 = s_.vessel.radius_m / std::cbrt(2.0);
        const double support = 2 * s_.kernel.smoothing_length_spacings * estimated_spacing(s_);
        require(support <= 2 * r_1, s_.particles.count,
                "too few: the kernel's support radius, about " + text(support) +
                    " m, is larger than a daughter's diameter",
                "more particles, or shorter tubes");
    }

    void check_openings() const
    {
        const DomainForm form = s_.domain.form;
        const bool open = form == DomainForm::artery || form == DomainForm::duct || form == DomainForm::pipe;
        if (s_.inlet.profile == InletProfile::parabolic && (!open || form == DomainForm::duct)) {
            refuse("inlet.profile", "a parabola needs a round inlet (\"parabolic\")",
                   "plug, since domain.form is " + std::string(fields::name_of(form)));
        }
        require(open || s_.inlet.ramp_s == 0, s_.inlet.ramp_s, "start of no inlet",
                "0, since domain.form is " + std::string(fields::name_of(form)));
        require(!open || s_.outlet.pressure_pa > 0 || s_.outlet.level_margin == 0, s_.outlet.level_margin,
                "margin of a pressure that is 0", "0, or outlet.pressure_pa > 0");
    }

    void check_inlet() const
    {
        const auto& in = s_.inlet;
        const std::string times = "inlet.table_time_s";
        if (in.table_time_s.size() != in.table_velocity_m_s.size()) {
            refuse("inlet.table_velocity_m_s",
                   "not as long as inlet.table_time_s (" + std::to_string(in.table_velocity_m_s.size()) +
                       " values)",
                   std::to_string(in.table_time_s.size()) + " values");
        }
        if (in.table_time_s.empty()) {
            if (in.waveform == Waveform::table) {
                refuse(times, "empty, but inlet.waveform is table ([])", "at least one time, the first 0");
            }
            return;
        }
        const auto require_time = [&](bool good, double t, const std::string& what,
                                      const std::string& allowed) {
            if (!good) {
                refuse(times, what + " (" + text(t) + ")", allowed);
            }
        };
        const std::vector<double>& t = in.table_time_s;
        require_time(t.front() == 0, t.front(), "doesn't start at 0", "0 as the first time");
        for (std::size_t i = 1; i < t.size(); ++i) {
            require_time(t[i] > t[i - 1], t[i], "doesn't rise", "each time later than the one before");
        }
        require_time(t.back() < in.cycle_s, t.back(), "not within the cycle",
                     "times below inlet.cycle_s (" + text(in.cycle_s) + ")");
    }

    void check_steps() const
    {
        const double step = s_.time.frame_s / static_cast<double>(s_.time.substeps);
        // The estimate is within 10 %; the solver checks again with the spacing that sampling finds.
        const StepLimits limits = step_limits(s_, 1.1 * estimated_spacing(s_));
        const auto check_step = [&](double limit, const std::string& why) {
            require(step <= limit, s_.time.frame_s, "time step above the stability limit: " + why,
                    "time.frame_s / time.substeps of at most " + text(limit) + " s");
        };
        check_step(limits.convective, "the fastest particles would move half a particle spacing in one step");
        check_step(limits.viscous, "viscosity would overshoot");
        check_step(limits.acoustic, "sound would cross the kernel in one step");
        const double oscillation =
            s_.time.frame_s * std::sqrt(s_.elastic_wall.stiffness_n_m / s_.elastic_wall.mass_kg);
        require(oscillation < 2, s_.elastic_wall.stiffness_n_m,
                "time.frame_s is above the stability limit of (28)",
                "stiffness < 4 mass_kg / frame_s^2 (" +
                    text(4 * s_.elastic_wall.mass_kg / (s_.time.frame_s * s_.time.frame_s)) + ")");
    }

    void check_rest() const
    {
        const auto& p = s_.pressure;
        require(p.tolerance_per_s <= p.max_tolerance_per_s, p.max_tolerance_per_s,
                "a single particle's residual cannot be held below the mean",
                "at least pressure.tolerance_per_s (" + text(p.tolerance_per_s) + ")");
        require(p.correction_tolerance_per_s <= p.correction_max_tolerance_per_s,
                p.correction_max_tolerance_per_s,
                "a single particle's residual cannot be held below the mean",
                "at least pressure.correction_tolerance_per_s (" + text(p.correction_tolerance_per_s) + ")");
        const auto& g = s_.growth;
        require(g.thinning_intensity_per_m * g.largest_increment_m < 1, g.largest_increment_m,
                "(23) would make the wall's thickness negative",
                "less than 1 / growth.thinning_intensity_per_m");
        const auto& r = s_.rupture;
        require(r.recycle_distance_radii > r.breach_radius_radii, r.recycle_distance_radii,
                "blood would vanish in the breach itself",
                "more than rupture.breach_radius_radii (" + text(r.breach_radius_radii) + ")");
    }

    const Scenario& s_;
    const std::string& origin_;
};

} // namespace

void validate(const Scenario& scenario, const std::string& origin)
{
    Checker(scenario, origin).check();
}

} // namespace aneurysm
