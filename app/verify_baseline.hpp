// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/verify_options.hpp"

namespace aneurysm::app
{

/// `aneurysm verify --baseline`: recomputes what is recorded in data/ with every backend that is here, and
/// says of each run whether it is identical; `--record` writes data/ anew.
/// \return 0 when all are identical, or recorded; 3 when not, 130 when interrupted
/// \throws InputError before anything is computed or written
int verify_baseline(const VerifyOptions& options);

} // namespace aneurysm::app
