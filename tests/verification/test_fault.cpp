// SPDX-License-Identifier: Apache-2.0
// The hook for planted faults in production code, where there is none: it is its own argument.
#include "common/fault.hpp"
#include "common/vec3.hpp"
#include "cuda/bifurcation.hpp"
#include "cuda/executor/lanes.hpp"
#include "reference/boundary.hpp"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <cmath>
#include <random>
#include <type_traits>

#ifdef ANEURYSM_FAULTS
#error "production code must not be compiled with ANEURYSM_FAULTS"
#endif

using namespace aneurysm;

namespace
{

const auto in_reference = [](auto value) { return reference::fault(eq22_radius, value); };
const auto in_device = [](auto value) { return device::fault(eq22_radius, value); };

template <class Hook, class... T>
constexpr bool keeps_types = (std::is_same_v<std::invoke_result_t<Hook, T>, T> && ...);
template <class Hook>
constexpr bool keeps_all_types =
    keeps_types<Hook, double, float, bool, int, Vec3, Vec3T<float>, device::Lanes<float>,
                device::Lanes<double>, Vec3T<device::Lanes<double>>>;
static_assert(keeps_all_types<decltype(in_reference)> && keeps_all_types<decltype(in_device)>);

// No global state: what is computed while compiling can't look at any.
static_assert(in_reference(0.4) == 0.4 && !in_device(false));
static_assert(reference::wall_velocity() == Vec3{} && device::daughter_radius(0) == 0);

template <class Hook>
void check_bits(Hook hook)
{
    std::mt19937_64 random(2439);
    for (int k = 0; k < 100'000; ++k) {
        const std::uint64_t bits = random(); // NaNs with their payload, infinities and denormals among them
        BOOST_REQUIRE_EQUAL(std::bit_cast<std::uint64_t>(hook(std::bit_cast<double>(bits))), bits);
        const auto half = static_cast<std::uint32_t>(bits);
        BOOST_REQUIRE_EQUAL(std::bit_cast<std::uint32_t>(hook(std::bit_cast<float>(half))), half);
    }
    BOOST_TEST(std::signbit(hook(-0.0)));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_hook_keeps_every_bit)
{
    check_bits(in_reference);
    check_bits(in_device);
}
