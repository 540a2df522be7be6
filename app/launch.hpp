// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace aneurysm::app
{

/// Hands over to another program of ours, which lies beside this one.
/// `asked_by`: what on the command line asks for it; `needed`: what makes it, for the message
/// \throws InputError when it isn't there
[[noreturn]] void launch(const std::string& program, const std::vector<std::string>& arguments,
                         const std::string& asked_by, const std::string& needed);

} // namespace aneurysm::app
