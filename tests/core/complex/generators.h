// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

namespace confidel::test {

/// rapidcheck grows ranges with the size of a case; degenerate configurations need all of a small range from the first
/// case on.
inline rc::Gen<int> whole_range(int low, int high) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

}  // namespace confidel::test
