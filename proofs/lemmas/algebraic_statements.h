// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of lemma-claims.md section 4 on exact points, with the paper's constants. Where the claim leaves room for rounding
// (H-ball, H-offset, L16), these do not. For one translation unit: algebraic_instance.cpp.
#pragma once

#include <set>

#include "proofs/lemmas/algebraic_kernel.h"

namespace confidel::algebraic {

class Statements {
 public:
  /// rational: whose cells say over which facets edges lie (L15).
  Statements(const Kernel& kernel, const Sizes& sizes, const Instance& rational, const std::map<int, Points::OnSphere>& spheres)
      : kernel_(kernel), instance_(kernel.instance()), spheres_(spheres), rational_(rational), sizes_(sizes), h_(kernel.length(sizes.spacing, sizes.squared_spacing)), r_(kernel.length(sizes.radius, number(sizes.squared_radius))), d_(kernel.length(sizes.offset, sizes.offset * sizes.offset)),
        all_(kernel.space().index([](int) { return true; })) {}

  /// By the lemma's ID. Pre: it is not L19, L20 or L21.
  Count test(const std::string& id) {
    using Statement = void (Statements::*)(Count&);
    static const std::map<std::string, Statement> table{
        {"H-angle", &Statements::angle}, {"H-ball", &Statements::ball}, {"H-offset", &Statements::offset}, {"H-chord", &Statements::chord}, {"L1", &Statements::arc_spacing},
        {"L2", &Statements::edge_spacing}, {"L3", &Statements::spoke_bulge}, {"L4", &Statements::box_bulge}, {"L5", &Statements::protectors_apart},
        {"L6", &Statements::boundary_separation}, {"L7", &Statements::obtuse_corners}, {"L8", &Statements::insertions}, {"L9", &Statements::end_cells_empty},
        {"L10", &Statements::spokes_and_caps}, {"L11", &Statements::spokes_and_arcs}, {"L12", &Statements::alignment}, {"L13", &Statements::boxes_empty},
        {"L14", &Statements::sheet_separation}, {"L15", &Statements::tilt}, {"L16", &Statements::other_cells_empty}, {"L17", &Statements::locally_delaunay},
        {"L18", &Statements::emptiness}, {"L18b", &Statements::ties}, {"L22", &Statements::hanging}, {"L23", &Statements::penetration}};
    Count count;
    (this->*table.at(id))(count);
    return count;
  }

  bool on_sphere(int v, int p) {
    const auto [place, fresh] = on_sphere_.try_emplace({v, p}, false);
    if (!fresh) return place->second;
    if (const auto known = spheres_.find(p); known != spheres_.end() && known->second.vertex == v)
      place->second = kernel_.decided(dot(known->second.direction, known->second.direction) - 1) == 0;
    else
      place->second = vanishes([&](const auto& g) { return square(g.between(p, v)) - g.squared(r_); });
    return place->second;
  }
  template <class Formula>
  bool vanishes(Formula formula) const {
    return kernel_.evaluate(formula).sign == 0;
  }
  template <class V>
  static auto square(const V& v) {
    return dot(v, v);
  }
  const Kernel::Length& offset_length() const { return d_; }

  /// a - b = c - d, by coordinates.
  bool equal_steps(int a, int b, int c, int d) const {
    const Kernel::Exact g{kernel_};
    const Vector difference = minus(g.between(a, b), g.between(c, d));
    return std::all_of(difference.begin(), difference.end(), [&](const Number& x) { return kernel_.decided(x) == 0; });
  }
  /// The protectors of two cells T, the first opening, the second closing at the same vertex, cross or touch, while their edges do not.
  bool cross_each_other(int opening, int closing) const {
    const auto end = [&](int cell) { return *std::find_if(instance_.end_cells.begin(), instance_.end_cells.end(), [&](const EndCell& e) { return e.cell == cell; }); };
    const EndCell one = end(opening), two = end(closing);
    const auto turn = [&](int from, int to) {
      return kernel_.evaluate([&](const auto& g) { return dot(normal(g, instance_.cells[opening].facet), cross(g.between(from, one.v), g.between(to, one.v))); }).sign;
    };
    return turn(one.m, two.m) > 0 && turn(one.a, two.a) <= 0;
  }

  /// The pencil of the cell has no sphere without both points (lemma-claims.md section 5, L18).
  bool excludes_all_spheres(int cell, int below, int above) const {
    const auto& c = instance_.cells[cell].corners;
    const FacetId facet = instance_.cells[cell].facet;
    const auto height = [&](int x) { return kernel_.evaluate([&](const auto& g) { return dot(normal(g, facet), g.between(x, c[0])); }).sign; };
    const auto gap = kernel_.evaluate([&](const auto& g) {
      const auto u = g.between(c[1], c[0]), w = g.between(c[2], c[0]), n = cross(u, w);
      const auto centre = plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u)));
      const auto power = [&](const auto& y) { return dot(n, n) * dot(y, y) - dot(y, centre); };
      const auto x = g.between(below, c[0]), y = g.between(above, c[0]);
      return power(x) * dot(normal(g, facet), y) - power(y) * dot(normal(g, facet), x);
    });
    return height(below) < 0 && height(above) > 0 && gap.sign < 0;
  }

 private:
  template <class Reader>
  auto normal(const Reader& g, FacetId facet) const {
    const auto& [i, j, k] = instance_.facets[facet].frame;
    return cross(g.between(j, i), g.between(k, i));
  }
  static Signed rational_sign(const mpq_class& q, double value) { return {sgn(q), q == 0 ? 0 : value}; }
  static double root_of(const mpq_class& q) { return std::sqrt(q.get_d()); }

  void angle(Count& count) {
    for (std::size_t s = 0; s < instance_.segments.size(); ++s)
      for (const VertexId v : instance_.segments[s]) {
        count.begin();
        const RationalVector e = confidel::minus(instance_.positions[instance_.other_end(static_cast<SegmentId>(s), v)], instance_.positions[v]);
        for (const SegmentId other : instance_.segments_at(v)) {
          if (other == static_cast<SegmentId>(s)) continue;
          const RationalVector g = confidel::minus(instance_.positions[instance_.other_end(other, v)], instance_.positions[v]);
          const mpq_class product = confidel::dot(e, g), squared_cosine = product * product / (squared(e) * squared(g));
          const double value = root_of(sizes_.squared_cosine) - sgn(product) * root_of(squared_cosine);
          count.offer(product <= 0 ? Signed{1, value} : rational_sign(sizes_.squared_cosine - squared_cosine, value), [&] { return fmt::format("segment-{}-segment-{}", s, other); });
        }
        count.end();
      }
  }

  // Equalities: nothing to spare, no slack.
  void ball(Count& count) {
    const auto test = [&](int cell, int v, const std::vector<int>& points) {
      count.begin();
      count.touch();
      for (const int p : points) count.require(on_sphere(v, p), [&] { return cell_and_point(cell, p); });
      count.end();
    };
    for (const EndCell& end : instance_.end_cells) test(end.cell, end.v, {end.a});
    for (const SpokeCell& spoke : instance_.spoke_cells) test(spoke.cell, spoke.v, {spoke.p, spoke.q});
  }

  void offset(Count& count) {
    for (const EndCell& end : instance_.end_cells) {
      count.begin();
      count.offer(kernel_.evaluate([&](const auto& g) { return g.squared(d_) / square(g.between(end.a, end.m)) - g.number(1); }), [&] { return cell_name(end.cell); });
      count.end();
    }
  }

  void chord(Count& count) {
    const Kernel::Length chord = kernel_.length(sizes_.chord, sizes_.squared_chord);
    count.begin();
    count.offer(kernel_.evaluate([&](const auto& g) { return g.squared(chord) / g.squared(h_) - g.number(1); }), [] { return "chord"; });
    count.end();
  }

  void between(Count& count, int cell, int from, int to) {
    count.begin();
    for (const bool above : {true, false})
      count.offer(kernel_.evaluate([&](const auto& g) {
        const auto ratio = square(g.between(to, from)) / g.squared(h_);
        return above ? ratio - g.number(1) : g.number(2.25) - ratio;
      }), [&] { return cell_name(cell); });
    count.end();
  }
  /// b^2 - h^2 in fewer roots, if both points are known by their directions.
  std::optional<Number> above_spacing(const SpokeCell& spoke) const {
    const auto p = spheres_.find(spoke.p), q = spheres_.find(spoke.q);
    if (p == spheres_.end() || q == spheres_.end() || p->second.vertex != spoke.v || q->second.vertex != spoke.v) return {};
    return square(minus(q->second.direction, p->second.direction)) - 2 * (1 - sizes_.step.cosine);
  }
  void arc_spacing(Count& count) {
    for (const SpokeCell& spoke : instance_.spoke_cells) {
      const auto above = [&](const auto& g) { return square(g.between(spoke.q, spoke.p)) / g.squared(h_) - g.number(1); };
      const auto below = [&](const auto& g) { return g.number(2.25) - square(g.between(spoke.q, spoke.p)) / g.squared(h_); };
      const Bounded filter = above(Kernel::Filter{kernel_});
      const auto known = std::abs(filter.value) > filter.error ? std::nullopt : above_spacing(spoke);
      Signed slack;
      if (known) {
        slack.sign = kernel_.decided(*known);
        slack.value = slack.sign == 0 ? 0 : known->doubleValue();
      } else {
        slack = kernel_.evaluate(above);
      }
      count.begin();
      count.offer(slack, [&] { return cell_name(spoke.cell); });
      count.offer(kernel_.evaluate(below), [&] { return cell_name(spoke.cell); });
      count.end();
      above_[{spoke.p, spoke.q}] = slack;
    }
  }
  void edge_spacing(Count& count) {
    for (const BoxCells& box : instance_.boxes) between(count, box.cells[0], box.corners[0], box.corners[1]);
  }

  void spoke_bulge(Count& count) {
    for (const SpokeCell& spoke : instance_.spoke_cells) {
      count.begin();
      const auto name = [&] { return cell_name(spoke.cell); };
      const auto products = [&](const auto& g) { return dot(g.between(spoke.p, spoke.v), g.between(spoke.q, spoke.v)); };
      const int d = kernel_.evaluate(products).sign;
      // As L1 found it, which comes before.
      const auto found = above_.find({spoke.p, spoke.q});
      const int longer = found != above_.end() ? found->second.sign : kernel_.evaluate([&](const auto& g) { return square(g.between(spoke.q, spoke.p)) - g.squared(h_); }).sign;
      if (longer > 0 || d < 0) {
        count.require(d > 0, name);
        if (d > 0)
          count.offer(kernel_.evaluate([&](const auto& g) {
            const auto a = g.between(spoke.p, spoke.v), b = g.between(spoke.q, spoke.v);
            const auto base = square(minus(b, a)), h = g.squared(h_), x = square(cross(a, b)), e = dot(a, b), more = base - h;
            return (g.number(4) * h * base * e * e - more * more * x) / (h * h * x);
          }), name);
      }
      count.end();
    }
  }

  void box_bulge(Count& count) {
    for (const BoxCells& box : instance_.boxes) {
      count.begin();
      const auto excess = [&](const auto& g) { return square(g.between(box.corners[1], box.corners[0])) - g.squared(h_); };
      if (kernel_.evaluate(excess).sign > 0)
        count.offer(kernel_.evaluate([&](const auto& g) {
          const auto h = g.squared(h_), more = excess(g);
          return (g.number(4) * h * square(g.between(box.corners[2], box.corners[1])) - more * more) / (h * h);
        }), [&] { return cell_name(box.cells[0]); });
      count.end();
    }
  }

  void protectors_apart(Count& count) {
    for (const EndCell& opening : instance_.end_cells) {
      if (!opening.opens) continue;
      count.begin();
      if (const int index = instance_.closing_cell(opening); index >= 0) {
        const EndCell& closing = instance_.end_cells[index];
        const FacetId facet = instance_.cells[opening.cell].facet;
        const auto turn = [&](int from, int to) {
          Signed result = kernel_.evaluate([&](const auto& g) { return dot(normal(g, facet), cross(g.between(from, opening.v), g.between(to, opening.v))); });
          const auto length = [&](int id) {
            const auto x = kernel_.difference(id, opening.v);
            return std::sqrt(square(x).value);
          };
          const auto n = normal(Kernel::Filter{kernel_}, facet);
          result.value /= length(from) * length(to) * std::sqrt(square(n).value);
          return result;
        };
        const auto name = [&] { return fmt::format("cell-{}-cell-{}", opening.cell, closing.cell); };
        if (turn(opening.m, closing.m).sign > 0) {
          const Signed turned = turn(opening.a, closing.a);
          count.offer(turned, name);
          count.require(turned.sign > 0, name);
        }
      }
      count.end();
    }
  }

  void boundary_separation(Count& count) {
    std::vector<std::vector<int>> of_facet(instance_.facets.size());
    for (std::size_t id = 0; id < instance_.kinds.size(); ++id)
      if (instance_.protects(static_cast<int>(id))) of_facet[instance_.carriers[id]].push_back(static_cast<int>(id));
    const double h = h_.bounded.value;
    for (const auto& points : of_facet)
      for (const int x : points) {
        count.begin();
        const auto& p = kernel_.space().approximate(x);
        for (const int y : points) {
          const auto& q = kernel_.space().approximate(y);
          const double distance = std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2);
          if (x == y || distance > h * h * (1 + count.smallest()) * (1 + 0x1p-20)) continue;
          const auto found = above_.find({x, y}), turned = above_.find({y, x});
          count.offer(found != above_.end()    ? found->second
                      : turned != above_.end() ? turned->second
                                               : kernel_.evaluate([&](const auto& g) { return square(g.between(y, x)) / g.squared(h_) - g.number(1); }),
                      [&] { return fmt::format("point-{}-point-{}", x, y); });
        }
        count.end();
      }
  }

  void obtuse_corners(Count& count) {
    for (const EndCell& end : instance_.end_cells) {
      count.begin();
      const FacetId facet = instance_.cells[end.cell].facet;
      const int box = end.opens ? instance_.cell_with_edge(facet, end.a, end.m) : instance_.cell_with_edge(facet, end.m, end.a);
      const int spoke = end.opens ? instance_.cell_with_edge(facet, end.v, end.a) : instance_.cell_with_edge(facet, end.a, end.v);
      int q = -1, s = -1;
      if (box >= 0 && instance_.box_of(box) >= 0) {
        const auto& corners = instance_.boxes[instance_.box_of(box)].corners;
        for (int k = 0; k < 4; ++k)
          if (corners[k] == end.a)
            for (const int side : {1, 3})
              if (corners[(k + side) % 4] != end.m) q = corners[(k + side) % 4];
      }
      if (spoke >= 0 && instance_.cells[spoke].kind == CellKind::S)
        for (const int corner : instance_.cells[spoke].corners)
          if (corner != end.v && corner != end.a) s = corner;
      const auto name = [&] { return cell_name(end.cell); };
      count.require(q >= 0 && s >= 0, name);
      if (q >= 0 && s >= 0) {
        Signed corner = kernel_.evaluate([&](const auto& g) { return g.number(0) - dot(g.between(q, end.a), g.between(s, end.a)); });
        corner.value /= std::sqrt(square(kernel_.difference(q, end.a)).value * square(kernel_.difference(s, end.a)).value);
        count.offer(corner, name);
      }
      count.end();
    }
  }

  void insertions(Count& count) {
    std::vector<std::vector<int>> known(instance_.facets.size());
    for (std::size_t id = 0; id < instance_.kinds.size(); ++id)
      if (instance_.protects(static_cast<int>(id))) known[instance_.carriers[id]].push_back(static_cast<int>(id));
    for (const Insertion& insertion : instance_.insertions) {
      count.begin();
      const auto& [a, b, c] = insertion.corners;
      const auto& middle = kernel_.space().approximate(insertion.point);
      // 2 (z0 - a) |n|^2 and |n|^2.
      const auto centre = [&, a = a, b = b, c = c](const auto& g) {
        const auto u = g.between(b, a), w = g.between(c, a), n = cross(u, w);
        return std::pair{plus(times(dot(u, u), cross(w, n)), times(dot(w, w), cross(n, u))), dot(n, n)};
      };
      const auto from_centre = [&, a = a](const auto& g, int x) {
        const auto [twice, size] = centre(g);
        return minus(g.between(x, a), times(g.number(0.5) / size, twice));
      };
      count.require(kernel_.evaluate([&](const auto& g) { return g.squared(h_) - g.number(4096) * square(from_centre(g, insertion.point)); }).sign >= 0,
                    [&] { return fmt::format("point-{}", insertion.point); });
      const double reach = Space::reach(h_.bounded.value, 1 + count.smallest()) + h_.bounded.value * 0x1p-5;
      const auto distance = [&](int x) {
        const auto& q = kernel_.space().approximate(x);
        return std::hypot(q[0] - middle[0], q[1] - middle[1], q[2] - middle[2]);
      };
      for (const int x : known[insertion.facet]) {
        if (distance(x) > reach) continue;
        const Signed slack = kernel_.evaluate([&](const auto& g) { return square(from_centre(g, x)) / g.squared(h_) - g.number(1); });
        const auto name = [&] { return fmt::format("point-{}-point-{}", insertion.point, x); };
        count.offer(slack, name);
        count.require(slack.sign > 0, name);
      }
      for (const OutlineEdge& edge : instance_.outline) {
        if (instance_.cells[edge.cell].facet != insertion.facet || std::min(distance(edge.a), distance(edge.b)) > reach + 2 * h_.bounded.value) continue;
        // To the segment, or to its line, which is nearer, if an end is at a right angle.
        const auto along = [&](int from, int to) {
          const Kernel::Filter g{kernel_};
          const Bounded t = dot(g.between(to, from), minus(BoundedVector{}, from_centre(g, from)));
          return t.upper() < 0;
        };
        const int end = along(edge.a, edge.b) ? edge.a : along(edge.b, edge.a) ? edge.b : -1;
        count.offer(kernel_.evaluate([&](const auto& g) {
          const auto four = g.number(4) / g.squared(h_);
          if (end >= 0) return four * square(from_centre(g, end)) - g.number(1);
          const auto line = g.between(edge.b, edge.a);
          return four * square(cross(line, from_centre(g, edge.a))) / square(line) - g.number(1);
        }), [&] { return fmt::format("point-{}-edge-{}-{}", insertion.point, edge.a, edge.b); });
      }
      known[insertion.facet].push_back(insertion.point);
      count.end();
    }
  }

  /// One cell against the points of an index; `skipped`: a point that is no matter.
  void test_cell(Count& count, const PointIndex& index, int cell, int skipped, bool off_plane_only) {
    const CellSphere sphere(kernel_, instance_.cells[cell].corners);
    const FacetId facet = instance_.cells[cell].facet;
    sphere.visit(index, count.smallest(), [&](int id) {
      if (id == skipped) return;
      const Signed power = sphere.power(id);
      const auto name = [&] { return cell_and_point(cell, id); };
      if (power.sign > 0) {
        if (power.value < count.smallest() && (!off_plane_only || !kernel_.in_plane(id, facet))) count.offer(power, name);
        return;
      }
      const bool off_plane = !kernel_.in_plane(id, facet);
      count.require(power.sign == 0 && !off_plane, name);
      if (power.sign == 0) count.touch();
      if (power.sign < 0 && (off_plane || !off_plane_only)) count.offer(power, name);
    });
  }
  void end_cells_empty(Count& count) {
    for (const EndCell& end : instance_.end_cells) {
      count.begin();
      test_cell(count, all_, end.cell, -1, false);
      count.end();
    }
  }
  void spokes_and_caps(Count& count) {
    std::map<int, PointIndex> caps;
    std::set<std::pair<int, int>> seen;
    for (const EndCell& end : instance_.end_cells)
      if (seen.insert({end.v, end.m}).second) caps.try_emplace(end.v, kernel_.space().empty_index()).first->second.insert(end.m, kernel_.space().approximate(end.m));
    for (const SpokeCell& spoke : instance_.spoke_cells) {
      count.begin();
      if (const auto found = caps.find(spoke.v); found != caps.end()) test_cell(count, found->second, spoke.cell, -1, false);
      count.end();
    }
  }
  void spokes_and_arcs(Count& count) {
    const PointIndex protecting = kernel_.space().index([&](int id) { return instance_.protects(id); });
    for (const SpokeCell& spoke : instance_.spoke_cells) {
      count.begin();
      test_cell(count, protecting, spoke.cell, -1, false);
      count.end();
    }
  }
  void boxes_empty(Count& count) {
    for (const BoxCells& box : instance_.boxes)
      for (const int cell : box.cells) {
        count.begin();
        int fourth = -1;
        for (const int corner : box.corners) {
          const auto& own = instance_.cells[cell].corners;
          if (std::find(own.begin(), own.end(), corner) == own.end()) fourth = corner;
        }
        test_cell(count, all_, cell, fourth, false);
        count.end();
      }
  }
  void other_cells_empty(Count& count) {
    for (std::size_t c = 0; c < instance_.cells.size(); ++c) {
      if (instance_.cells[c].kind != CellKind::C) continue;
      const int cell = static_cast<int>(c);
      const CellSphere sphere(kernel_, instance_.cells[c].corners);
      count.begin();
      test_cell(count, all_, cell, -1, false);
      count.offer(kernel_.evaluate([&](const auto& g) { return g.number(4) * g.squared(h_) / sphere.four_squared_radius(g) - g.number(1); }), [&] { return cell_name(cell); });
      count.end();
    }
  }
  int fourth_corner(int cell) const {
    if (instance_.cells[cell].kind != CellKind::R || instance_.box_of(cell) < 0) return -1;
    const auto& own = instance_.cells[cell].corners;
    for (const int corner : instance_.boxes[instance_.box_of(cell)].corners)
      if (std::find(own.begin(), own.end(), corner) == own.end()) return corner;
    return -1;
  }
  void emptiness(Count& count) {
    // The fourth corner of a rectangle is in the plane and on the circle.
    for (std::size_t c = 0; c < instance_.cells.size(); ++c) {
      count.begin();
      test_cell(count, all_, static_cast<int>(c), fourth_corner(static_cast<int>(c)), true);
      count.end();
    }
  }
  void ties(Count& count) {
    for (std::size_t c = 0; c < instance_.cells.size(); ++c) {
      const PlacedCell& cell = instance_.cells[c];
      count.begin();
      for (int k = 0; k < 3; ++k) {
        const int p = cell.corners[k], q = cell.corners[(k + 1) % 3];
        SegmentId segment = -1;
        for (const int id : {p, q})
          if (instance_.on_segment_kind(id)) segment = instance_.carriers[id];
        if (segment < 0 && p < instance_.vertex_count && q < instance_.vertex_count) segment = instance_.find_segment(p, q);
        if (segment < 0 || !instance_.lies_on(p, segment) || !instance_.lies_on(q, segment) || !instance_.on_boundary_or_constraint(cell.facet, segment)) continue;
        const CellSphere sphere(kernel_, cell.corners);
        sphere.visit(all_, 0, [&, p = p, q = q](int id) {
          // Cheapest first: few points are beyond the edge.
          const auto side = [&](const auto& g) { return dot(normal(g, cell.facet), cross(g.between(q, p), g.between(id, p))); };
          if (kernel_.evaluate(side).sign >= 0 || !kernel_.in_plane(id, cell.facet)) return;
          count.require(sphere.power(id).sign != 0, [&] { return cell_and_point(static_cast<int>(c), id); });
        });
      }
      count.end();
    }
  }

  template <class Test>
  void protector_pairs(bool ordered, Test test) const {
    for (const PlacedRow& row : instance_.rows)
      for (std::size_t i = 0; i < row.protectors.size(); ++i)
        for (std::size_t j = ordered ? 0 : i + 1; j < row.protectors.size(); ++j)
          test(row, row.protectors[i], row.protectors[j], [&row, i, j] { return fmt::format("row-{}-facet-{}-facet-{}", row.segment, row.protectors[i].facet, row.protectors[j].facet); });
  }
  void alignment(Count& count) {
    protector_pairs(true, [&](const PlacedRow& row, const auto& one, const auto& two, auto name) {
      if (instance_.coplanar(one.facet, two.facet)) return;
      count.begin();
      const Signed slack = kernel_.evaluate([&](const auto& g) {
        const auto o = g.between(one.points.front(), row.points.front()), other = g.between(two.points.front(), row.points.front());
        return dot(other, minus(other, o)) / square(other);
      });
      count.offer(slack, name);
      count.require(slack.sign > 0, name);
      count.end();
    });
  }
  void sheet_separation(Count& count) {
    protector_pairs(false, [&](const PlacedRow&, const auto& one, const auto& two, auto name) {
      count.begin();
      count.offer(kernel_.evaluate([&](const auto& g) {
        return g.number(4) * square(g.between(one.points.front(), two.points.front())) / (g.number(9) * g.squared(h_)) - g.number(1);
      }), name);
      count.end();
    });
  }

  void tilt(Count& count) {
    const mpq_class bound = 1 - sizes_.squared_cosine;
    for (VertexId v = 0; v < instance_.vertex_count; ++v)
      for (const SegmentId segment : instance_.segments_at(v)) {
        const RationalVector u = confidel::minus(instance_.positions[instance_.other_end(segment, v)], instance_.positions[v]);
        for (const FacetId facet : instance_.facets_at(v)) {
          if (instance_.on_boundary_or_constraint(facet, segment) || cell_below(rational_, v, facet, u) < 0) continue;
          const mpq_class slack = squared_sine(instance_, facet, u) / bound - 1;
          count.begin();
          count.offer(rational_sign(slack, slack.get_d()), [&] { return fmt::format("vertex-{}-segment-{}-facet-{}", v, segment, facet); });
          count.end();
        }
      }
  }

  void locally_delaunay(Count& count) {
    for (const OutlineEdge& edge : instance_.outline) {
      count.begin();
      count.offer(CellSphere(kernel_, instance_.cells[edge.cell].corners).power(edge.y), [&] { return cell_and_point(edge.cell, edge.y); });
      count.end();
    }
  }
  void penetration(Count& count) {
    for (const OutlineEdge& edge : instance_.outline) {
      count.begin();
      if (kernel_.evaluate([&](const auto& g) { return dot(g.between(edge.a, edge.x), g.between(edge.b, edge.x)); }).sign < 0) {
        const CellSphere sphere(kernel_, instance_.cells[edge.cell].corners);
        count.offer(kernel_.evaluate([&](const auto& g) {
          const auto h = g.squared(h_);
          return (h - sphere.four_squared_radius(g) + square(g.between(edge.b, edge.a))) / h;
        }), [&] { return cell_name(edge.cell); });
      }
      count.end();
    }
  }

  void hanging(Count& count) {
    for (const auto& [segment, a, b] : instance_.hanging) {
      count.begin();
      for (int id = 0; id < static_cast<int>(instance_.kinds.size()); ++id) {
        if (id == a || id == b) continue;
        const Signed power = kernel_.evaluate([&, a = a, b = b](const auto& g) { return dot(g.between(id, a), g.between(id, b)) / square(g.between(b, a)); });
        const auto name = [&, a = a, b = b] { return fmt::format("subsegment-{}-{}-point-{}", a, b, id); };
        count.offer(power, name);
        count.require(power.sign > 0, name);
      }
      count.end();
    }
  }

  const Kernel& kernel_;
  const Instance& instance_;
  const std::map<int, Points::OnSphere>& spheres_;
  const Instance& rational_;
  const Sizes& sizes_;
  Kernel::Length h_, r_, d_;
  PointIndex all_;
  std::map<std::pair<int, int>, bool> on_sphere_;
  std::map<std::pair<int, int>, Signed> above_;  ///< b^2/h^2 - 1 of the chords
};

}  // namespace confidel::algebraic
