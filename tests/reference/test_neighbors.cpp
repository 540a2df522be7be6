// SPDX-License-Identifier: Apache-2.0
// The reference's cell grid against all pairs, at borders that a box of blood seldom has. That each particle feels
// those within its support, by the kernels of its own pairs, eq05_neighbors, eq05_cloud and pictures check.
#include "reference/neighbors.hpp"
#include "tests/vessels.hpp"

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

/// Whether the lists of `neighbors` are those of all pairs, ascending, and empty for bodies that aren't blood.
bool equal_all_pairs(const reference::Neighbors& neighbors, const Bodies& b, const reference::Period& period)
{
    for (std::size_t i = 0; i < b.size(); ++i) {
        std::vector<std::size_t> found;
        for (const reference::Neighbor& n : neighbors.of(i)) {
            found.push_back(n.j);
        }
        if (found != (b.blood(i) ? all_pairs(b, period, i) : std::vector<std::size_t>{})) {
            return false;
        }
    }
    return true;
}

/// Bodies in a box; every fifth a ghost, every seventh absent, every eleventh driven.
Bodies cloud(std::uint64_t seed, std::size_t count, const Vec3& box)
{
    Random random(seed);
    Bodies b;
    for (std::size_t i = 0; i < count; ++i) {
        b.position.push_back(random.point(1) + Vec3{1, 1, 1});
        Vec3& x = b.position.back();
        x = {0.5 * box.x * x.x, 0.5 * box.y * x.y, 0.5 * box.z * x.z};
        const Role blood = i % 11 == 5 ? Role::driven : Role::free;
        b.role.push_back(i % 7 == 3 ? Role::absent : i % 5 == 1 ? Role::mirror : blood);
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
