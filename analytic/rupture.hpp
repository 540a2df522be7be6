// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.2, (8)-(16). The wall's law is linear in P: with E = 2 Y (2 - sigma) / (3 phi),
// dP/dR + (1 + sigma) P/R = 2 E h/R^2; everything about P(R) follows from that.
#pragma once

#include "analytic/gsl.hpp"

#include <Eigen/Core>

namespace aneurysm::analytic
{

/// A wall and the state it started from.
struct Wall {
    double Y = 0;     ///< yield limit [Pa]
    double sigma = 0; ///< Poisson's ratio
    double phi = 0;   ///< porosity
    double R_0 = 0;   ///< [m]
    double h_0 = 0;   ///< [m]
    double P_0 = 0;   ///< pressure at R_0 [Pa]

    double modulus() const { return 2 * Y * (2 - sigma) / (3 * phi); } ///< E [Pa]
};

/// Eq. (8)  Stress of a sphere cut in half: the resultant of the pressure, integrated over the half sphere by
/// quadrature, over the cut's area [Pa].
Estimate cut_sphere_stress(double P, double R, double h);

/// Eq. (9)  h(R) = h_0 (R/R_0)^-sigma [m]; relative error 8 u.
double thickness(const Wall& wall, double R);

/// Eq. (9)  dh/dR of that power law, by the complex step (no difference is taken) [1]; relative error 16 u.
double thickness_slope(const Wall& wall, double R);

/// Eq. (10)  -d ln V/dR of the wall's volume V = 4 pi R^2 h(R),
/// by the complex step [1/m]; error 16 u (2 + sigma)/R.
double porosity_slope(const Wall& wall, double R);

/// Eq. (11)  2/3 Y int_phi^1 dx/x, by quadrature [Pa].
Estimate porous_stress(double Y, double phi);

/// Eq. (12) solved: P(R) = (R_0/R)^(1 + sigma) [ P_0 + 2 E h_0/R_0 ln(R/R_0) ] [Pa]; error 32 u times the sum
/// of both terms' magnitudes.
double pressure(const Wall& wall, double R);

/// Eq. (12)  dP/dR of that closed form by the complex step [Pa/m]; its inverse is dR/dP. Error 64 u times the
/// sum of the two terms that cancel at the critical radius, (E/R + P (1 + sigma)/(2 h)) 2 h/R.
double pressure_slope(const Wall& wall, double R);

/// Eq. (12)  P(R) by integrating dP/dR from R_0 through the critical radius (P-form).
Estimate pressure_by_integration(const Wall& wall, double R);

/// Eq. (12)  The stable radius at P (< P_c) by integrating dR/dP from P_0 (R-form). Its error is given in P,
/// as that of the pressure that belongs to the radius: R itself becomes infinitely sensitive at P_c.
Estimate radius_by_integration(const Wall& wall, double P);

/// Eq. (12) inverted for P_0 = 0: R = R_0 exp( -W(-x)/(1 + sigma) ), x = (1 + sigma) P R_0/(2 E h_0), with
/// Lambert's W_0 (stable) or W_-1 (unstable) [m].
Estimate radius_by_lambert(const Wall& wall, double P, bool stable);

/// Eq. (13)  Where P(R) has its maximum: R_c = R_0 exp( 1/(1 + sigma) - P_0 R_0/(2 E h_0) ) [m]; relative
/// error 16 u.
double critical_radius(const Wall& wall);

/// Eq. (13)  The maximum: P_c = 2 E h_0/(R_0 (1 + sigma)) exp( -1 + (1 + sigma) P_0 R_0/(2 E h_0) ) [Pa];
/// relative error 32 u.
double largest_pressure(const Wall& wall);

/// Eq. (13)  The same maximum found by searching P(R) [Pa]; P is flat there, so only rounding remains.
Estimate largest_pressure_by_search(const Wall& wall);

/// Eq. (14)  The speed that a half-sine pulse of the given mean force
/// leaves a mass with after dt, by quadrature [m/s].
Estimate speed_after_pulse(double mean_force, double m, double dt);

/// Eq. (16)  The largest Euclidean norm among columns [N]; relative error 4 u.
double largest_norm(const Eigen::Matrix3Xd& columns);

} // namespace aneurysm::analytic
