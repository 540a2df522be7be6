// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/report/document.hpp"

#include <string>

namespace aneurysm::report
{

/// All but pictures, whose captions stand for them. What a table says in sentences follows it as a list, so
/// that its rows stay readable.
std::string markdown(const Document& document);

} // namespace aneurysm::report
