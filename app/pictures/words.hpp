// SPDX-License-Identifier: Apache-2.0
// What both subcommands take from the command line.
#pragma once

#include "common/scenario/scenario.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace aneurysm::app
{

/// Of a picture [pixels]; both even, as videos need them.
struct Size {
    int width = 0;
    int height = 0;
};

/// --size WIDTHxHEIGHT
CLI::Option* add_size(CLI::App& app, std::optional<Size>& size, const std::string& help);

/// \param where  what has the scenario, for the message
/// \throws InputError
void require_artery(const std::string& where, const Scenario& scenario);

} // namespace aneurysm::app
