// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

namespace aneurysm
{

/// Any exception as one line of the form "where: what; advice", also those of the libraries below.
std::string text_of(const std::exception& error);

/// Whether what was asked for is at fault, rather than the machine or the program.
bool is_bad_input(const std::exception& error);

} // namespace aneurysm
