// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/verify.hpp"

namespace aneurysm::app
{

/// Hands over to the program `aneurysm-sensitivity`, which lies beside this one.
/// \throws InputError when it doesn't
[[noreturn]] void launch_sensitivity(const VerifyOptions& options);

} // namespace aneurysm::app
