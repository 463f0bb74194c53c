// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/numbers/angle.h"
#include "core/placement/global.h"

namespace confidel {
namespace {

// Bits of r: few, and a loss that nobody feels.
constexpr int radius_bits = 32;
// Room for the rounding of offsets and feet (BufferSizes): beta stays below beta psi.
constexpr double below = 1 - 0x1p-20;
constexpr int greatest_multiple = 64;  // lemma-claims.md section 1

}  // namespace

GlobalRule repaired_rule() {
  GlobalRule rule;
  rule.name = "repaired";
  rule.facet_angles = true;
  rule.beta = 4;
  rule.chord = 1;
  rule.dihedral_share = 2.0 / 3 / (1 + 1.0 / 16);
  rule.least_share = 1 - 1.0 / 64;
  rule.claims = {"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L2", "L3", "L4", "L5", "L6", "L7", "L8", "L9", "L10", "L11", "L12",
                 "L13", "L14", "L15", "L16", "L17", "L18", "L18b", "L19", "L21", "L22", "L23"};
  return rule;
}

GlobalRule paper_rule(const std::optional<mpq_class>& beta_share) {
  GlobalRule rule;
  rule.name = "paper";
  rule.chord = 3;
  rule.least_share = 1 - 0x1p-20;
  rule.fit = true;
  rule.claims = {"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L2", "L18", "L18b", "L19", "L21", "L22"};
  if (!beta_share) return rule;
  const mpq_class& share = *beta_share;
  if (share <= 0 || 2 * share >= 1) throw std::invalid_argument("beta must be between 0 and 1/2 of phi");
  if (share.get_den() > greatest_multiple) throw std::invalid_argument("the denominator of beta must be small: write 1/3, 1/4, 1/6 or the like");
  const long denominator = std::lcm(4L, share.get_den().get_si());
  if (denominator > greatest_multiple) throw std::invalid_argument("beta and 1/4 must have a common denominator of at most 64");
  rule.angle_multiple = static_cast<int>(12 % denominator == 0 ? 12 : denominator);
  rule.beta = static_cast<int>(mpz_class(share.get_num() * rule.angle_multiple / share.get_den()).get_si());
  rule.chord = rule.angle_multiple / 4;
  return rule;
}

GlobalSizes global_sizes(const Features& features, const GlobalRule& rule) {
  if (rule.sizes) return *rule.sizes;
  double phi = std::numbers::pi / 4, alpha = std::numbers::pi;
  for (const auto* angles : {&features.segment_angle, &features.facet_angle}) {
    if (angles == &features.facet_angle && !rule.facet_angles) continue;
    for (const auto& ends : *angles) phi = std::min({phi, ends[0], ends[1]});
  }
  for (double angle : features.dihedral_angle) alpha = std::min(alpha, angle);
  GlobalSizes sizes;
  sizes.radius = rounded_down(std::min(features.separation, 8.0) / 3 * (1 - 0x1p-40), radius_bits).get_d();
  sizes.angle_cosine = witness_of_angle(phi / rule.angle_multiple * (1 - 0x1p-40));
  const double psi = 2 * std::asin(std::sqrt(mpq_class((1 - sizes.angle_cosine) / 2).get_d()));
  const double chord = 2 * sizes.radius * std::sin(rule.chord * psi * below);
  sizes.offset = rule.beta > 0 ? sizes.radius * std::sin(rule.beta * psi * below) : chord;
  sizes.greatest_spacing = std::min(chord, rule.dihedral_share * 2 * sizes.offset * std::sin(alpha / 2));
  if (rule.fit) sizes.greatest_spacing = std::min(sizes.greatest_spacing, sizes.offset);
  return sizes;
}

}  // namespace confidel
