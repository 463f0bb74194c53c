// SPDX-License-Identifier: GPL-3.0-or-later
// From an input as it stands in a file to a valid complex, exactly; or the list of what is wrong with it.
#pragma once

#include <string>
#include <vector>

#include "core/complex/complex.h"
#include "core/complex/input.h"

namespace confidel {

struct BuildOptions {
  /// Bit-identical vertices are one vertex (.stl and soups after an explicit request); otherwise they are an error.
  bool merge_identical_vertices = false;
  /// Merge exactly coplanar neighbours into one facet (merge.h): automatic means triangle soups only.
  enum class Merging { automatic, on, off };
  Merging merge_coplanar = Merging::automatic;
};

/// What was done to the input on the way that its author may want to know.
struct BuildReport {
  /// Input segments that were split because vertices lie exactly on them: (first, second, vertex).
  struct SplitSegment {
    VertexId first, second, on_it;
  };
  std::vector<SplitSegment> split_segments;
  std::vector<std::string> remarks;
  /// For every vertex of the complex, the index in Input::vertices of the (first) one with its position.
  std::vector<int> input_index;
  int artificial_segments = 0;  ///< dimension 2: convex-hull edges that were added
};

struct BuiltComplex {
  Complex complex;
  BuildReport report;
};

/// Exact validity and the canonical form. Throws InputError with every violation found: codes
/// E-DUPLICATE-VERTEX, E-INDEX, E-DEGENERATE-FACET, E-NONCOPLANAR, E-CROSSING, E-OVERLAP, E-OPEN-LOOP, E-HOLE, E-EMPTY.
BuiltComplex build_complex(const Input& input, const BuildOptions& options = {});

}  // namespace confidel
