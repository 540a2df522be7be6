// SPDX-License-Identifier: Apache-2.0
// The arithmetic contract: what the compiler must not do with our arithmetic. Every function here is kept
// from being inlined, so that it is compiled as the libraries are.
#include "tests/support.hpp"

#include <cfloat>
#include <limits>

using namespace aneurysm;
using namespace aneurysm::test;

static_assert(FLT_EVAL_METHOD == 0, "no excess precision");
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<float>::is_iec559);

namespace
{

[[gnu::noinline]] Vec3 through_float(const Vec3& a)
{
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

[[gnu::noinline]] Vec3 from_float_to_double(const Vec3T<float>& a)
{
    return {a.x, a.y, a.z};
}

[[gnu::noinline]] Vec3 lost_by_float(const Vec3& a)
{
    const Vec3T<float> narrow{static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
    return a - Vec3{narrow.x, narrow.y, narrow.z};
}

[[gnu::noinline]] double multiply_and_subtract(double a, double b, double c)
{
    return a * b - c;
}

[[gnu::noinline]] double add_and_take_away(double a, double b)
{
    return (a + b) - a;
}

[[gnu::noinline]] double half(double a)
{
    return a / 2;
}

} // namespace

// g++ 12 at -O2 takes pairs of struct members through float without rounding them (its SLP vectorizer).
BOOST_AUTO_TEST_CASE(rounding_the_compiler_rounds_struct_members)
{
    volatile double third = 1.0 / 3;
    const Vec3 a{third, 2 * third, 5 * third}; // none is a float
    const auto holds = [&](auto round) {
        const Vec3 b = round(a);
        return b.x == double{float(third)} && b.y == double{float(2 * third)} &&
               b.z == double{float(5 * third)} && b.x != a.x && b.y != a.y && b.z != a.z;
    };
    BOOST_TEST(holds(through_float));
    BOOST_TEST(holds([](const Vec3& v) { return v - lost_by_float(v); })); // exact: a float is left
    BOOST_TEST(holds([](const Vec3& v) {
        return from_float_to_double(
            {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    }));
    BOOST_TEST(!holds([](const Vec3& v) { return v; }));
}

BOOST_AUTO_TEST_CASE(rounding_products_are_not_contracted)
{
    volatile double x = 1 + 0x1p-30; // or the compiler computes the product itself
    const auto holds = [&](auto f) { return f(x, x, 1 + 0x1p-29) == 0; }; // fused, the 2^-60 of x^2 survives
    BOOST_TEST(holds(multiply_and_subtract));
    BOOST_TEST(!holds([](double a, double b, double c) { return std::fma(a, b, -c); }));
}

BOOST_AUTO_TEST_CASE(rounding_sums_are_not_reordered)
{
    volatile double large = 0x1p53;
    const auto holds = [&](auto f) { return f(large, 1) == 0; };
    BOOST_TEST(holds(add_and_take_away));
    BOOST_TEST(!holds([](double, double b) { return b; }));
}

BOOST_AUTO_TEST_CASE(rounding_subnormal_numbers_are_kept)
{
    volatile double smallest = std::numeric_limits<double>::min();
    const auto holds = [&](auto f) { return f(smallest) > 0 && f(smallest) + f(smallest) == smallest; };
    BOOST_TEST(holds(half));
    BOOST_TEST(!holds([](double) { return 0.0; }));
}
