// SPDX-License-Identifier: Apache-2.0
#include "reference/slices.hpp"

#include "common/guards.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace aneurysm::reference
{
namespace
{

/// A symmetric matrix with entries on the diagonal and beside it only, and a right side.
struct Tridiagonal {
    std::vector<double> diagonal;
    std::vector<double> beside; ///< of row c and c + 1
    std::vector<double> right;
};

/// Elimination from the first row on, then back. A pivot that is but rounding belongs to a row that says nothing.
std::vector<double> solve(const Tridiagonal& m)
{
    const std::size_t n = m.diagonal.size();
    std::vector<double> inverse(n, 0);
    std::vector<double> e(n, 0);
    for (std::size_t c = 0; c < n; ++c) {
        const double factor = c > 0 ? m.beside[c - 1] * inverse[c - 1] : 0;
        const double pivot = m.diagonal[c] - (c > 0 ? factor * m.beside[c - 1] : 0);
        inverse[c] = pivot > guards::smallest_pivot * m.diagonal[c] ? 1 / pivot : 0;
        e[c] = m.right[c] - (c > 0 ? factor * e[c - 1] : 0);
    }
    for (std::size_t c = n; c-- > 0;) {
        e[c] = inverse[c] * (e[c] - (c + 1 < n ? m.beside[c] * e[c + 1] : 0));
    }
    return e;
}

/// b_ic of body i, by slice.
std::map<std::size_t, Vec3> responses(const IncompressibleProblem& problem, const std::vector<bool>& member,
                                      std::size_t i)
{
    const Bodies& b = *problem.bodies;
    std::map<std::size_t, Vec3> response;
    for (const Neighbor& n : problem.neighbors->of(i)) {
        const Vec3 a = -b.mass[n.j] / (problem.rho_0 * problem.rho_0) * n.grad_W;
        if (member[i]) {
            response[slice_of(problem, i)] += weight(b, problem.given, n.j) * a;
        }
        if (member[n.j]) {
            response[slice_of(problem, n.j)] += a;
        }
    }
    return response;
}

} // namespace

std::vector<double> slice_potentials(const IncompressibleProblem& problem, const std::vector<bool>& member,
                                     std::span<const double> residual)
{
    const auto count = static_cast<std::size_t>(problem.slices.count);
    Tridiagonal sums{std::vector<double>(count, 0), std::vector<double>(count, 0),
                     std::vector<double>(count, 0)};
    const double factor = problem.dt * problem.rho_0 * problem.rho_0;
    for (std::size_t i = 0; i < problem.bodies->size(); ++i) {
        if (!problem.bodies->free(i)) {
            continue;
        }
        sums.right[slice_of(problem, i)] += member[i] ? residual[i] : 0;
        const auto response = responses(problem, member, i);
        for (const auto& [c, b] : response) {
            sums.diagonal[c] += factor * dot(b, b);
            const auto next = response.find(c + 1);
            if (next != response.end()) {
                sums.beside[c] += factor * dot(b, next->second);
            }
        }
    }
    return solve(sums);
}

} // namespace aneurysm::reference
