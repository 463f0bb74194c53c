// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of the Triangle and TetGen family: a section of .poly and .smesh, or a .node file of its own.
#pragma once

#include "core/complex/input.h"
#include "core/io/source.h"
#include "core/io/text_parser.h"

namespace confidel::io {

/// Reads the node section, from the companion BASENAME.node if the section is empty.
/// Sets dimension, first_index, has_markers, vertices and vertex_file.
void read_nodes(const Source& source, TextParser& parser, int least_dimension, Input& input);

}  // namespace confidel::io
