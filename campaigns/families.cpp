// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/families.h"

#include <fmt/format.h>

#include <stdexcept>

#include "campaigns/instance.h"

namespace confidel::campaigns {

namespace {

/// Neighbouring seeds and families must not share their sequences' beginnings.
std::uint64_t mixed(std::uint64_t seed, const std::string& name) {
  std::uint64_t value = 0xcbf29ce484222325U;
  for (const char c : name) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  value ^= seed + 0x9e3779b97f4a7c15U + (value << 6) + (value >> 2);
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
  return value ^ (value >> 31);
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> result;
    for (const auto& part : {triangle_families(), polygon_families(), planar_families(), derived_families()})
      result.insert(result.end(), part.begin(), part.end());
    return result;
  }();
  return all;
}

const Family* find_family(const std::string& name) {
  for (const Family& family : families())
    if (name == family.name) return &family;
  return nullptr;
}

const Family& family_for(const std::string& name, std::uint64_t seed) {
  return name == "all" ? families()[seed % families().size()] : *find_family(name);
}

Input generate(const Family& family, std::uint64_t seed) {
  constexpr int proposals = 1000;
  Random random(mixed(seed, family.name));
  for (int i = 0; i < proposals; ++i) {
    Input input = without_unused_vertices(family.propose(random));
    input.file = fmt::format("{}-{}", family.name, seed);
    if (is_valid(input) == family.valid) return input;
  }
  throw std::logic_error(fmt::format("family {}, seed {}: {} proposals in a row are refused", family.name, seed, proposals));
}

}  // namespace confidel::campaigns
