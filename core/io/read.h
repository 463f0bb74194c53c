// SPDX-License-Identifier: GPL-3.0-or-later
// Readers, chosen by the file's suffix; grammars and traps: docs/formats.md.
#pragma once

#include <string>

#include "core/complex/input.h"

namespace confidel {

/// Reads .poly (2D and 3D, with companion .node), .smesh, .off, .obj, .edg. A number is its nearest double.
/// Throws InputError (E-SYNTAX, E-FIELDS, E-NUMBER, E-INDEX, E-TRUNCATED, E-FORMAT, ...) with file:line:column, FileError if unreadable.
Input read_input(const std::string& path);

}  // namespace confidel
