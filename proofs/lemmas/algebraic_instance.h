// SPDX-License-Identifier: GPL-3.0-or-later
// The global strategies of dimension 3 without rounding: the paper's points where it says that they are (arc points on the protecting
// sphere, equal intervals, feet and offsets at their distances), as real algebraic numbers, and the lemmas of lemma-claims.md on them.
// `confidel lemma --kernel algebraic FILE`. For small inputs: every doubtful sign costs a root bound.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/placement/global.h"
#include "proofs/lemmas/lemma.h"

namespace confidel {

/// A sign whose expression has more independent square roots than this (as powers of two) is not decided: AlgebraicLimit is thrown.
inline constexpr long greatest_algebraic_degree = 4096;

class AlgebraicLimit : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One lemma, on the exact points and on those of the rational strategy.
struct AlgebraicRow {
  std::string id;
  std::string skipped;  ///< why it has no meaning here; then the rest is empty
  LemmaResult exact;    ///< verdicts by exact signs; the slack is rounded
  long equalities = 0;  ///< objects on which the inequality is an equality (with nothing to spare), exactly
  std::optional<LemmaResult> rational;
};

/// What the paper says with "=": it holds exactly on so many objects; and by how much the rational strategy's points miss it, relatively.
struct AlgebraicEquality {
  std::string statement;
  long objects = 0, exact = 0;
  bool everywhere = true;  ///< the paper, or the strategy, wants it for all objects
  double rational = 0;     ///< the greatest relative deviation
};

struct AlgebraicReport {
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name, and what it is: exact, or the rational strategy's
  long points = 0, cells = 0;
  bool filled = false;    ///< P'' is filled; if not, lemmas on its inside are not tested
  std::string refutes;    ///< the statement that the strategy (rational) refutes on this input: then only its cells are tested
  std::vector<AlgebraicRow> lemmas;
  std::vector<AlgebraicEquality> equalities;
  long exact_signs = 0;   ///< signs that intervals could not decide

  bool holds() const;
};

/// Changes a point, for tests of the tests: by its number, the vector that is added.
using AlgebraicChanges = std::map<int, std::array<double, 3>>;

/// Pre: dimension 3; the rule is repaired_rule() or paper_rule(...). Deterministic. Throws LimitReached if the buffer zones alone have more
/// than limits.max_points points (points_reached says how many); P'' is left empty if it does not fit. Throws StrategyFailed, AlgebraicLimit.
AlgebraicReport check_algebraically(const Complex& complex, const GlobalRule& rule, const Limits& limits, Progress& progress, const AlgebraicChanges& changes = {});

}  // namespace confidel
