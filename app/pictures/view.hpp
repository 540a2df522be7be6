// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm view`: simulates a scenario and shows it in a window until that is closed. Sets 0, or 1 when the
/// simulation failed; throws InputError, also when there is no display.
void add_view(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
