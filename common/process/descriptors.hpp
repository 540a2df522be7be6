// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm
{

/// Gives standard input, output and error a place when the program was started with them closed; else the next file
/// that is opened gets their number, and with it what belongs there. What is written to them then still fails.
/// First thing in main().
void fill_standard_descriptors();

} // namespace aneurysm
