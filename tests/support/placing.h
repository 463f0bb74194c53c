// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies for tests, without limits and without a word.
#pragma once

#include "core/features/features.h"
#include "core/placement/graded.h"
#include "core/placement/lean.h"

namespace confidel::test {

class SilentProgress : public Progress {
 public:
  void at(const char*, long) override {}
  bool stop_requested(long) override { return false; }
  void estimated(double points) override { estimate = points; }
  double estimate = 0;
};

enum class Strategy { graded, lean };
inline const char* name_of(Strategy strategy) { return strategy == Strategy::graded ? "graded" : "lean"; }

/// Throws LimitReached when more points are needed; 0: no limit.
inline Placement place(const Complex& complex, Strategy strategy, long max_points = 0, int threads = 1) {
  SilentProgress progress;
  const Limits limits{max_points, threads};
  const Features features = compute_features(complex);
  return strategy == Strategy::graded ? place_graded(complex, features, limits, progress) : place_lean(complex, features, limits, progress);
}

}  // namespace confidel::test
