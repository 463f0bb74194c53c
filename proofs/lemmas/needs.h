// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that a statement asks for.
#pragma once

#include <algorithm>

#include "proofs/lemmas/lemma.h"

namespace confidel {

inline const mpq_class& need(const std::optional<mpq_class>& parameter, const char* name) {
  if (!parameter) throw MissingParameter(name);
  return *parameter;
}

struct NeededAngle {
  int multiple;
  const mpq_class& cosine;
};
inline NeededAngle need_angle(const Instance& instance) {
  if (instance.parameters.angle_multiple == 0) throw MissingParameter("angle");
  return {instance.parameters.angle_multiple, instance.parameters.angle_cosine};
}

inline const mpq_class& need_ball(const Instance& instance, VertexId vertex) {
  const auto& balls = instance.parameters.balls;
  const auto place = std::lower_bound(balls.begin(), balls.end(), vertex, [](const auto& ball, VertexId v) { return ball.vertex < v; });
  if (place == balls.end() || place->vertex != vertex) throw MissingParameter("ball");
  return place->radius;
}

inline const Parameters::Row& need_row(const Instance& instance, SegmentId segment) {
  const auto& rows = instance.parameters.rows;
  const auto place = std::lower_bound(rows.begin(), rows.end(), segment, [](const auto& row, SegmentId s) { return row.segment < s; });
  if (place == rows.end() || place->segment != segment) throw MissingParameter("row");
  return *place;
}

}  // namespace confidel
