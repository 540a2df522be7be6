// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm render`: draws frames of runs to PNG files, prints where they are. Sets 0, or 130 when
/// interrupted; throws InputError before anything is written, or at a bad particle file.
void add_render(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
