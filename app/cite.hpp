// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace aneurysm::app
{

/// What to paste to cite this program: a sentence, BibTeX, and the recorded runs with their digests.
/// \throws InputError when data/baseline.json isn't there or isn't as it was written
std::string citation();

} // namespace aneurysm::app
