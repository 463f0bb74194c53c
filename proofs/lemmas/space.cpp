// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/space.h"

#include <algorithm>

#include "proofs/lemmas/rational_geometry.h"

namespace confidel {
Space::Space(const Instance& instance) : instance_(instance) {
  long greatest = -1000000;
  for (const RationalVector& position : instance.positions)
    for (const mpq_class& value : position) {
      if (value == 0) continue;
      greatest = std::max(greatest, static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2)) + 1);
    }
  scale_ = greatest == -1000000 ? 0 : static_cast<int>(-greatest);
  for (const RationalVector& position : instance.positions) {
    auto& high = high_.emplace_back();
    auto& low = low_.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class value = times_power_of_two(position[axis], scale_);
      high[axis] = value.get_d();
      low[axis] = mpq_class(value - high[axis]).get_d();
    }
  }
}

BoundedVector Space::difference(int to, int from) const {
  BoundedVector result;
  for (int axis = 0; axis < 3; ++axis) {
    const double h = high_[to][axis], g = high_[from][axis];
    result[axis] = (Bounded{h, 0} - Bounded{g, 0}) + (Bounded{low_[to][axis], 0} - Bounded{low_[from][axis], 0});
    // Both approximations truncate: what is left of either is below 2^-103 of it.
    result[axis].error += (std::abs(h) + std::abs(g)) * 0x1p-102;
  }
  return result;
}

Bounded Space::scaled(const mpq_class& length) const { return rounded(times_power_of_two(length, scale_).get_d(), 0); }

PointIndex Space::empty_index() const {
  PointIndex::Position low{1, 1, 1}, high{-1, -1, -1};
  for (const auto& position : high_)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], position[axis]);
      high[axis] = std::max(high[axis], position[axis]);
    }
  return PointIndex(low, high);
}

PointIndex Space::index(const std::function<bool(int)>& accepted) const {
  PointIndex result = empty_index();
  for (std::size_t id = 0; id < high_.size(); ++id)
    if (accepted(static_cast<int>(id))) result.insert(static_cast<int>(id), high_[id]);
  return result;
}

Sphere::Sphere(const Space& space, int cell)
    : space_(space), instance_(space.instance()), corners_(instance_.cells[cell].corners), facet_(instance_.cells[cell].facet), offset_(instance_.cells[cell].offset.value()) {
  const BoundedVector u = space.difference(corners_[1], corners_[0]), w = space.difference(corners_[2], corners_[0]), n = cross(u, w);
  twice_centre_ = times(Bounded{1, 0} / dot(n, n), plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u))));
  if (offset_ != 0) {
    BoundedVector shift;
    for (int axis = 0; axis < 3; ++axis) shift[axis] = space.scaled(2 * offset_ * instance_.normal(facet_)[axis]);
    twice_centre_ = plus(twice_centre_, shift);
  }
  squared_radius_ = Bounded{0.25, 0} * dot(twice_centre_, twice_centre_);
}

void Sphere::make_exact() const {
  if (exact_) return;
  exact_ = true;
  const auto& p = instance_.positions;
  const RationalVector u = minus(p[corners_[1]], p[corners_[0]]), w = minus(p[corners_[2]], p[corners_[0]]), n = cross(u, w);
  exact_twice_centre_ = times(1 / squared(n), plus(times(squared(u), cross(w, n)), times(squared(w), cross(n, u))));
  if (offset_ != 0) exact_twice_centre_ = plus(exact_twice_centre_, times(2 * offset_, instance_.normal(facet_)));
  exact_squared_radius_ = squared(exact_twice_centre_) / 4;
}

const mpq_class& Sphere::squared_radius() const {
  make_exact();
  return exact_squared_radius_;
}

mpq_class Sphere::power(int point) const {
  make_exact();
  const RationalVector x = minus(instance_.positions[point], instance_.positions[corners_[0]]);
  return dot(x, minus(x, exact_twice_centre_));
}

int Sphere::sign(int point, double enough, bool& clear) const {
  const BoundedVector x = space_.difference(point, corners_[0]);
  const Bounded power = dot(x, minus(x, twice_centre_));
  clear = power.lower() > 0 && (power / squared_radius_).lower() > enough;
  if (clear || power.lower() > 0) return 1;
  if (power.upper() < 0) return -1;
  return sgn(this->power(point));
}

Ball enclosing_ball(const PointIndex::Position& corner, const BoundedVector& twice_centre, const Bounded& squared_radius, double reach) {
  Ball ball{corner, std::sqrt(squared_radius.upper()) * std::sqrt(1 + reach)};
  double error = Space::position_error;
  for (int axis = 0; axis < 3; ++axis) {
    ball.centre[axis] += twice_centre[axis].value / 2;
    error += twice_centre[axis].error;
  }
  ball.radius = ball.radius * (1 + 0x1p-40) + 2 * error;
  if (!(ball.radius < 1e10)) ball = {{0, 0, 0}, 1e10};  // everything
  return ball;
}

void Sphere::visit(const PointIndex& index, double reach, const std::function<void(int)>& visit) const {
  const Ball ball = enclosing_ball(space_.approximate(corners_[0]), twice_centre_, squared_radius_, reach);
  index.visit_ball(ball.centre, ball.radius, [&](int id) {
    if (id != corners_[0] && id != corners_[1] && id != corners_[2]) visit(id);
    return false;
  });
}

}  // namespace confidel
