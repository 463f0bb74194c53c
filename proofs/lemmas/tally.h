// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what the test of one lemma finds.
#pragma once

#include <fmt/format.h>

#include <functional>

#include "proofs/lemmas/lemma.h"

namespace confidel {

class Tally {
 public:
  using Observer = std::function<void(double slack, int line)>;

  /// The observer is told every slack that is offered.
  explicit Tally(long objects, Observer observer = {}) : observer_(std::move(observer)) { result_.objects = objects; }

  /// One object on which the statement does not hold. To be called at most once for each.
  void fail(int line, std::string object) {
    if (result_.failures++ == 0) result_.failure = {std::move(object), line};
  }

  /// The first of the smallest is kept. The place is spelt only if it is needed: object is a function.
  template <class Object>
  void slack(const mpq_class& value, int line, Object object) {
    if (observer_) observer_(value.get_d(), line);
    if (result_.slack && (result_.slack->exact ? *result_.slack->exact <= value : result_.slack->rounded <= value.get_d())) return;
    result_.slack = LemmaResult::Slack{value.get_d(), value, {object(), line}};
  }
  template <class Object>
  void slack(double value, int line, Object object) {
    if (observer_) observer_(value, line);
    if (result_.slack && result_.slack->rounded <= value) return;
    result_.slack = LemmaResult::Slack{value, std::nullopt, {object(), line}};
  }

  /// The smallest slack so far, rounded; infinity if there is none.
  double smallest() const { return result_.slack ? result_.slack->rounded : std::numeric_limits<double>::infinity(); }

  LemmaResult result() && { return std::move(result_); }

 private:
  LemmaResult result_;
  Observer observer_;
};

/// The line of a record, 0 if it is not known.
inline int line_of(const std::vector<int>& lines, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < lines.size() ? lines[index] : 0;
}

inline std::string cell_name(int cell) { return fmt::format("cell-{}", cell); }
inline std::string cell_and_point(int cell, int point) { return fmt::format("cell-{}-point-{}", cell, point); }

}  // namespace confidel
