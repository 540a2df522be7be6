// SPDX-License-Identifier: Apache-2.0
// GSL behind values and exceptions: every result comes with the bound of its own error.
#pragma once

#include <gsl/gsl_deriv.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace aneurysm::analytic
{

/// A number and the bound of its absolute error.
struct Estimate {
    double value = 0;
    double error = 0;
};

/// GSL refused or failed to converge.
class GslError : public std::runtime_error
{
public:
    GslError(const std::string& what, int status) : std::runtime_error(what + ": " + gsl_strerror(status)) {}
};

/// Turns a status of GSL into an exception.
inline void gsl_check(int status, const std::string& what)
{
    if (status != GSL_SUCCESS) {
        throw GslError(what, status);
    }
}

/// GSL's own handler aborts the program; this makes it return the status instead.
inline void gsl_return_errors()
{
    static const auto once = gsl_set_error_handler_off();
    static_cast<void>(once);
}

/// Owner of a GSL object, e.g. `Owned<gsl_root_fsolver, gsl_root_fsolver_free>`.
template <class Object, auto free>
struct Free {
    void operator()(Object* object) const { free(object); }
};
template <class Object, auto free>
using Owned = std::unique_ptr<Object, Free<Object, free>>;

template <class Function>
gsl_function gsl_function_of(Function& f)
{
    return {[](double x, void* self) { return (*static_cast<Function*>(self))(x); }, &f};
}

/// Adaptive quadrature over [a, b]; the error is GSL's own estimate,
/// which leaves rounding out, and 16 u of the value.
template <class Function>
Estimate integrate(Function f, double a, double b)
{
    gsl_return_errors();
    const Owned<gsl_integration_cquad_workspace, gsl_integration_cquad_workspace_free> work(
        gsl_integration_cquad_workspace_alloc(200));
    const gsl_function wrapped = gsl_function_of(f);
    Estimate result;
    gsl_check(
        gsl_integration_cquad(&wrapped, a, b, 0, 1e-13, work.get(), &result.value, &result.error, nullptr),
        "quadrature");
    result.error += 8 * std::numeric_limits<double>::epsilon() * std::abs(result.value);
    return result;
}

/// Gauss rule of 16 points over [a, b]: exact for polynomials of degree 31, up to rounding. The error covers
/// the 16 products and sums and, as ten roundings each, f's own values and the tabulated nodes and weights.
template <class Function>
Estimate integrate_polynomial(Function f, double a, double b)
{
    constexpr std::size_t points = 16;
    constexpr double roundings = points + 2 + 10;
    const Owned<gsl_integration_glfixed_table, gsl_integration_glfixed_table_free> rule(
        gsl_integration_glfixed_table_alloc(points));
    Estimate sum;
    for (std::size_t i = 0; i < points; ++i) {
        double x = 0;
        double weight = 0;
        gsl_integration_glfixed_point(a, b, i, &x, &weight, rule.get());
        const double term = weight * f(x);
        sum.value += term;
        sum.error += std::abs(term);
    }
    sum.error *= roundings * std::numeric_limits<double>::epsilon() / 2;
    return sum;
}

/// f'(0) by central differences of order 4 with steps around h; the error is GSL's own estimate.
template <class Function>
Estimate differentiate(Function f, double h)
{
    gsl_return_errors();
    const gsl_function wrapped = gsl_function_of(f);
    Estimate result;
    gsl_check(gsl_deriv_central(&wrapped, 0, h, &result.value, &result.error), "derivative");
    return result;
}

/// y(x_1) of dy/dx = f(x, y), y(x_0) = y_0, by Prince and Dormand's method of order 8. The error is the
/// number of steps times what each may add; that is a bound where neighboring solutions don't diverge.
template <class Function>
Estimate integrate_ode(Function f, double x_0, double y_0, double x_1)
{
    constexpr double step_error = 2e-15;
    gsl_return_errors();
    const auto slope = [](double x, const double* y, double* dydx, void* self) {
        *dydx = (*static_cast<Function*>(self))(x, *y);
        return std::isfinite(*dydx) ? static_cast<int>(GSL_SUCCESS) : static_cast<int>(GSL_EBADFUNC);
    };
    const gsl_odeiv2_system system{slope, nullptr, 1, &f};
    const Owned<gsl_odeiv2_driver, gsl_odeiv2_driver_free> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, (x_1 - x_0) / 100, 0, step_error));
    double x = x_0;
    double y = y_0;
    gsl_check(gsl_odeiv2_driver_apply(driver.get(), &x, x_1, &y), "ordinary differential equation");
    const double largest = std::max(std::abs(y_0), std::abs(y));
    return {y, static_cast<double>(driver->n) * step_error * largest};
}

/// The root of f in [a, b], whose ends have opposite signs, to the last bracket that Brent's method reaches.
template <class Function>
Estimate find_root(Function f, double a, double b)
{
    gsl_return_errors();
    const Owned<gsl_root_fsolver, gsl_root_fsolver_free> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    gsl_function wrapped = gsl_function_of(f);
    gsl_check(gsl_root_fsolver_set(solver.get(), &wrapped, a, b), "bracket of a root");
    constexpr double relative = 4 * std::numeric_limits<double>::epsilon();
    for (int step = 0; step < 200; ++step) {
        gsl_check(gsl_root_fsolver_iterate(solver.get()), "root");
        const double lower = gsl_root_fsolver_x_lower(solver.get());
        const double upper = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(lower, upper, 0, relative) == GSL_SUCCESS) {
            return {gsl_root_fsolver_root(solver.get()), upper - lower};
        }
    }
    throw GslError("root", GSL_EMAXITER);
}

} // namespace aneurysm::analytic
