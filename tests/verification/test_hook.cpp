// SPDX-License-Identifier: Apache-2.0
// The hook for mutants, in a build that has it: each kind of mutant does what it says, in one place of
// one backend.
#include "cuda/executor/lanes.hpp"
#include "cuda/growth.hpp"
#include "reference/boundary.hpp"
#include "reference/growth.hpp"
#include "verification/sensitivity/hook.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <set>
#include <string>

using namespace aneurysm;
using namespace aneurysm::sensitivity;

namespace
{

/// Plants a mutant for its own lifetime.
class Plant
{
public:
    Plant(Place place, sensitivity::Kind kind, double size = 0, Side side = Side::reference)
    {
        planted = {place, side, kind, size};
    }
    ~Plant() { planted = {}; }
    Plant(const Plant&) = delete;
    Plant(Plant&&) = delete;
    Plant& operator=(const Plant&) = delete;
    Plant& operator=(Plant&&) = delete;
};

/// What a formula of the reference goes on with in place of x.
template <class T>
T with(Place place, sensitivity::Kind kind, double size, T x)
{
    const Plant plant(place, kind, size);
    return in_reference(place, x);
}

} // namespace

BOOST_AUTO_TEST_CASE(without_a_mutant_nothing_changes)
{
    BOOST_TEST(in_reference(eq22_radius, 0.4) == 0.4);
    const Plant elsewhere(eq22_thinning, sensitivity::Kind::coefficient, 0.5);
    BOOST_TEST(in_reference(eq22_radius, 0.4) == 0.4);
    const Plant other_side(eq22_radius, sensitivity::Kind::coefficient, 0.5, Side::device);
    BOOST_TEST(in_reference(eq22_radius, 0.4) == 0.4);
    BOOST_TEST(in_device(eq22_radius, 0.4) == 0.6, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_number_is_changed_as_its_kind_says)
{
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::coefficient, 0.25, 0.4) == 0.5);
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::coefficient, 0.25, -4.0F) == -5.0F);
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::sign, 0, 0.4) == -0.4);
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::power, 1, 3.0) == 9);
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::power, 1, -3.0F) == -9);
    BOOST_TEST(with(eq22_radius, sensitivity::Kind::dropped, 0, 0.4) == 1);     // a factor
    BOOST_TEST(with(eq22_thinning, sensitivity::Kind::dropped, 0, 0.4) == 0);   // a term
    BOOST_TEST(with(eq22_thinning, sensitivity::Kind::off_by_one, 0, 10) == 9); // a count
}

BOOST_AUTO_TEST_CASE(so_are_vectors_and_conditions)
{
    BOOST_TEST(
        (with(eq22_radius, sensitivity::Kind::coefficient, 0.25, Vec3{4, 8, -12}) == Vec3{5, 10, -15}));
    BOOST_TEST((with(eq22_radius, sensitivity::Kind::sign, 0, Vec3{1, 0, -2}) == Vec3{-1, 0, 2}));
    BOOST_TEST((with(eq14_velocity, sensitivity::Kind::power, 1, Vec3{1, 2, 3}) ==
                Vec3{3, 1, 2})); // the wrong index
    for (const bool holds : {false, true}) {
        BOOST_TEST(with(fig1_outwards, sensitivity::Kind::dropped, 0, holds)); // always
        BOOST_TEST(with(fig1_outwards, sensitivity::Kind::sign, 0, holds) == !holds);
    }
}

BOOST_AUTO_TEST_CASE(off_by_one_is_the_value_before)
{
    const Plant plant(eq22_thinning, sensitivity::Kind::off_by_one);
    BOOST_TEST(in_reference(eq22_thinning, 1.0) == 1); // the first has none before
    BOOST_TEST(in_reference(eq22_thinning, 2.0) == 1);
    BOOST_TEST(in_reference(eq22_thinning, 3.0) == 2);
    BOOST_TEST((in_reference(eq22_thinning, Vec3{1, 2, 3}) == Vec3{1, 2, 3}));
    BOOST_TEST((in_reference(eq22_thinning, Vec3{4, 5, 6}) == Vec3{1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(off_by_one_of_lanes_is_the_neighbor_before)
{
    const Plant plant(eq22_thinning, sensitivity::Kind::off_by_one, 0, Side::device);
    using Lanes = device::Lanes<double>;
    in_device(eq22_thinning, Lanes(device::Eight<double>{1, 2, 3, 4, 5, 6, 7, 8}));
    const Lanes next = in_device(eq22_thinning, Lanes(device::Eight<double>{9, 10, 11, 12, 13, 14, 15, 16}));
    for (int l = 0; l < device::lane_count; ++l) {
        BOOST_TEST(next.v[l] == 8 + l);
    }
}

BOOST_AUTO_TEST_CASE(lanes_and_vectors_of_them)
{
    const Plant plant(eq22_thinning, sensitivity::Kind::coefficient, 0.25, Side::device);
    using Lanes = device::Lanes<float>;
    const auto v = in_device(eq22_thinning, Vec3T<Lanes>{Lanes(4), Lanes(8), Lanes(12)});
    BOOST_TEST(v.x.v[7] == 5);
    BOOST_TEST(v.y.v[0] == 10);
    BOOST_TEST(v.z.v[3] == 15);
}

BOOST_AUTO_TEST_CASE(a_wall_that_ought_to_stand_still_moves)
{
    const Plant plant(eq27_velocity, sensitivity::Kind::coefficient, 0.25);
    BOOST_TEST((reference::wall_velocity() == Vec3{0.25, 0.25, 0.25}));
}

BOOST_AUTO_TEST_CASE(one_backend_at_a_time)
{
    const double right = reference::thickness_growing(0.1, 0.4, 0.5, 0.001);
    const Plant plant(eq22_thinning, sensitivity::Kind::sign, 0, Side::device);
    BOOST_TEST(reference::thickness_growing(0.1, 0.4, 0.5, 0.001) == right);
    BOOST_TEST(device::thickness_growing(0.1, 0.4, 0.5, 0.001) > 0.1);
}

BOOST_AUTO_TEST_CASE(what_is_computed_is_noticed)
{
    BOOST_TEST(!visited[0][eq23_cap]);
    reference::thickness_developed(0.1, 1.1, 0.001, 0.01);
    BOOST_TEST(visited[0][eq23_cap]);
    BOOST_TEST(!visited[1][eq23_cap]);
}

BOOST_AUTO_TEST_CASE(places_have_names_of_their_own)
{
    std::set<std::string_view> names;
    for (const PlaceInfo& place : places) {
        BOOST_TEST(names.insert(place.name).second, place.name);
        BOOST_TEST(!place.text.empty());
    }
    BOOST_TEST(places[eq22_radius].name == "eq22_radius");
    BOOST_CHECK(places[fig1_outwards].part == Part::condition);
}
