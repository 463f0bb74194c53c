// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/clearance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace confidel {
namespace {

using Position = std::array<double, 3>;

/// to - from as an integer vector over a common denominator.
struct Offset {
  IntegerVector vector;
  mpz_class denominator;
};

Offset offset(const HomogeneousPoint& to, const HomogeneousPoint& from) {
  Offset result;
  if (to.denominator == from.denominator) {
    for (int axis = 0; axis < 3; ++axis) result.vector[axis] = to.numerator[axis] - from.numerator[axis];
    result.denominator = to.denominator;
  } else {
    for (int axis = 0; axis < 3; ++axis)
      result.vector[axis] = to.numerator[axis] * from.denominator - from.numerator[axis] * to.denominator;
    result.denominator = to.denominator * from.denominator;
  }
  return result;
}

mpz_class square(const IntegerVector& a) { return dot(a, a); }

double quotient(const mpz_class& numerator, const mpz_class& denominator) {
  HomogeneousPoint value;
  value.numerator[0] = numerator;
  value.denominator = denominator;
  return value.approximate(0);
}

/// A sphere through the corner a: centre = a + centre / scale, with scale > 0.
struct Sphere {
  const HomogeneousPoint* corner = nullptr;
  IntegerVector centre, normal;  ///< the normal is that of the corners' plane, of any length
  mpz_class scale, radius_square;  ///< R^2 = radius_square / scale^2
};

bool make_sphere(const Certificate& certificate, const CertificateCell& cell, Sphere& sphere) {
  const auto& points = certificate.points;
  const HomogeneousPoint& a = points[cell.corners[0]];
  Offset u = offset(points[cell.corners[1]], a), v = offset(points[cell.corners[2]], a);
  mpz_class denominator = lcm(u.denominator, v.denominator);
  for (Offset* side : {&u, &v}) {
    const mpz_class factor = denominator / side->denominator;
    for (auto& entry : side->vector) entry *= factor;
  }
  const IntegerVector n = cross(u.vector, v.vector);
  const mpz_class nn = square(n);
  if (nn == 0) return false;
  // Circumcentre - a = (|v|^2 (u x v) x u ... ) / (2 |n|^2), here over the sides' denominator.
  const IntegerVector nu = cross(n, u.vector), vn = cross(v.vector, n);
  const mpz_class uu = square(u.vector), vv = square(v.vector);
  sphere.corner = &a;
  sphere.normal = n;
  for (int axis = 0; axis < 3; ++axis) sphere.centre[axis] = vv * nu[axis] + uu * vn[axis];
  sphere.scale = 2 * denominator * nn;
  if (cell.offset != 0) {
    const CertificateFacet& facet = certificate.facets[cell.facet];
    const Offset p = offset(points[facet.frame[1]], points[facet.frame[0]]), q = offset(points[facet.frame[2]], points[facet.frame[0]]);
    const IntegerVector shift = cross(p.vector, q.vector);
    const mpz_class over = p.denominator * q.denominator * cell.offset.get_den();
    for (int axis = 0; axis < 3; ++axis) sphere.centre[axis] = sphere.centre[axis] * over + cell.offset.get_num() * shift[axis] * sphere.scale;
    sphere.scale *= over;
  }
  sphere.radius_square = square(sphere.centre);
  return true;
}

/// P(x)/R^2.
mpq_class relative_power(const Sphere& sphere, const HomogeneousPoint& point) {
  const Offset p = offset(point, *sphere.corner);
  mpq_class result(
      (square(p.vector) * sphere.scale - 2 * p.denominator * dot(p.vector, sphere.centre)) * sphere.scale,
      p.denominator * p.denominator * sphere.radius_square);
  result.canonicalize();
  return result;
}

bool in_plane(const Sphere& sphere, const HomogeneousPoint& point) { return dot(offset(point, *sphere.corner).vector, sphere.normal) == 0; }

bool in_facet_plane(const Certificate& certificate, int facet, int point) {
  const auto& frame = certificate.facets[facet].frame;
  const HomogeneousPoint& origin = certificate.points[frame[0]];
  const IntegerVector normal = cross(offset(certificate.points[frame[1]], origin).vector, offset(certificate.points[frame[2]], origin).vector);
  return dot(normal, offset(certificate.points[point], origin).vector) == 0;
}

/// A k-d tree over the doubles. A node knows if all its points are carried by one facet, and in its plane.
class Tree {
 public:
  Tree(const Certificate& certificate, const std::vector<Position>& positions) : certificate_(certificate), positions_(positions) {
    homes_.assign(positions.size(), mixed);
    for (std::size_t point = 0; point < positions.size(); ++point) homes_[point] = home(static_cast<int>(point));
    order_.resize(positions.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) build(0, static_cast<int>(order_.size()));
  }

  /// The smallest distance from the centre to a point that is accepted. Nodes within the facet are skipped (-1: none).
  template <class Accept>
  double distance(const Position& centre, int skipped_facet, const Accept& accept) const {
    double best = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) search(0, centre, skipped_facet, accept, best);
    return best;
  }

  template <class Accept, class Visit>
  void within(const Position& centre, double radius, int skipped_facet, const Accept& accept, const Visit& visit) const {
    if (!nodes_.empty()) collect(0, centre, radius, skipped_facet, accept, visit);
  }

 private:
  static constexpr int leaf_size = 8;
  static constexpr int mixed = -2;

  struct Node {
    Position low, high;
    int begin, end, right = -1, facet = mixed;
  };

  int build(int begin, int end) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.begin = begin;
    node.end = end;
    node.low = node.high = positions_[order_[begin]];
    node.facet = homes_[order_[begin]];
    for (int i = begin; i < end; ++i) {
      if (homes_[order_[i]] != node.facet) node.facet = mixed;
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis] = std::min(node.low[axis], positions_[order_[i]][axis]);
        node.high[axis] = std::max(node.high[axis], positions_[order_[i]][axis]);
      }
    }
    if (end - begin > leaf_size) {
      int axis = 0;
      for (int k = 1; k < 3; ++k)
        if (node.high[k] - node.low[k] > node.high[axis] - node.low[axis]) axis = k;
      const int middle = (begin + end) / 2;
      std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
        return positions_[a][axis] != positions_[b][axis] ? positions_[a][axis] < positions_[b][axis] : a < b;
      });
      build(begin, middle);
      node.right = build(middle, end);
    }
    nodes_[index] = node;
    return index;
  }

  /// The facet that carries the point, if it is in its plane indeed.
  int home(int point) const {
    const PointKind kind = certificate_.kinds[point];
    if (kind == PointKind::vertex || kind == PointKind::projection || kind == PointKind::edge) return mixed;
    return in_facet_plane(certificate_, certificate_.carriers[point], point) ? certificate_.carriers[point] : mixed;
  }

  static double gap(const Node& node, const Position& centre) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double outside = std::max({node.low[axis] - centre[axis], centre[axis] - node.high[axis], 0.0});
      sum += outside * outside;
    }
    return std::sqrt(sum);
  }

  double to(int point, const Position& centre) const {
    const Position& p = positions_[point];
    const double x = p[0] - centre[0], y = p[1] - centre[1], z = p[2] - centre[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  template <class Accept>
  void search(int index, const Position& centre, int skipped, const Accept& accept, double& best) const {
    const Node& node = nodes_[index];
    if (node.facet != mixed && node.facet == skipped) return;
    if (node.right < 0) {
      for (int i = node.begin; i < node.end; ++i) {
        const double d = to(order_[i], centre);
        if (d < best && accept(order_[i])) best = d;
      }
      return;
    }
    const double left = gap(nodes_[index + 1], centre), right = gap(nodes_[node.right], centre);
    const int near = left <= right ? index + 1 : node.right, far = left <= right ? node.right : index + 1;
    if (std::min(left, right) <= best) search(near, centre, skipped, accept, best);
    if (std::max(left, right) <= best) search(far, centre, skipped, accept, best);
  }

  template <class Accept, class Visit>
  void collect(int index, const Position& centre, double radius, int skipped, const Accept& accept, const Visit& visit) const {
    const Node& node = nodes_[index];
    if ((node.facet != mixed && node.facet == skipped) || gap(node, centre) > radius) return;
    if (node.right >= 0) {
      collect(index + 1, centre, radius, skipped, accept, visit);
      collect(node.right, centre, radius, skipped, accept, visit);
      return;
    }
    for (int i = node.begin; i < node.end; ++i)
      if (to(order_[i], centre) <= radius && accept(order_[i])) visit(order_[i]);
  }

  const Certificate& certificate_;
  const std::vector<Position>& positions_;
  std::vector<int> order_, homes_;
  std::vector<Node> nodes_;
};

class Measure {
 public:
  Measure(const Certificate& certificate, const std::vector<Position>& positions)
      : certificate_(certificate), positions_(positions), tree_(certificate, positions) {
    for (const Position& position : positions)
      for (double value : position) magnitude_ = std::max(magnitude_, std::abs(value));
    for (const CertificateCell& cell : certificate.cells)
      if (cell.box >= 0) boxes_.emplace_back(cell.box, &cell);
    std::stable_sort(boxes_.begin(), boxes_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  CellClearance operator()(const CertificateCell& cell) const {
    CellClearance result;
    Sphere sphere;
    if (!make_sphere(certificate_, cell, sphere)) {
      result.degenerate = true;
      return result;
    }
    for (int axis = 0; axis < 3; ++axis) {
      mpz_class numerator = sphere.corner->numerator[axis] * sphere.scale + sphere.centre[axis] * sphere.corner->denominator;
      result.centre[axis] = quotient(numerator, sphere.corner->denominator * sphere.scale);
    }
    result.radius = std::sqrt(quotient(sphere.radius_square, sphere.scale * sphere.scale));
    // Doubles cannot search a sphere whose square they cannot hold (an offset may be any number).
    if (!(result.radius < 1e150)) {
      result = CellClearance();
      result.degenerate = true;
      return result;
    }
    const int partner = fourth_corner(cell);
    const auto is_corner = [&](int point) { return std::find(cell.corners.begin(), cell.corners.end(), point) != cell.corners.end(); };
    const bool tied_box = partner >= 0 && !is_corner(partner) && relative_power(sphere, certificate_.points[partner]) == 0;
    result.all = nearest(sphere, result, -1, [&](int point) { return !is_corner(point) && !(tied_box && point == partner); });
    // What the facet carries is in the cell's plane only if the cell is in the facet's.
    const bool in_facet = std::all_of(cell.corners.begin(), cell.corners.end(), [&](int corner) { return in_facet_plane(certificate_, cell.facet, corner); });
    if (certificate_.dimension == 3)
      result.off_plane = nearest(sphere, result, in_facet ? cell.facet : -1,
                                 [&](int point) { return !is_corner(point) && !in_plane(sphere, certificate_.points[point]); });
    return result;
  }

 private:
  /// Power grows with the distance from the centre. Doubles find all points that can be the nearest; integers choose among them.
  template <class Accept>
  Nearest nearest(const Sphere& sphere, const CellClearance& at, int skipped, const Accept& accept) const {
    Nearest result;
    const double distance = tree_.distance(at.centre, skipped, accept);
    if (!std::isfinite(distance)) return result;
    double reach = magnitude_ + distance;
    for (double value : at.centre) reach = std::max(reach, std::abs(value));
    // Every rounding above is below 2^-50 of the largest number that occurs.
    tree_.within(at.centre, distance + 0x1p-46 * reach, skipped, accept, [&](int point) {
      mpq_class power = relative_power(sphere, certificate_.points[point]);
      const int order = result.point < 0 ? -1 : cmp(power, result.relative_power);
      if (order < 0 || (order == 0 && point < result.point)) {
        result.point = point;
        result.relative_power = std::move(power);
      }
    });
    return result;
  }

  int fourth_corner(const CertificateCell& cell) const {
    if (cell.box < 0) return -1;
    auto entry = std::lower_bound(boxes_.begin(), boxes_.end(), cell.box, [](const auto& box, int number) { return box.first < number; });
    for (; entry != boxes_.end() && entry->first == cell.box; ++entry)
      for (int corner : entry->second->corners)
        if (entry->second != &cell && std::find(cell.corners.begin(), cell.corners.end(), corner) == cell.corners.end()) return corner;
    return -1;
  }

  const Certificate& certificate_;
  const std::vector<Position>& positions_;
  Tree tree_;
  double magnitude_ = 0;
  std::vector<std::pair<int, const CertificateCell*>> boxes_;
};

}  // namespace

std::vector<std::array<double, 3>> approximate_positions(const Certificate& certificate) {
  std::vector<Position> result(certificate.points.size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) result[i][axis] = certificate.points[i].approximate(axis);
  });
  return result;
}

std::vector<CellClearance> clearances(const Certificate& certificate, const std::vector<Position>& positions,
                                      const std::function<bool()>& stop) {
  const Measure measure(certificate, positions);
  std::vector<CellClearance> result(certificate.cells.size());
  std::atomic<bool> stopped{false};
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    if (stopped.load(std::memory_order_relaxed)) return;
    if (i % 256 == 0 && stop && stop()) stopped = true;
    result[i] = measure(certificate.cells[i]);
  });
  return result;
}

}  // namespace confidel
