// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm reproduce`: runs what the items need, and writes data, pictures and reproduction.html. Runs that
/// are there already are used again. Sets 0, or 130 when it was interrupted.
void add_reproduce(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
