// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/verify.hpp"

namespace aneurysm::verification
{

/// Hands over to the program `aneurysm-sensitivity`, which lies beside this one.
/// \throws InputError when it doesn't
[[noreturn]] void launch_sensitivity(const VerifyOptions& options);

} // namespace aneurysm::verification
