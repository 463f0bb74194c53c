// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs of examples/ that the program carries with it (apps/CMakeLists.txt lists them).
#pragma once

#include <string>

namespace confidel {

/// The bytes of examples/NAME. Throws std::out_of_range if it is not carried.
const std::string& bundled_input(const std::string& name);

}  // namespace confidel
