// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario.hpp"
#include "common/vec3.hpp"

#include <span>

namespace aneurysm::verification
{

/// The scalar equations as one backend computes them, so that a check is written once for all. Arguments and
/// units are those of the functions of the same names in reference/.
class Equations
{
public:
    Equations() = default;
    virtual ~Equations() = default;
    Equations(const Equations&) = delete;
    Equations(Equations&&) = delete;
    Equations& operator=(const Equations&) = delete;
    Equations& operator=(Equations&&) = delete;

    // (4)
    virtual double kernel_value(KernelName name, double h, double r) const = 0;
    virtual Vec3 kernel_gradient(KernelName name, double h, const Vec3& x) const = 0;
    virtual double viscosity_laplacian(double h, double r) const = 0;
    // section 3.2
    virtual double wall_stress(double P, double R, double h) const = 0;
    virtual double critical_pressure(double h, double R, double Y, double sigma, double phi) const = 0;
    // section 3.4
    virtual double daughter_radius(double r_0) const = 0;
};

/// In double; both backends' scalar equations are double in either precision.
const Equations& reference_equations();
const Equations& device_equations();

} // namespace aneurysm::verification
