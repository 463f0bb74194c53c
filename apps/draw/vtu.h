// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates for ParaView, PyVista and meshio: VTK's XML format for unstructured grids.
#pragma once

#include <string>

#include "apps/draw/picture.h"

namespace confidel {

/// Triangles for cells and lines for the subsegments of hanging segments, with arrays per point (kind, carrier) and per cell (kind, facet, line, box,
/// slack, nearest point, radius, slack of claimed lemmas). Inline base64, UInt64 header, Int64 connectivity and offsets: what VTK and meshio both read.
std::string draw_vtu(const Picture& picture);

/// Standard base64 with padding.
std::string base64(const void* bytes, std::size_t size);

}  // namespace confidel
