// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs written in the formats of docs/formats.md.
#pragma once

#include <string>
#include <vector>

#include "core/complex/input.h"

namespace confidel {

struct WrittenInput {
  std::string text;
  std::vector<std::string> lost;  ///< what the format cannot hold and is left out: markers, regions
};

/// The text of an input as .poly, .smesh, .off or .obj, chosen by the path's suffix. Numbers round-trip, vertices keep their order.
/// What would change the complex if it were left out (holes, several loops, segments outside facets) is an error instead.
/// Throws InputError (E-FORMAT).
WrittenInput written_input(const Input& input, const std::string& path);

}  // namespace confidel
