// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/report/document.hpp"

#include <string>

namespace aneurysm::report
{

/// All but pictures and plots, whose captions stand for them. What a table says in sentences follows it as a
/// list, so that its rows stay readable.
std::string markdown(const Document& document);

/// The same for a terminal: words without marks, and tables without their sentences.
std::string text(const Document& document);
std::string text(const Table& table);
std::string text(const Text& text);

} // namespace aneurysm::report
