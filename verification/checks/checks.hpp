// SPDX-License-Identifier: Apache-2.0
// The checks by subject; each function is in the file of its name.
#pragma once

#include "verification/check.hpp"

namespace aneurysm::verification
{

// L0
std::vector<Check> rupture_checks();

} // namespace aneurysm::verification
