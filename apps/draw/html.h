// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates as one HTML file that shows them in space: no network, nothing to install.
#pragma once

#include <string>

#include "apps/draw/picture.h"

namespace confidel {

/// The page with its data, viewer and style. Any dimension; in dimension 2 all is in the plane z = 0.
std::string draw_html(const Picture& picture);

}  // namespace confidel
