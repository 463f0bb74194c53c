// SPDX-License-Identifier: GPL-3.0-or-later
// Exact signs about the points of an instance: intervals first, algebraic numbers where they do not decide. For one translation unit:
// algebraic_instance.cpp.
#pragma once

#include "proofs/lemmas/algebraic_points.h"
#include "proofs/lemmas/space.h"

namespace confidel::algebraic {

/// The sign is exact, the value rounded.
struct Signed {
  int sign = 0;
  double value = 0;
};

class Kernel {
 public:
  /// A constant with the dimension of a length.
  struct Length {
    Number squared;
    Bounded bounded;
  };
  /// How statements read the instance: f(reader) is the same formula for both kinds of numbers.
  struct Filter {
    const Kernel& kernel;
    BoundedVector between(int to, int from) const { return kernel.difference(to, from); }
    Bounded squared(const Length& l) const { return l.bounded * l.bounded; }
    Bounded number(double x) const { return {x, 0}; }
  };
  struct Exact {
    const Kernel& kernel;
    Vector between(int to, int from) const { return minus(kernel.exact_[to], kernel.exact_[from]); }
    const Number& squared(const Length& l) const { return l.squared; }
    Number number(double x) const { return Number(x); }
  };

  /// The instance's positions become approximations of the exact ones.
  Kernel(Instance& instance, const std::vector<Vector>& exact) : instance_(instance), exact_(exact), space_(approximated(instance, exact)) {}

  const Instance& instance() const { return instance_; }
  const Space& space() const { return space_; }
  long exact_signs() const { return exact_signs_; }
  /// The square may be known in fewer roots.
  Length length(const Number& exact, const Number& squared) const {
    const double value = exact.doubleValue() * space_.scaled(1).value;
    return {squared, {value, std::abs(value) * 0x1p-50}};
  }

  template <class Formula>
  Signed evaluate(Formula formula) const {
    const Bounded bounded = formula(Filter{*this});
    if (std::abs(bounded.value) > bounded.error) return {bounded.value > 0 ? 1 : -1, bounded.value};
    const Number exact = formula(Exact{*this});
    const int sign = decided(exact);
    return {sign, sign == 0 ? 0 : exact.doubleValue()};
  }
  int decided(const Number& x) const {
    ++exact_signs_;
    return exact_sign(x);
  }

  BoundedVector difference(int to, int from) const {
    BoundedVector result = space_.difference(to, from);
    for (Bounded& coordinate : result) coordinate.error += 0x1p-130;
    return result;
  }

  bool in_plane(int point, FacetId facet) const {
    if (point < instance_.vertex_count) return instance_.in_plane(point, facet);
    const int carrier = instance_.carriers[point];
    if (instance_.on_segment_kind(point)) {
      const auto& [a, b] = instance_.segments[carrier];
      if (instance_.in_plane(a, facet) && instance_.in_plane(b, facet)) return true;
    } else if (instance_.coplanar(carrier, facet)) {
      return true;
    }
    const auto& [i, j, k] = instance_.facets[facet].frame;
    return evaluate([&, i = i, j = j, k = k](const auto& g) { return dot(cross(g.between(j, i), g.between(k, i)), g.between(point, i)); }).sign == 0;
  }

 private:
  static const Instance& approximated(Instance& instance, const std::vector<Vector>& exact) {
    double size = 0;
    for (const RationalVector& position : instance.positions)
      for (const mpq_class& value : position) size = std::max(size, std::abs(value.get_d()));
    // 2^-150 of the greatest coordinate: difference() allows for 2^-130.
    const long bits = 150 - (size > 0 ? std::ilogb(size) : 0);
    for (std::size_t id = instance.vertex_count; id < exact.size(); ++id)
      for (int axis = 0; axis < 3; ++axis) instance.positions[id][axis] = approximation(exact[id][axis], bits);
    return instance;
  }

  const Instance& instance_;
  const std::vector<Vector>& exact_;
  Space space_;
  mutable long exact_signs_ = 0;
};

/// The smallest sphere through three points.
class CellSphere {
 public:
  CellSphere(const Kernel& kernel, const std::array<int, 3>& corners) : kernel_(kernel), corners_(corners) {
    const BoundedVector u = kernel.difference(corners[1], corners[0]), w = kernel.difference(corners[2], corners[0]), n = cross(u, w);
    twice_centre_ = times(Bounded{1, 0} / dot(n, n), plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u))));
    squared_radius_ = Bounded{0.25, 0} * dot(twice_centre_, twice_centre_);
  }

  bool has(int id) const { return corners_[0] == id || corners_[1] == id || corners_[2] == id; }
  /// P(x)/R^2.
  Signed power(int id) const {
    const BoundedVector x = kernel_.difference(id, corners_[0]);
    const Bounded bounded = dot(x, minus(x, twice_centre_)) / squared_radius_;
    if (std::abs(bounded.value) > bounded.error) return {bounded.value > 0 ? 1 : -1, bounded.value};
    const Kernel::Exact g{kernel_};
    const Vector u = g.between(corners_[1], corners_[0]), w = g.between(corners_[2], corners_[0]), n = cross(u, w), y = g.between(id, corners_[0]);
    const Vector centre = plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u)));
    const int sign = kernel_.decided(dot(n, n) * dot(y, y) - dot(y, centre));
    return {sign, sign == 0 ? 0 : std::copysign(std::max(std::abs(bounded.value), 1e-300), sign)};
  }
  /// 4 R^2 by any reader.
  template <class Reader>
  auto four_squared_radius(const Reader& g) const {
    const auto u = g.between(corners_[1], corners_[0]), w = g.between(corners_[2], corners_[0]), n = cross(u, w), v = minus(w, u);
    return dot(u, u) * dot(w, w) * dot(v, v) / dot(n, n);
  }
  /// Calls visit(id) for all points of the index with P(x) <= reach R^2 but the corners, and perhaps for more.
  template <class Visit>
  void visit(const PointIndex& index, double reach, Visit visit) const {
    const Ball ball = enclosing_ball(kernel_.space().approximate(corners_[0]), twice_centre_, squared_radius_, reach);
    index.visit_ball(ball.centre, ball.radius, [&](int id) {
      if (!has(id)) visit(id);
      return false;
    });
  }

 private:
  const Kernel& kernel_;
  std::array<int, 3> corners_;
  BoundedVector twice_centre_;
  Bounded squared_radius_;
};

/// What is found about one statement.
class Count {
 public:
  void begin() { worst_ = 1; }
  template <class Name>
  void offer(const Signed& slack, Name name) {
    if (slack.sign < worst_) {
      worst_ = slack.sign;
      if (slack.sign < 0) where_ = name();
    }
    if (!result.slack || slack.value < result.slack->rounded) result.slack = LemmaResult::Slack{slack.value, std::nullopt, {name(), 0}};
  }
  /// A condition without a slack.
  template <class Name>
  void require(bool good, Name name) {
    if (good || worst_ < 0) return;
    worst_ = -1;
    where_ = name();
  }
  void touch() { worst_ = std::min(worst_, 0); }
  void end() {
    if (worst_ < 0 && result.failures++ == 0) result.failure = {where_, 0};
    if (worst_ == 0) ++equalities;
  }
  double smallest() const { return result.slack ? std::max(0.0, result.slack->rounded) : 1e300; }

  LemmaResult result;
  long equalities = 0;

 private:
  int worst_ = 1;
  std::string where_;
};

}  // namespace confidel::algebraic
