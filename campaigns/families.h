// SPDX-License-Identifier: GPL-3.0-or-later
// Families of inputs, each a pure function of one 64-bit seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaigns/random.h"
#include "core/complex/input.h"

namespace confidel::campaigns {

struct Family {
  const char* name;
  int dimension;
  bool valid;  ///< false: makes inputs that the exact validity test must refuse
  const char* about;
  /// A proposal; generate() draws again until one is as valid as the family says.
  Input (*propose)(Random&);
};

/// All families; `all` picks by their order.
const std::vector<Family>& families();

/// Null if there is none of that name.
const Family* find_family(const std::string& name);

/// `all`: the family is chosen by the seed. Pre: the name is "all" or a family's.
const Family& family_for(const std::string& name, std::uint64_t seed);

/// The family's member for this seed. Small: tens of entities at most. Throws std::logic_error if 1000 proposals in a row are refused.
Input generate(const Family& family, std::uint64_t seed);

// The parts of the list, one file each.
std::vector<Family> triangle_families();
std::vector<Family> polygon_families();
std::vector<Family> planar_families();
std::vector<Family> derived_families();

}  // namespace confidel::campaigns
