// SPDX-License-Identifier: Apache-2.0
// Boost.Test's main(), compiled once for all tests.
#define BOOST_TEST_MODULE aneurysm
#include <boost/test/unit_test.hpp>
