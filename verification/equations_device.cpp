// SPDX-License-Identifier: Apache-2.0
#include "cuda/bifurcation.hpp"
#include "cuda/kernel_function.hpp"
#include "cuda/rupture.hpp"
#include "verification/equations.hpp"

namespace aneurysm::verification
{
namespace
{

class DeviceEquations final : public Equations
{
public:
    double kernel_value(KernelName name, double h, double r) const override
    {
        return first(device::Kernel<double>(name, h).value(device::Lanes<double>(r)));
    }
    Vec3 kernel_gradient(KernelName name, double h, const Vec3& x) const override
    {
        const device::Lanes<double> r(length(x));
        return first(device::Kernel<double>(name, h).gradient_factor(r)) * x;
    }
    double viscosity_laplacian(double h, double r) const override
    {
        const device::Kernel<double> W(KernelName::cubic_spline, h);
        return first(W.viscosity_laplacian(device::Lanes<double>(r)));
    }
    double wall_stress(double P, double R, double h) const override { return device::wall_stress(P, R, h); }
    double critical_pressure(double h, double R, double Y, double sigma, double phi) const override
    {
        return device::critical_pressure(h, R, Y, sigma, phi);
    }
    double daughter_radius(double r_0) const override { return device::daughter_radius(r_0); }
};

} // namespace

const Equations& device_equations()
{
    static const DeviceEquations equations;
    return equations;
}

} // namespace aneurysm::verification
