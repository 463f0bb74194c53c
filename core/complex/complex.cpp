// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/complex.h"

#include <algorithm>

namespace confidel {

SegmentId Complex::find_segment(VertexId a, VertexId b) const {
  const Segment wanted{std::min(a, b), std::max(a, b)};
  const auto found = std::lower_bound(segments.begin(), segments.end(), wanted);
  if (found == segments.end() || *found != wanted) return -1;
  return static_cast<SegmentId>(found - segments.begin());
}

}  // namespace confidel
