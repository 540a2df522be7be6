// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm::app
{

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_differs = 3; ///< something is not within its bounds
inline constexpr int exit_interrupted = 130;

} // namespace aneurysm::app
