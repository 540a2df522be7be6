// SPDX-License-Identifier: Apache-2.0
// The kernel W of (4)-(6), its gradient, and the Laplacian of (7):
// values, and the integrals that they stand for.
#include "analytic/kernel_function.hpp"
#include "analytic/exact/kernel.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;

/// The text that a quantity's bound is explained with where W is compared.
constexpr const char* of_value =
    "gamma_16 S + the change of W when q = r/h is off by gamma_2; S = 13/4 W(0) for the spline's r < h, "
    "where it subtracts, else W: any text of W has at most 5 roundings in its factor of pi and h and 10 in "
    "its polynomial, the oracle's value 1";
constexpr const char* of_gradient =
    "gamma_24 S + the change of W' when q = r/h is off by gamma_5; S = 7 |W'| for the spline's r < h, where "
    "it subtracts, else |W'|: at most 8 roundings in the factor of pi and h, 8 in the polynomial, 2 in the "
    "direction, 5 of r and q in W'/r, 1 of the oracle's value";

/// Both kernels at radii across the support: the breaks and their neighbors, 0, and beyond.
template <class Look>
void for_all_radii(Look look)
{
    for (const KernelName name : both_kernels) {
        for (const double h : {0.037, 2.3}) {
            std::vector<double> radii{0, h, 2 * h, 3 * h, 1e6};
            for (const double edge : {h, 2 * h}) {
                for (int k = 1; k < 15; ++k) {
                    radii.push_back(edge * (1 - std::pow(10, -k)));
                    radii.push_back(edge * (1 + std::pow(10, -k)));
                }
                radii.push_back(std::nextafter(edge, 0));
                radii.push_back(std::nextafter(edge, 9));
            }
            for (int i = 1; i < 150; ++i) {
                radii.push_back(i * h / 70.3);
            }
            for (const double r : radii) {
                look(name, h, r, kernel_text(name) + at({{"h", h}, {"q", r / h}}));
            }
        }
    }
}

void eq04_kernel(Probe& probe)
{
    const std::string of_oracle = "gamma_16 of the powers' magnitudes and the same change, of the oracle";
    Quantity& powers =
        probe.quantity("W against truncated powers [1/m^3]", Source::rounding, of_value + ("; " + of_oracle));
    Quantity& splines =
        probe.quantity("W against its definition, 50 digits [1/m^3]", Source::rounding, of_value);
    Quantity& oracles = probe.quantity("truncated powers against the definition [1/m^3]", Source::rounding,
                                       of_oracle + "; 1 of the definition's value");
    Quantity& outside =
        probe.quantity("W from the support radius on [1/m^3]", Source::exact, "0: nothing is computed");
    for_all_radii([&](KernelName name, double h, double r, const std::string& where) {
        const double W = probe.equations().kernel_value(name, h, r);
        if (r >= 2 * h) {
            outside.within(W, 0, 0, where);
            return;
        }
        const double definition = analytic::exact_kernel(name, h, r, 0).value;
        const double power = analytic::kernel(name, h, r);
        const double of_power = power_rounding(name, h, r);
        const double allowed = value_rounding(name, h, r);
        splines.within(W, definition, allowed, where);
        powers.within(W, power, allowed + of_power, where);
        oracles.within(power, definition, of_power + rounding(1) * W, where);
    });
}

void eq04_kernel_moments(Probe& probe)
{
    const std::string of_rule = "28 u on the Gauss rule's terms, which is exact for these polynomials";
    Quantity& moments = probe.quantity("int W r^p dV, p = 0, 2, 4, over the exact rational [1]",
                                       Source::quadrature, of_rule + "; W's own rounding, integrated");
    Quantity& oracle = probe.quantity("the same of truncated powers [1]", Source::quadrature,
                                      of_rule + "; the oracle's rounding, integrated");
    for (const KernelName name : both_kernels) {
        for (const double h : {0.037, 2.3}) {
            for (const int p : {0, 2, 4}) {
                const double exact = analytic::exact_moment(name, h, p);
                const std::string where = kernel_text(name) + at({{"h", h}, {"p", double(p)}});
                const auto look = [&](Quantity& quantity, const analytic::Radial& W,
                                      const analytic::Radial& bound) {
                    const Estimate found = analytic::moment(W, h, p);
                    const double allowed = found.error + analytic::moment(bound, h, p).value;
                    quantity.within(found.value / exact, 1, allowed / exact, where);
                };
                look(
                    moments, [&](double r) { return probe.equations().kernel_value(name, h, r); },
                    [&](double r) { return value_rounding(name, h, r); });
                look(
                    oracle, [&](double r) { return analytic::kernel(name, h, r); },
                    [&](double r) { return power_rounding(name, h, r); });
            }
        }
    }
}

void eq06_gradient(Probe& probe)
{
    Quantity& powers = probe.quantity("grad W against derived powers [1/m^4]", Source::rounding,
                                      std::string(of_gradient) + "; gamma_24 20 W(0)/h of the oracle");
    Quantity& differences =
        probe.quantity("grad W against differences of W, 50 digits [1/m^4]", Source::rounding, of_gradient);
    Quantity& oracles = probe.quantity("derived powers against the differences [1/m^4]", Source::rounding,
                                       "gamma_24 20 W(0)/h: 16 roundings and those of the direction on terms "
                                       "that add up to 20 W(0)/h at most");
    Quantity& bits = probe.quantity("grad W(-x) + grad W(x), grad W at 0 and outside [1/m^4]", Source::exact,
                                    "0: a sign costs no rounding, and nothing is computed");
    Arguments arguments(6);
    for_all_radii([&](KernelName name, double h, double radius, const std::string& where) {
        const Vec3 toward = arguments.vector(1);
        const Vec3 x = radius / length(toward) * toward;
        const Vec3 gradient = probe.equations().kernel_gradient(name, h, x);
        bits.within(probe.equations().kernel_gradient(name, h, -x) + gradient, {}, 0, where);
        const double r = to_eigen(x).norm();
        if (radius == 0 || r >= 2 * h * (1 + rounding(4))) {
            bits.within(gradient, {}, 0, where);
            return;
        }
        const Vec3 differenced = to_vec3(analytic::exact_kernel_gradient(name, h, to_eigen(x)));
        const Vec3 power = analytic::kernel_slope(name, h, r) / r * x;
        const double of_power = rounding(24) * 20 * analytic::kernel(name, h, 0) / h;
        const double allowed = gradient_rounding(name, h, r);
        differences.within(gradient, differenced, allowed, where);
        powers.within(gradient, power, allowed + of_power, where);
        oracles.within(power, differenced, of_power, where);
    });
}

void eq06_gradient_moments(Probe& probe)
{
    const std::string bound = "28 u on the Gauss rule's terms; the gradient's own rounding, integrated";
    Quantity& first = probe.quantity("int x_a dW/dx_a dV [1]", Source::quadrature, bound);
    Quantity& square =
        probe.quantity("int |grad W|^2 dV over the exact value [1]", Source::quadrature, bound);
    Quantity& rise = probe.quantity("W(r) + int_r^2h W' dr over W(0) [1]", Source::quadrature,
                                    bound + "; the rounding of W");
    const Vec3 direction{2.0 / 7, -3.0 / 7, 6.0 / 7};
    for (const KernelName name : both_kernels) {
        const double h = 0.037;
        const auto slope = [&](double r) {
            return dot(direction, probe.equations().kernel_gradient(name, h, r * direction));
        };
        // the vector has 2 roundings, and the product with the direction 4
        const auto allowed = [&](double r) {
            return gradient_rounding(name, h, r, 2) +
                   rounding(4) * std::abs(analytic::kernel_slope(name, h, r));
        };
        const auto compare = [&](Quantity& quantity, double exact, const analytic::Radial& f,
                                 const analytic::Radial& error) {
            const Estimate found = analytic::moment(f, h, 0);
            quantity.within(found.value / exact, 1,
                            (found.error + analytic::moment(error, h, 0).value) / std::abs(exact),
                            kernel_text(name));
        };
        compare(
            first, -1, [&](double r) { return r * slope(r) / 3; },
            [&](double r) { return r * allowed(r) / 3; });
        compare(
            square, analytic::exact_gradient_norm(name, h), [&](double r) { return slope(r) * slope(r); },
            [&](double r) { return 2 * std::abs(slope(r)) * allowed(r); });
        const double W_0 = analytic::kernel(name, h, 0);
        for (int i = 0; i < 20; ++i) {
            const double r = i * h / 10.3;
            Estimate sum{probe.equations().kernel_value(name, h, r), value_rounding(name, h, r)};
            for (const auto& [a, b] : {std::pair{std::min(r, h), h}, std::pair{std::max(r, h), 2 * h}}) {
                const Estimate part = analytic::integrate_polynomial(slope, a, b);
                sum.value += part.value;
                sum.error += part.error + analytic::integrate_polynomial(allowed, a, b).value;
            }
            rise.within(sum.value / W_0, 0, sum.error / W_0, kernel_text(name) + at({{"q", r / h}}));
        }
    }
}

void eq07_laplacian(Probe& probe)
{
    const std::string of_text = "gamma_11 lap W: pi, 7 operations in the factor, a difference and a product "
                                "of exact H and r, 1 of the oracle's value";
    Quantity& differences = probe.quantity("lap W against second differences, 50 digits [1/m^5]",
                                           Source::rounding, of_text + "; the differences' own error");
    Quantity& polynomial = probe.quantity("lap W against the derived polynomial [1/m^5]", Source::rounding,
                                          of_text + "; gamma_8 2 lap W(0) of the oracle");
    Quantity& oracles = probe.quantity("derived polynomial against the differences [1/m^5]", Source::rounding,
                                       "gamma_9 2 lap W(0): 8 roundings on terms as large as lap W(0), 1");
    Quantity& outside =
        probe.quantity("lap W from the support radius on [1/m^5]", Source::exact, "0: nothing is computed");
    for_all_radii([&](KernelName, double h, double r, const std::string& where) {
        const double H = 2 * h;
        const double found = probe.equations().viscosity_laplacian(h, r);
        if (r >= H) {
            outside.within(found, 0, 0, where);
            return;
        }
        const double derived = analytic::viscosity_kernel_laplacian(H, r);
        const double of_derived = 2 * analytic::viscosity_kernel_laplacian(H, 0);
        polynomial.within(found, derived, rounding(11) * derived + rounding(8) * of_derived, where);
        if (r > 0) { // a difference needs room on both sides
            const Estimate differenced = analytic::exact_viscosity_laplacian(H, r);
            differences.within(found, differenced, rounding(11), where);
            oracles.within(derived, differenced.value, rounding(9) * of_derived, where);
        }
    });
}

void eq07_laplacian_moments(Probe& probe)
{
    const std::string bound = "28 u on the Gauss rule's terms; gamma_11 of lap W >= 0, 4 of the exact value";
    Quantity& moments = probe.quantity(
        "int r^p lap W dV, p = 0, 2, 4, over the exact value [1]", Source::quadrature,
        bound + "; the exact values follow from int r^2 lap W = 6 int W and int r^4 lap W = 20 int r^2 W");
    Quantity& transform = probe.quantity("int lap W dV over its Fourier transform at 0 [1]",
                                         Source::quadrature, bound + "; gamma_32 of the series' first term");
    for (const double h : {0.037, 2.3}) {
        const double H = 2 * h;
        const std::array exact{15 / (H * H), 6.0, 45 * H * H / 14};
        for (const int p : {0, 2, 4}) {
            const auto lap = [&](double r) { return probe.equations().viscosity_laplacian(h, r); };
            const Estimate found = analytic::moment(lap, h, p);
            const double value = exact[static_cast<std::size_t>(p / 2)];
            const double allowed = found.error / value + rounding(11 + 4);
            moments.within(found.value / value, 1, allowed, at({{"h", h}, {"p", double(p)}}));
            if (p == 0) {
                transform.within(found.value / analytic::viscosity_transform(H, 0).value, 1,
                                 allowed + rounding(32), at({{"h", h}}));
            }
        }
    }
}

} // namespace

std::vector<Check> kernel_function_checks()
{
    return {
        formula_check("eq04_kernel", {"4"}, "both kernels have their values, on each side of their breaks",
                      {"truncated powers", "Cox-de Boor recursion and Wendland's integral, 50 digits"},
                      eq04_kernel),
        formula_check("eq04_kernel_moments", {"4"},
                      "both kernels have unit mass and the exact second and fourth moments",
                      {"exact rationals", "Gauss rule over truncated powers"}, eq04_kernel_moments),
        formula_check(
            "eq06_gradient", {"6"},
            "the kernels' gradients are their derivatives, in any direction, at 0 and at the support's end",
            {"derived powers", "differences of the kernel's definition, 50 digits"}, eq06_gradient),
        formula_check("eq06_gradient_moments", {"6"},
                      "the gradients' integrals are exact, and they integrate to the kernel itself",
                      {"exact values", "Gauss rule over the kernel's own slope"}, eq06_gradient_moments),
        formula_check("eq07_laplacian", {"7"}, "the viscosity Laplacian is that of Mueller's kernel",
                      {"derived polynomial", "second differences of Mueller's kernel, 50 digits"},
                      eq07_laplacian),
        formula_check("eq07_laplacian_moments", {"7"},
                      "the viscosity Laplacian is exact for r^2 and r^4, and has its Fourier transform at 0",
                      {"exact values", "Fourier transform"}, eq07_laplacian_moments),
    };
}

} // namespace aneurysm::checks
