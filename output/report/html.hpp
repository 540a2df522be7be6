// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/report/document.hpp"

#include <string>

namespace aneurysm::report
{

/// One page that needs nothing else: styles, plots and pictures are in it.
std::string html(const Document& document);

} // namespace aneurysm::report
