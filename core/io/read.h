// SPDX-License-Identifier: GPL-3.0-or-later
// Readers, chosen by the file's suffix; grammars and traps: docs/formats.md.
#pragma once

#include <string>

#include "core/complex/input.h"

namespace confidel {

/// Reads .poly (2D and 3D, with companion .node), .smesh, .off, .obj, .edg, .stl, .ply, medit .mesh.
/// A number is its nearest double. Nothing is repaired; what a reader did beyond reading stands in Input::remarks.
/// Throws InputError with file:line:column (E-FORMAT, E-SYNTAX, E-FIELDS, E-NUMBER, E-VALUE, E-COUNT, E-INDEX,
/// E-TRUNCATED, E-TRAILING, E-EMPTY), FileError if the file or its companion cannot be read.
Input read_input(const std::string& path);

/// The same for a text that is at hand; the name's suffix says the format.
Input read_input_text(const std::string& name, const std::string& text);

}  // namespace confidel
