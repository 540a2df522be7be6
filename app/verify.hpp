// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm verify`: runs the suite, prints a summary, writes report.html, .json, .md and junit.xml; or
/// compares with the baseline, or hands over to the study of sensitivity. Sets 0 when all that was run holds, 3
/// when not, 130 when interrupted.
void add_verify(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
