// SPDX-License-Identifier: GPL-3.0-or-later
// Planar certificates as SVG with layers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/draw/picture.h"

namespace confidel {

struct SvgOptions {
  std::vector<std::string> layers;              ///< shown at first; empty: the usual ones
  std::optional<std::array<double, 4>> window;  ///< xmin, ymin, xmax, ymax in the input's coordinates: the part that is drawn
  std::size_t most_elements = 50'000;
  bool panel = true;    ///< the legend with its switches
  bool in_full = false; ///< exact numbers however long they are
};

/// The names that SvgOptions::layers may have, in the order of the legend.
const std::vector<std::string>& svg_layers();

struct SvgResult {
  std::string text;
  std::vector<std::string> remarks;  ///< what was left out, and why
};

/// Pre: dimension 2. Layers with more than most_elements objects in all are drawn without tooltips, one path each; above 20 times as many the
/// picture is refused with an InputError (E-TOO-LARGE).
SvgResult draw_svg(const Picture& picture, const SvgOptions& options);

/// Text for XML.
std::string escaped(const std::string& text);

}  // namespace confidel
