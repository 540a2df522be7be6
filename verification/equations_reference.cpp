// SPDX-License-Identifier: Apache-2.0
#include "reference/bifurcation.hpp"
#include "reference/kernel_function.hpp"
#include "reference/rupture.hpp"
#include "verification/equations.hpp"

namespace aneurysm::verification
{
namespace
{

class ReferenceEquations final : public Equations
{
public:
    double kernel_value(KernelName name, double h, double r) const override
    {
        return reference::Kernel(name, h).value(r);
    }
    Vec3 kernel_gradient(KernelName name, double h, const Vec3& x) const override
    {
        return reference::Kernel(name, h).gradient(x);
    }
    double viscosity_laplacian(double h, double r) const override
    {
        return reference::viscosity_laplacian(r, 2 * h);
    }
    double wall_stress(double P, double R, double h) const override
    {
        return reference::wall_stress(P, R, h);
    }
    double critical_pressure(double h, double R, double Y, double sigma, double phi) const override
    {
        return reference::critical_pressure(h, R, Y, sigma, phi);
    }
    double daughter_radius(double r_0) const override { return reference::daughter_radius(r_0); }
};

} // namespace

const Equations& reference_equations()
{
    static const ReferenceEquations equations;
    return equations;
}

} // namespace aneurysm::verification
