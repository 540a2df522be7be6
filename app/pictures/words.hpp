// SPDX-License-Identifier: Apache-2.0
// Words of the command line that both subcommands take.
#pragma once

#include "common/scenario/scenario.hpp"
#include "output/pictures/camera.hpp"
#include "output/pictures/coloring.hpp"

#include <string>
#include <utility>

namespace aneurysm::app
{

/// \throws InputError, with what is allowed; all of these
pictures::View view_of(const std::string& word);
pictures::Quantity quantity_of(const std::string& word);
/// WIDTHxHEIGHT [pixels]; both even, as videos need them
std::pair<int, int> size_of(const std::string& word);
/// `where`: what has the scenario, for the message
void require_artery(const std::string& where, const Scenario& scenario);

} // namespace aneurysm::app
