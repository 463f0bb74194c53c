// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/conforming_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/numbers/predicates.h"
#include "core/tetrahedra/delaunay.h"

namespace confidel {
namespace {

/// A tetrahedron, or a triangle with the last corner -1; and its sides, sorted, -1 last.
using Element = std::array<int, 4>;
using Side = std::array<int, 3>;

Side sorted_side(Side side) {
  std::sort(side.begin(), side.end(), [](int a, int b) { return static_cast<unsigned>(a) < static_cast<unsigned>(b); });
  return side;
}

std::vector<Side> sides_of(const Element& e) {
  if (e[3] < 0) return {sorted_side({e[0], e[1], -1}), sorted_side({e[1], e[2], -1}), sorted_side({e[2], e[0], -1})};
  return {sorted_side({e[1], e[2], e[3]}), sorted_side({e[0], e[2], e[3]}), sorted_side({e[0], e[1], e[3]}), sorted_side({e[0], e[1], e[2]})};
}

class Maker {
 public:
  Maker(const Complex& complex, const Input& input, const Placement& placement) : complex_(complex), input_(input), placement_(placement) {}

  ConformingMesh run(Keep keep, bool exact) {
    Mesh& mesh = result_.mesh;
    mesh.dimension = complex_.dimension;
    mesh.first_index = input_.first_index;
    make_chains();
    make_elements();
    if (volume_) find_faces();
    find_barriers();
    connect();
    std::vector<char> kept(elements_.size(), 1);
    if (keep == Keep::regions) kept = inside();
    mark_regions();
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (kept[i] == 0) continue;
      const Element& e = elements_[i];
      if (volume_) {
        mesh.tetrahedra.push_back(e);
        if (!input_.regions.empty()) mesh.tetrahedron_labels.push_back(attribute_[i]);
      } else if (complex_.dimension == 2) {
        mesh.faces.push_back({e[0], e[1], e[2]});
        if (!input_.regions.empty()) mesh.face_labels.push_back(static_cast<int>(attribute_[i]));
      }
    }
    if (!elements_.empty() && std::count(kept.begin(), kept.end(), 1) == 0)
      result_.remarks.push_back("the facets enclose nothing: no elements are left (--keep hull keeps all)");
    if (complex_.dimension == 3 && !volume_) {
      for (const PlacedCell& cell : placement_.cells) add_face({cell.corners[0], cell.corners[1], cell.corners[2]}, cell.facet);
      result_.remarks.push_back("all points lie in one plane: there are no tetrahedra");
    }
    for (const auto& [face, facet] : faces_) add_face(face, facet);
    for (std::size_t s = 0; s < chains_.size(); ++s)
      for (std::size_t i = 0; i + 1 < chains_[s].size(); ++i) {
        mesh.edges.push_back({chains_[s][i], chains_[s][i + 1]});
        mesh.edge_labels.push_back(input_.has_markers ? complex_.segment_markers[s] : static_cast<int>(s) + 1);
      }
    round(exact);
    return std::move(result_);
  }

 private:
  const Point& point(int id) const { return placement_.points[id].position; }

  void add_face(const std::array<int, 3>& face, FacetId facet) {
    result_.mesh.faces.push_back(face);
    result_.mesh.face_labels.push_back(input_.has_markers ? complex_.facets[facet].marker : facet + 1);
  }

  /// Points along each segment, ends included; and the facets of each point.
  void make_chains() {
    chains_.resize(complex_.segments.size());
    facets_of_.resize(placement_.points.size());
    std::vector<std::vector<FacetId>> of_segment(complex_.segments.size());
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
      const Facet& facet = complex_.facets[f];
      for (const auto* edges : {&facet.boundary, &facet.constraints})
        for (const auto& [a, b] : *edges) {
          of_segment[complex_.find_segment(a, b)].push_back(static_cast<FacetId>(f));
          for (const int vertex : {a, b}) facets_of_[vertex].push_back(static_cast<FacetId>(f));
        }
      for (const int vertex : facet.isolated) facets_of_[vertex].push_back(static_cast<FacetId>(f));
    }
    for (std::size_t id = complex_.vertices.size(); id < placement_.points.size(); ++id) {
      const PlacedPoint& placed = placement_.points[id];
      if (placed.kind == PointKind::projection || placed.kind == PointKind::edge) {
        chains_[placed.carrier].push_back(static_cast<int>(id));
        facets_of_[id] = of_segment[placed.carrier];
      } else {
        facets_of_[id].push_back(placed.carrier);
      }
    }
    for (auto& facets : facets_of_) {
      std::sort(facets.begin(), facets.end());
      facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    }
    for (std::size_t s = 0; s < chains_.size(); ++s) {
      const auto [a, b] = complex_.segments[s];
      chains_[s].push_back(a);
      chains_[s].push_back(b);
      const bool forward = point(a) < point(b);  // on a line, lexicographic order is order along it
      std::sort(chains_[s].begin(), chains_[s].end(), [&](int i, int j) { return forward ? point(i) < point(j) : point(j) < point(i); });
    }
  }

  void make_elements() {
    if (complex_.dimension == 3) {
      DelaunayTetrahedralization delaunay;
      for (int id = 0; id < static_cast<int>(placement_.points.size()); ++id) delaunay.insert(id, point(id), id - 1);
      volume_ = delaunay.dimension() == 3;
      if (volume_) elements_ = delaunay.tetrahedra();
    } else {
      for (const PlacedCell& cell : placement_.cells) elements_.push_back({cell.corners[0], cell.corners[1], cell.corners[2], -1});
    }
  }

  /// The facet that a face of the tetrahedralization lies on, or -1.
  FacetId facet_of(const Side& face) const {
    for (const FacetId f : facets_of_[face[0]]) {
      const auto has = [&](int id) { return std::binary_search(facets_of_[id].begin(), facets_of_[id].end(), f); };
      if (has(face[1]) && has(face[2]) && contains(f, face)) return f;
    }
    return -1;
  }

  /// A face in the plane of a facet lies in it or outside, as the tetrahedralization conforms: a point inside of the face tells.
  bool contains(FacetId f, const Side& face) const {
    const auto doubled = [](const Point& a, const Point& b) {
      const int e = std::max(a.exponent(), b.exponent());
      IntegerVector sum;
      for (int axis = 0; axis < 3; ++axis) sum[axis] = (a.numerator(axis) << (e - a.exponent())) + (b.numerator(axis) << (e - b.exponent()));
      return Point(sum[0], sum[1], sum[2], e + 1);
    };
    const Point inner = doubled(doubled(point(face[0]), point(face[1])), point(face[2]));
    const Projection projection = projection_of(complex_.facets[f].normal);
    for (const auto& corners : complex_.facets[f].triangles) {
      bool inside = true;
      for (int i = 0; i < 3 && inside; ++i) inside = planar_orientation(projection, point(corners[i]), point(corners[(i + 1) % 3]), inner) >= 0;
      if (inside) return true;
    }
    return false;
  }

  void find_faces() {
    for (const Element& element : elements_)
      for (const Side& side : sides_of(element))
        if (faces_.count(side) == 0)
          if (const FacetId facet = facet_of(side); facet >= 0) faces_.emplace(side, facet);
  }

  void find_barriers() {
    if (volume_) {
      for (const auto& [face, facet] : faces_) barriers_.push_back(face);
    } else if (complex_.dimension == 2) {
      // Edges of the convex hull that were added are no barriers: the input does not have them.
      for (std::size_t s = 0; s < chains_.size(); ++s)
        if (is_stated(static_cast<SegmentId>(s)))
          for (std::size_t i = 0; i + 1 < chains_[s].size(); ++i) barriers_.push_back(sorted_side({chains_[s][i], chains_[s][i + 1], -1}));
    }
    std::sort(barriers_.begin(), barriers_.end());
  }

  /// Does the segment lie on one of the input? Input segments were split at vertices: collinear and between.
  bool is_stated(SegmentId s) const {
    const Point a = complex_.input_position(complex_.segments[s][0]), b = complex_.input_position(complex_.segments[s][1]);
    for (const InputSegment& segment : input_.segments) {
      const auto at = [&](int end) {
        const auto& [x, y, z] = input_.vertices[segment.ends[end]].position;
        return Point::from_doubles(x, y, z);
      };
      const Point p = at(0), q = at(1);
      const auto on = [&](const Point& x) { return x == p || x == q || (!(p == q) && collinear(p, q, x) && strictly_between(p, q, x)); };
      if (on(a) && on(b)) return true;
    }
    return false;
  }

  /// Neighbours across sides that are no barriers; -1: the outside.
  void connect() {
    std::vector<std::pair<Side, int>> sides;
    for (std::size_t i = 0; i < elements_.size(); ++i)
      for (const Side& side : sides_of(elements_[i])) sides.emplace_back(side, static_cast<int>(i));
    std::sort(sides.begin(), sides.end());
    neighbours_.resize(elements_.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (std::binary_search(barriers_.begin(), barriers_.end(), sides[i].first)) continue;
      if (i + 1 < sides.size() && sides[i].first == sides[i + 1].first) {
        neighbours_[sides[i].second].push_back(sides[i + 1].second);
        neighbours_[sides[i + 1].second].push_back(sides[i].second);
        ++i;
      } else {
        at_outside_.push_back(sides[i].second);
      }
    }
  }

  std::vector<int> flood(std::vector<int> front) const {
    std::vector<char> reached(elements_.size(), 0);
    std::vector<int> result;
    while (!front.empty()) {
      const int element = front.back();
      front.pop_back();
      if (reached[element] != 0) continue;
      reached[element] = 1;
      result.push_back(element);
      front.insert(front.end(), neighbours_[element].begin(), neighbours_[element].end());
    }
    return result;
  }

  /// The elements that hold a seed. On a barrier it would belong to both sides.
  std::vector<int> at_seed(const std::array<double, 3>& seed, const char* what) const {
    const Point p = Point::from_doubles(seed[0], seed[1], seed[2]).scaled(-complex_.scale);
    std::vector<int> result;
    for (std::size_t i = 0; i < elements_.size(); ++i)
      if (holds(elements_[i], p)) result.push_back(static_cast<int>(i));
    if (result.size() > 1) {
      const std::vector<int> reached = flood({result.front()});
      for (const int element : result)
        if (std::find(reached.begin(), reached.end(), element) == reached.end())
          throw InputError({{"E-HOLE", {input_.file, 0, 0}, fmt::format("the {} ({}, {}, {}) lies exactly on a facet or segment: move it to the side that it means", what, seed[0], seed[1], seed[2])}});
    }
    return result;
  }

  bool holds(const Element& e, const Point& p) const {
    if (e[3] < 0) {
      for (int i = 0; i < 3; ++i)
        if (planar_orientation({2, 1}, point(e[i]), point(e[(i + 1) % 3]), p) < 0) return false;
      return true;
    }
    const Point &a = point(e[0]), &b = point(e[1]), &c = point(e[2]), &d = point(e[3]);
    return orientation(p, b, c, d) >= 0 && orientation(a, p, c, d) >= 0 && orientation(a, b, p, d) >= 0 && orientation(a, b, c, p) >= 0;
  }

  std::vector<char> inside() {
    std::vector<char> kept(elements_.size(), 1);
    std::vector<int> seeds = at_outside_;
    for (const auto& hole : input_.holes) {
      const std::vector<int> at = at_seed(hole, "hole point");
      if (at.empty()) result_.remarks.push_back(fmt::format("the hole point ({}, {}, {}) lies outside of the convex hull: it removes nothing", hole[0], hole[1], hole[2]));
      seeds.insert(seeds.end(), at.begin(), at.end());
    }
    for (const int element : flood(std::move(seeds))) kept[element] = 0;
    return kept;
  }

  void mark_regions() {
    attribute_.assign(elements_.size(), 0);
    for (const InputRegion& region : input_.regions)
      for (const int element : flood(at_seed(region.seed, "region point"))) attribute_[element] = region.attribute;
  }

  void round(bool exact) {
    Mesh& mesh = result_.mesh;
    std::vector<Point> rounded;
    mpq_class greatest;
    for (std::size_t id = 0; id < placement_.points.size(); ++id) {
      const Point at = placement_.points[id].position.scaled(complex_.scale);
      std::array<double, 3> doubles{};
      std::array<std::string, 3> texts;
      mpq_class squared;
      for (int axis = 0; axis < 3; ++axis) {
        doubles[axis] = at.high(axis) + at.low(axis);
        const mpq_class value = placement_.rational_positions.empty() ? rational_coordinate(at, axis) : placement_.rational_positions[id][axis];
        const mpq_class step = value - mpq_class(doubles[axis]);
        squared += step * step;
        if (exact) texts[axis] = value.get_str();
      }
      if (squared != 0) ++result_.moved;
      if (squared > greatest) greatest = squared;
      mesh.points.push_back(doubles);
      if (exact) mesh.exact.push_back(std::move(texts));
      rounded.push_back(Point::from_doubles(doubles[0], doubles[1], doubles[2]));
    }
    result_.greatest_move = std::sqrt(greatest.get_d());
    for (const Element& e : elements_) {
      const int side = e[3] < 0 ? planar_orientation({2, 1}, rounded[e[0]], rounded[e[1]], rounded[e[2]]) : orientation(rounded[e[0]], rounded[e[1]], rounded[e[2]], rounded[e[3]]);
      if (side <= 0) ++result_.inverted;
    }
  }

  const Complex& complex_;
  const Input& input_;
  const Placement& placement_;
  ConformingMesh result_;
  bool volume_ = false;
  std::vector<Element> elements_;
  std::vector<std::vector<int>> chains_, neighbours_;
  std::vector<std::vector<FacetId>> facets_of_;
  std::map<Side, FacetId> faces_;
  std::vector<Side> barriers_;
  std::vector<int> at_outside_;
  std::vector<double> attribute_;
};

}  // namespace

ConformingMesh conforming_mesh(const Complex& complex, const Input& input, const Placement& placement, Keep keep, bool exact) {
  return Maker(complex, input, placement).run(keep, exact);
}

}  // namespace confidel
