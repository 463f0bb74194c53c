// SPDX-License-Identifier: GPL-3.0-or-later
// The global strategies of dimension 3: one radius, one offset, one spacing for the whole input, then Chew's refinement (paper section
// 3.2; theory.md section 3). They differ in their parameters only.
#pragma once

#include <optional>
#include <string>

#include "core/features/features.h"
#include "core/placement/buffer_zones.h"
#include "core/placement/placement.h"

namespace confidel {

/// The constants in working coordinates; r is a few-bit dyadic number, so that the claim is about the very radius that is used.
struct GlobalSizes {
  double radius = 0, offset = 0;
  double greatest_spacing = 0;  ///< h0, as far as it is known before arcs and rows are
  mpq_class angle_cosine;       ///< cos psi
};

/// How the constants follow from delta, phi and alpha. r <= delta/3; psi = phi'/K for a phi' just below phi; h0 is the smallest of
/// 2 r sin(chord psi), dihedral_share * d_f and, with fit, what the offsets, arcs and rows can be divided into; h = least_share * h0.
struct GlobalRule {
  std::string name;
  bool facet_angles = false;  ///< phi counts the angles of edges and facets, not only those of edges
  int angle_multiple = 12;    ///< K
  int beta = 0;               ///< d = r sin(beta psi); 0: d = 2 r sin(chord psi)
  int chord = 1;
  double dihedral_share = 1, least_share = 1;
  bool fit = false;
  std::vector<std::string> claims;  ///< of a complete placement, in the order of lemma-claims.md
  std::optional<GlobalSizes> sizes;  ///< instead of what follows from the features
  /// Refinement ends at circumradius (1 + eta) h, because circumcentres are rounded, by eta h/8 (theory.md section 5).
  double eta = 1.0 / 16;
  /// Rounding of offsets and of arcs, relative to h^2/r: far below theory.md's budget, 1/16, and below what the claims leave.
  double rounding = 0x1p-24;
  Spacing::Reaches reaches;
  bool fill = true;  ///< false: the buffer zones alone, without P''
};

/// theory.md section 3: beta = phi/3, h0 = min(2 r sin(phi/12), (2/3) d_f / (1 + 1/16)).
GlobalRule repaired_rule();

/// Section 3.2 as printed: d and h at their greatest, the chord of phi/2; angles between edges only. With beta_share c: beta = c phi.
/// Throws std::invalid_argument, with a text for the user, unless c is in (0, 1/2) and c and 1/4 have a common denominator up to 64.
GlobalRule paper_rule(const std::optional<mpq_class>& beta_share = {});

/// rule.sizes, if it has any.
GlobalSizes global_sizes(const Features& features, const GlobalRule& rule);

/// Buffer zones; exact tests of the protectors and of all T, S and R cells; then Chew's refinement of what is left. A cell or pair of
/// protectors that fails ends the run with a placement that refutes (Placement::refutation), before any facet is filled.
/// Deterministic for any number of threads. Throws LimitReached (the estimate comes first), StrategyFailed.
Placement place_global(const Complex& complex, const Features& features, const GlobalRule& rule, const Limits& limits, Progress& progress);

}  // namespace confidel
