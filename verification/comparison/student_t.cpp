// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/student_t.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::comparison
{
namespace
{

/// Probability that |t| exceeds a value, by the finite series for whole degrees of freedom (Abramowitz and
/// Stegun 26.7.3 and 26.7.4).
double two_sided_tail(double t, int freedom)
{
    const double theta = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double c2 = std::cos(theta) * std::cos(theta);
    const bool odd = freedom % 2 == 1;
    double term = odd ? std::cos(theta) : 1;
    double sum = 0;
    for (int k = odd ? 3 : 2; k <= freedom; k += 2) {
        sum += term;
        term *= c2 * (k - 1) / k;
    }
    const double inside =
        odd ? 2 / std::numbers::pi * (theta + std::sin(theta) * sum) : std::sin(theta) * sum;
    return 1 - inside;
}

} // namespace

double prediction_factor(int members, double alpha)
{
    double low = 0;
    double high = 1e9;
    for (int bisection = 0; bisection < 200; ++bisection) {
        const double middle = 0.5 * (low + high);
        (two_sided_tail(middle, members - 1) > alpha ? low : high) = middle;
    }
    return high * std::sqrt(1 + 1.0 / members);
}

} // namespace aneurysm::comparison
