// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/inexact.hpp"

#include "common/error.hpp"

namespace aneurysm::bounds
{

double unit_roundoff(const std::string& precision)
{
    if (precision == "float") {
        return 0x1p-24;
    }
    if (precision == "double") {
        return 0x1p-53;
    }
    throw InputError("--precision", "unknown (" + precision + ")", "allowed: float, double");
}

} // namespace aneurysm::bounds
