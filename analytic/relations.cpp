// SPDX-License-Identifier: Apache-2.0
#include "analytic/relations.hpp"

#include "analytic/exact/precise.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::analytic
{

double state_imbalance(double kappa, double rho, double rho_0, double p)
{
    return imbalance({Precise(p), Precise(kappa) * (Precise(rho_0) - rho)});
}

double laplace_imbalance(double P, double R, double h, double Sigma)
{
    const Precise disc = precise_pi() * R * R;
    const Precise rim = 2 * precise_pi() * R * h;
    return imbalance({P * disc, -Sigma * rim});
}

double thinning_imbalance(double sigma, double h, double R, double dR, double dh)
{
    return imbalance({Precise(dh) / h, Precise(sigma) * (Precise(dR) / R)});
}

double porosity_imbalance(double sigma, double R, double dR, double dphi)
{
    const auto volume = [&](const Precise& t) { // in units of the thickness; along the growth t dR
        const Precise radius = R + t * dR;
        const Precise thickness = 1 - sigma * (t * dR / R);
        return Precise(4 * precise_pi() * radius * radius * thickness);
    };
    return imbalance({Precise(dphi), precise_slope(volume, 0, 1) / volume(0)});
}

double porous_stress_imbalance(double Y, double phi, double Sigma)
{
    return imbalance({Precise(phi), -exp(Precise(-3) * Sigma / 2 / Y)});
}

double wall_law_imbalance(const WallState& w, double dR, double dP)
{
    const Precise dh = -Precise(w.sigma) * w.h / w.R * dR;
    const Precise dphi = -(2 - Precise(w.sigma)) / w.R * dR;
    const Precise by_pressure = Precise(dP) * w.R / 2 / w.h;
    const Precise by_radius = Precise(w.P) * dR / 2 / w.h;
    const Precise by_thickness = -Precise(w.P) * w.R / 2 / w.h * dh / w.h;
    const Precise by_porosity = -Precise(2) / 3 * w.Y / w.phi * dphi;
    return imbalance({by_pressure, by_radius, by_thickness, -by_porosity});
}

double excess(double F, double area, double P_c)
{
    const Precise force = Precise(P_c) * area;
    return static_cast<double>((F - force) / force);
}

double load_imbalance(double F_b, double M, double m, double F)
{
    return imbalance({Precise(F) * m, -Precise(F_b) * M});
}

double impulse_imbalance(double m, double v, double dt, double F)
{
    return imbalance({Precise(F) * dt, -Precise(m) * v});
}

double acceleration_imbalance(double rho, double F, double a)
{
    return imbalance({Precise(rho) * a, -Precise(F)});
}

double hit_imbalance(double m, double rho, const Eigen::Vector3d& F, double F_b)
{
    const Precise square = Precise(F.x()) * F.x() + Precise(F.y()) * F.y() + Precise(F.z()) * F.z();
    const Precise left = Precise(rho) * F_b;
    return imbalance({left * left, -Precise(m) * m * square});
}

double wall_force_imbalance(double F_B, double F_F, double F_P, double F_T)
{
    return imbalance({F_T, F_F, F_P, -F_B});
}

double radiated_power_imbalance(double rho_F, double a, double c, double u_t, double F_F)
{
    const Precise density_of_energy = Precise(rho_F) * u_t * u_t / 2;
    const Precise volume = Precise(a) * c;
    return imbalance({Precise(F_F) * u_t, -density_of_energy * volume, -density_of_energy * volume});
}

double fiber_work_imbalance(const Tissue& w, double epsilon, double F_P)
{
    const auto energy = [&](double K, double A) { return Precise(Precise(K) * epsilon * epsilon * A / 2); };
    return imbalance({Precise(F_P) * epsilon / 2, -energy(w.K_E, w.A_E), -energy(w.K_C, w.A_C)});
}

double strain_imbalance(double dR, double R, double epsilon)
{
    return imbalance({Precise(epsilon) * R, -Precise(dR)});
}

double growth_imbalance(const Tissue& w, double F_B, double R, double dt, double dR)
{
    const Precise u_t = Precise(dR) / dt;
    const Precise epsilon = Precise(dR) / R;
    return imbalance({Precise(F_B), -(w.m * u_t) / dt, -u_t * w.c * w.a * w.rho_F, -epsilon * w.A_E * w.K_E,
                      -epsilon * w.A_C * w.K_C});
}

double thinning_step_imbalance(double h, double R, double sigma, double dR, double h_new)
{
    return imbalance({Precise(h_new), -Precise(h), Precise(dR) / R * sigma * h});
}

double developed_step_imbalance(double h, double alpha, double dR, double largest, double h_new)
{
    const Precise taken = dR > largest ? largest : dR;
    return imbalance({Precise(h_new), -Precise(h), taken * h * alpha});
}

double murray_imbalance(double r_0, const std::vector<double>& daughters)
{
    Precise sum = 0;
    for (const double r : daughters) {
        sum += pow(Precise(r), 3);
    }
    return imbalance({pow(Precise(r_0), 3), -sum});
}

double outlet_force_imbalance(const std::vector<double>& m, double rho_0, double p,
                              const std::vector<double>& dW_dx, double F)
{
    std::vector<Precise> terms{Precise(F) * rho_0};
    for (std::size_t j = 0; j < m.size(); ++j) {
        terms.push_back(-2 * Precise(p) * m[j] * dW_dx[j]);
    }
    return imbalance(terms);
}

double inflow_imbalance(double rho_0, double v, double D, double F)
{
    return imbalance({Precise(F) * D, -Precise(rho_0) * v * v / 2});
}

double oscillator_residual(double m, double k, double F, double dt, double u_before, double u, double u_after)
{
    const Precise second = (Precise(u_after) - 2 * Precise(u) + u_before) / (Precise(dt) * dt);
    return static_cast<double>(F - Precise(k) * u - m * second);
}

double displacement_residual(double dt, double u, double u_after, double v_after)
{
    return static_cast<double>(Precise(u_after) - u - Precise(dt) * v_after);
}

CollisionResidual collision_residual(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
                                     double depth, const Eigen::Vector3d& n,
                                     const Eigen::Vector3d& position_after,
                                     const Eigen::Vector3d& velocity_after)
{
    using Vector = std::array<Precise, 3>;
    const auto dot = [](const auto& a, const auto& b) {
        return Precise(Precise(a[0]) * b[0] + Precise(a[1]) * b[1] + Precise(a[2]) * b[2]);
    };
    const Precise length = sqrt(dot(n, n));
    const Vector unit{n[0] / length, n[1] / length, n[2] / length};
    const Precise before = dot(velocity, unit);
    const Precise after = dot(velocity_after, unit);
    Precise tangential = 0;
    Precise place = 0;
    for (int k = 0; k < 3; ++k) {
        const auto a = static_cast<std::size_t>(k);
        const Precise change = Precise(velocity_after[k]) - velocity[k] - (after - before) * unit[a];
        const Precise gap = Precise(position[k]) - position_after[k] - depth * unit[a];
        tangential = std::max(tangential, Precise(abs(change)));
        place = std::max(place, Precise(abs(gap)));
    }
    return {static_cast<double>(before > 0 ? after + before : after - before),
            static_cast<double>(tangential), static_cast<double>(place)};
}

} // namespace aneurysm::analytic
