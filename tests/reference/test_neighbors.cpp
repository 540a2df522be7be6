// SPDX-License-Identifier: Apache-2.0
// The reference's cell grid against all pairs.
#include "common/error.hpp"
#include "reference/neighbors.hpp"
#include "tests/support.hpp"

#include <random>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;
using reference::Bodies;
using reference::Role;

namespace
{

const reference::Kernel kernel(KernelName::cubic_spline, 0.5); // support 1

/// x of the nearest image.
double image(double x, double period)
{
    return period > 0 ? x - period * std::round(x / period) : x;
}

std::vector<std::size_t> all_pairs(const Bodies& b, const reference::Period& period, std::size_t i)
{
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < b.size(); ++j) {
        const Vec3 d = b.position[i] - b.position[j];
        const Vec3 x{image(d.x, period.x), image(d.y, period.y), image(d.z, period.z)};
        if (b.role[j] != Role::absent && length(x) < kernel.support()) {
            found.push_back(j);
        }
    }
    return found;
}

/// Whether the lists of `neighbors` are those of all pairs, ascending, and empty for bodies that aren't free.
bool equal_all_pairs(const reference::Neighbors& neighbors, const Bodies& b, const reference::Period& period)
{
    for (std::size_t i = 0; i < b.size(); ++i) {
        std::vector<std::size_t> found;
        for (const reference::Neighbor& n : neighbors.of(i)) {
            found.push_back(n.j);
        }
        if (found != (b.free(i) ? all_pairs(b, period, i) : std::vector<std::size_t>{})) {
            return false;
        }
    }
    return true;
}

/// Bodies in a box; every fifth a ghost, every seventh absent.
Bodies cloud(std::uint64_t seed, std::size_t count, const Vec3& box)
{
    std::mt19937_64 bits(seed);
    const auto random = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -53); };
    Bodies b;
    for (std::size_t i = 0; i < count; ++i) {
        b.position.push_back({box.x * random(), box.y * random(), box.z * random()});
        b.role.push_back(i % 7 == 3 ? Role::absent : i % 5 == 1 ? Role::mirror : Role::free);
    }
    b.velocity.resize(count);
    b.mass.assign(count, 1);
    return b;
}

} // namespace

BOOST_AUTO_TEST_CASE(neighbors_of_clouds_are_those_of_all_pairs)
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Vec3 box{3.5 + 0.1 * static_cast<double>(seed % 10), 3 - 0.1 * static_cast<double>(seed % 11),
                       4.7};
        const Bodies b = cloud(seed, 200, box);
        for (const reference::Period& period : {Vec3{}, box, Vec3{box.x, 0, 0}}) {
            BOOST_TEST(equal_all_pairs({b, kernel, period}, b, period));
        }
    }
}

BOOST_AUTO_TEST_CASE(neighbors_on_cell_borders_and_at_the_support_are_those_of_all_pairs)
{
    // a lattice of half the support: bodies on every border, pairs exactly 2 h apart
    Bodies b = cloud(1, 512, {1, 1, 1});
    std::size_t n = 0;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            for (int k = 0; k < 8; ++k) {
                b.position[n++] = {0.5 * i, 0.5 * j, 0.5 * k};
            }
        }
    }
    for (const reference::Period& period : {Vec3{}, Vec3{4, 4, 4}}) {
        BOOST_TEST(equal_all_pairs({b, kernel, period}, b, period));
    }
}

BOOST_AUTO_TEST_CASE(neighbors_check_sees_a_smaller_support_and_a_missing_seam)
{
    const Vec3 box{3.5, 3, 4.7};
    const Bodies b = cloud(7, 200, box);

    BOOST_TEST(!equal_all_pairs({b, {KernelName::cubic_spline, 0.499}, box}, b, box));
    BOOST_TEST(!equal_all_pairs({b, kernel, {box.x, box.y, 0}}, b, box));
}

BOOST_AUTO_TEST_CASE(neighbors_refuse_a_box_below_two_supports)
{
    const Bodies b = cloud(7, 20, {1.9, 3, 3});

    BOOST_CHECK_THROW(reference::Neighbors(b, kernel, {1.9, 3, 3}), Error);
}

BOOST_AUTO_TEST_CASE(neighbors_of_no_bodies_are_none)
{
    const Bodies none;

    BOOST_CHECK_NO_THROW(reference::Neighbors(none, kernel));
}

BOOST_AUTO_TEST_CASE(neighbors_carry_the_kernels_of_their_own_pair)
{
    const Vec3 box{3.5, 3, 4.7};
    const Bodies b = cloud(11, 200, box);
    for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        const reference::Kernel W(name, 0.5);
        const reference::Neighbors neighbors(b, W, box);
        // the same operations on the same numbers, so the same bits
        const auto holds = [&](auto pair) {
            for (std::size_t i = 0; i < b.size(); ++i) {
                for (const reference::Neighbor& n : neighbors.of(i)) {
                    const Vec3 d = b.position[i] - b.position[n.j];
                    const Vec3 x{image(d.x, box.x), image(d.y, box.y), image(d.z, box.z)};
                    const reference::Neighbor found = pair(n);
                    if (found.W != W.value(length(x)) || found.grad_W != W.gradient(x) ||
                        found.lap_W != reference::viscosity_laplacian(length(x), W.support())) {
                        return false;
                    }
                }
            }
            return true;
        };
        BOOST_TEST(holds([](const reference::Neighbor& n) { return n; }));
        BOOST_TEST(!holds([](const reference::Neighbor& n) { // of j instead of i
            return reference::Neighbor{n.j, n.W, -n.grad_W, n.lap_W};
        }));
        BOOST_TEST(!holds([](const reference::Neighbor& n) {
            return reference::Neighbor{n.j, n.W * (1 + 1e-15), n.grad_W, n.lap_W};
        }));
    }
}

BOOST_AUTO_TEST_CASE(neighbors_are_the_same_for_bodies_that_left_the_periodic_box)
{
    const Vec3 box{3.5, 3, 4.5};
    Bodies b = cloud(13, 200, box);
    for (std::size_t i = 0; i < b.size(); ++i) {
        const double boxes = static_cast<double>(i % 5) - 2;
        b.position[i] += Vec3{boxes * box.x, -boxes * box.y, boxes * box.z};
    }
    BOOST_TEST(equal_all_pairs({b, kernel, box}, b, box));
    BOOST_TEST(!equal_all_pairs({b, kernel, {box.x, box.y, 0}}, b, box));
}
