// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of the paper that can be tested on an instance: the producer's own version of docs/lemma-claims.md section 4.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/lemmas/instance.h"

namespace confidel {

class Tally;

/// What was found on one instance.
struct LemmaResult {
  long objects = 0;
  long failures = 0;  ///< objects on which the statement does not hold
  /// Where it fails first, and where the slack is smallest: words joined by `-`, and the line in the certificate (0: unknown).
  struct Place {
    std::string object;
    int line = 0;
  };
  std::optional<Place> failure;
  struct Slack {
    double rounded = 0;
    std::optional<mpq_class> exact;  ///< absent where it is no rational number
    Place place;
  };
  std::optional<Slack> slack;  ///< absent: nothing to compare
};

struct Lemma {
  const char* id;
  const char* statement;
  const char* section;     ///< of the paper
  const char* hypothesis;  ///< what it is stated under; parameters by the names of lemma-claims.md
  const char* exact_form;
  bool needs_kinds;  ///< speaks of cells T, S, R, C: meaningless where Instance::wrong_kind >= 0
  /// How many objects the claim ranges over. Cheap; needs no positions of Steiner points.
  long (*count)(const Instance&);
  void (*evaluate)(const Instance&, Tally&);
};

/// In the order in which certificates claim them.
const std::vector<Lemma>& all_lemmas();

/// Throws std::out_of_range if there is none.
const Lemma& find_lemma(const std::string& id);

/// Thrown when a claim needs a parameter that the instance has not (the name, as in lemma-claims.md section 3).
class MissingParameter : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Thrown by evaluate when the cells are not of their kinds and the statement needs it.
class WrongKind : public std::runtime_error {
 public:
  explicit WrongKind(int cell) : std::runtime_error("a cell is not of its kind"), cell(cell) {}
  int cell;
};

/// Exact. Pre: the instance is well-formed as certificate-format.md section 5, rules `complex` to `box`, wants it.
LemmaResult evaluate(const Lemma& lemma, const Instance& instance);

}  // namespace confidel
