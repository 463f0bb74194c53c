// SPDX-License-Identifier: GPL-3.0-or-later
// The lean strategy's loop: what to do about a piece or a triangle that nothing supports.
#pragma once

#include <vector>

#include "core/placement/lean_protection.h"
#include "core/placement/lean_state.h"

namespace confidel {

class LeanRefinement {
 public:
  LeanRefinement(LeanState& state, LeanProtection& protection);

  /// Until every piece and every triangle is supported.
  void run();

 private:
  using Triangle = LeanState::Triangle;

  void split_missing();
  void split(int a, int b, FacetId facet = -1);
  void repair(FacetId facet, const Triangle& triangle, LeanState::State state);
  bool protect_near(FacetId facet, const Point& centre, double radius);
  bool used_up(int& events);

  LeanState& state_;
  LeanProtection& protection_;
  const Complex& complex_;
  double greatest_guard_ = 0;
  std::vector<int> at_vertex_, at_segment_;  ///< how often refinement came closer than graded's size, before protection
};

}  // namespace confidel
