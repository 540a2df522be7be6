// SPDX-License-Identifier: Apache-2.0
// What a terminal shows of a report.
#pragma once

#include "output/report/document.hpp"

#include <string>

namespace aneurysm::report
{

/// The words alone.
std::string text(const Text& text);
/// Columns under one another.
std::string text(const Table& table);
/// All but contents, plots and pictures.
std::string text(const Document& document);

} // namespace aneurysm::report
