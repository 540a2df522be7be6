// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm::output
{

/// The text of output/show_in_paraview.py, which each run directory has a copy of.
const char* paraview_script();

} // namespace aneurysm::output
