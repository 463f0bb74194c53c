// SPDX-License-Identifier: GPL-3.0-or-later
// The only translation unit that instantiates CGAL's triangulations for the complex. Inexact constructions suffice: the
// vertices are doubles (one coordinate dropped), and edges that would need a constructed crossing are refused before
// they get here.
#include "core/complex/enclosed_region.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace confidel::building {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexId, Kernel>;
/// The info says what a flood has reached.
enum class Part { enclosed, exterior, hole };
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Part, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

class RegionBuilder {
 public:
  explicit RegionBuilder(const RegionInput& input)
      : input_(input), projection_(projection_of(input.normal)), bounding_(input.edges) {}

  Region build() {
    insert_vertices();
    if (triangulation_.dimension() < 2) {
      region_.outside_edges = input_.edges;
      region_.outside_points = input_.points;
      region_.seeds.assign(input_.seeds.size(), Region::Seed::outside);
      return std::move(region_);
    }
    insert_edges();
    flood(triangulation_.infinite_face(), Part::exterior);
    region_.encloses = has_enclosed_face();
    dig_holes();
    if (input_.hull_if_open && !has_enclosed_face()) {
      enclose_by_hull();
      dig_holes();
    }
    collect();
    return std::move(region_);
  }

 private:
  /// Orientation-preserving for a plane whose normal's greatest component is positive; see predicates.h.
  Kernel::Point_2 project(const std::array<double, 3>& position) const {
    return {position[(projection_.axis + 1) % 3], position[(projection_.axis + 2) % 3]};
  }

  void insert_vertices() {
    for (const auto* edges : {&input_.edges, &input_.guest_edges})
      for (const auto& [a, b] : *edges) {
        ids_.push_back(a);
        ids_.push_back(b);
      }
    ids_.insert(ids_.end(), input_.points.begin(), input_.points.end());
    ids_.insert(ids_.end(), input_.guest_points.begin(), input_.guest_points.end());
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());

    std::vector<std::pair<Kernel::Point_2, std::size_t>> order;
    order.reserve(ids_.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) order.emplace_back(project(input_.positions[ids_[i]]), i);
    using Map = CGAL::First_of_pair_property_map<std::pair<Kernel::Point_2, std::size_t>>;
    CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
    handles_.resize(ids_.size());
    FaceHandle hint;
    for (const auto& [point, i] : order) {
      handles_[i] = triangulation_.insert(point, hint);
      handles_[i]->info() = ids_[i];
      hint = handles_[i]->face();
    }
  }

  VertexHandle handle(VertexId vertex) const {
    return handles_[std::lower_bound(ids_.begin(), ids_.end(), vertex) - ids_.begin()];
  }

  void insert_edges() {
    for (const auto* edges : {&input_.edges, &input_.guest_edges})
      for (const auto& [a, b] : *edges) triangulation_.insert_constraint(handle(a), handle(b));
    for (const FaceHandle face : triangulation_.all_face_handles()) face->info() = Part::enclosed;
  }

  Segment edge_of(FaceHandle face, int index) const {
    const VertexId a = face->vertex(Triangulation::ccw(index))->info();
    const VertexId b = face->vertex(Triangulation::cw(index))->info();
    return {std::min(a, b), std::max(a, b)};
  }

  bool bounds(FaceHandle face, int index) const {
    return face->is_constrained(index) && std::binary_search(bounding_.begin(), bounding_.end(), edge_of(face, index));
  }

  void flood(FaceHandle start, Part part) {
    std::vector<FaceHandle> stack{start};
    start->info() = part;
    while (!stack.empty()) {
      const FaceHandle face = stack.back();
      stack.pop_back();
      for (int index = 0; index < 3; ++index) {
        const FaceHandle next = face->neighbor(index);
        if (next->info() != Part::enclosed || bounds(face, index)) continue;
        next->info() = part;
        stack.push_back(next);
      }
    }
  }

  bool has_enclosed_face() const {
    for (const FaceHandle face : triangulation_.finite_face_handles())
      if (face->info() == Part::enclosed) return true;
    return false;
  }

  void enclose_by_hull() {
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      face->info() = Part::enclosed;
      for (int index = 0; index < 3; ++index)
        if (triangulation_.is_infinite(face->neighbor(index)) && !bounds(face, index)) {
          region_.hull_edges.push_back(edge_of(face, index));
          face->set_constraint(index, true);
          face->neighbor(index)->set_constraint(triangulation_.mirror_index(face, index), true);
        }
    }
    std::sort(region_.hull_edges.begin(), region_.hull_edges.end());
    bounding_.insert(bounding_.end(), region_.hull_edges.begin(), region_.hull_edges.end());
    std::sort(bounding_.begin(), bounding_.end());
    region_.encloses = true;
  }

  /// The side of the directed edge a to b, seen from the side of CGAL's counter-clockwise order, on which the
  /// orthogonal projection of the seed lies: ((b-a) x (seed-a)) . n does not change when the seed moves along n.
  int side(VertexId a, VertexId b, const Point& seed) const {
    const Point& from = input_.vertices[a];
    const mpz_class product =
        dot(cross(difference(input_.vertices[b], from).vector, difference(seed, from).vector), input_.normal);
    return sgn(product) * projection_.sign;
  }

  std::array<int, 3> sides(FaceHandle face, const Point& seed) const {
    std::array<int, 3> result{};
    for (int index = 0; index < 3; ++index)
      result[index] =
          side(face->vertex(Triangulation::ccw(index))->info(), face->vertex(Triangulation::cw(index))->info(), seed);
    return result;
  }

  static bool contains(const std::array<int, 3>& sides) {
    return std::all_of(sides.begin(), sides.end(), [](int sign) { return sign >= 0; });
  }

  /// The finite face whose closure has the seed's projection: exact; the located face is a guess that usually is right.
  FaceHandle face_of_seed(std::size_t i) const {
    const FaceHandle guess = triangulation_.locate(project(projected(input_.seed_positions[i])));
    if (!triangulation_.is_infinite(guess) && contains(sides(guess, input_.seeds[i]))) return guess;
    for (const FaceHandle face : triangulation_.finite_face_handles())
      if (contains(sides(face, input_.seeds[i]))) return face;
    return {};
  }

  /// Rounded orthogonal projection to the plane through the first vertex.
  std::array<double, 3> projected(const std::array<double, 3>& position) const {
    std::array<double, 3> normal{};
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class component(input_.normal[axis], abs(input_.normal[projection_.axis]));
      normal[axis] = component.get_d();
    }
    const std::array<double, 3>& origin = input_.positions[ids_.front()];
    double along = 0, square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      along += (position[axis] - origin[axis]) * normal[axis];
      square += normal[axis] * normal[axis];
    }
    std::array<double, 3> result{};
    for (int axis = 0; axis < 3; ++axis) result[axis] = position[axis] - along / square * normal[axis];
    return std::isfinite(along) ? result : position;
  }

  void dig_holes() {
    region_.seeds.clear();
    for (std::size_t i = 0; i < input_.seeds.size(); ++i) region_.seeds.push_back(dig_hole(i));
  }

  Region::Seed dig_hole(std::size_t i) {
    const FaceHandle face = face_of_seed(i);
    if (face == FaceHandle()) return Region::Seed::outside;
    const std::array<int, 3> signs = sides(face, input_.seeds[i]);
    if (std::count(signs.begin(), signs.end(), 0) >= 2) return Region::Seed::on_edge;
    for (int index = 0; index < 3; ++index)
      if (signs[index] == 0 && bounds(face, index)) return Region::Seed::on_edge;
    if (face->info() == Part::exterior) return Region::Seed::outside;
    if (face->info() == Part::enclosed) flood(face, Part::hole);
    return Region::Seed::inside;
  }

  bool in_region(FaceHandle face) const { return !triangulation_.is_infinite(face) && face->info() == Part::enclosed; }

  void collect() {
    const bool reverse = projection_.sign < 0;
    std::vector<VertexId> used;
    for (const auto& [face, index] : triangulation_.finite_edges()) {
      if (!face->is_constrained(index)) continue;
      const Segment edge = edge_of(face, index);
      const bool left = in_region(face), right = in_region(face->neighbor(index));
      if (left && right) {
        region_.constraints.push_back(edge);
      } else if (left || right) {
        VertexId a = face->vertex(Triangulation::ccw(index))->info();
        VertexId b = face->vertex(Triangulation::cw(index))->info();
        if (left == reverse) std::swap(a, b);
        region_.boundary.push_back({a, b});
      } else {
        if (bounds(face, index)) region_.outside_edges.push_back(edge);
        continue;
      }
      used.insert(used.end(), edge.begin(), edge.end());
    }
    std::sort(region_.boundary.begin(), region_.boundary.end());
    std::sort(region_.constraints.begin(), region_.constraints.end());
    std::sort(region_.outside_edges.begin(), region_.outside_edges.end());
    std::sort(used.begin(), used.end());
    collect_points(used);
    collect_triangles(reverse);
  }

  void collect_points(const std::vector<VertexId>& used) {
    const auto is_used = [&](VertexId v) { return std::binary_search(used.begin(), used.end(), v); };
    for (const VertexId vertex : ids_) {
      if (is_used(vertex)) continue;
      // On no edge of the region: either all faces around it are in the region, or none.
      if (in_region(handle(vertex)->face()))
        region_.isolated.push_back(vertex);
      else if (std::binary_search(input_.points.begin(), input_.points.end(), vertex))
        region_.outside_points.push_back(vertex);
    }
  }

  void collect_triangles(bool reverse) {
    for (const FaceHandle face : triangulation_.finite_face_handles()) {
      if (!in_region(face)) continue;
      std::array<VertexId, 3> triangle{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
      if (reverse) std::swap(triangle[1], triangle[2]);
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      region_.triangles.push_back(triangle);
    }
    std::sort(region_.triangles.begin(), region_.triangles.end());
  }

  const RegionInput& input_;
  Projection projection_;
  std::vector<Segment> bounding_;
  Triangulation triangulation_;
  std::vector<VertexId> ids_;
  std::vector<VertexHandle> handles_;
  Region region_;
};

}  // namespace

Region enclosed_region(const RegionInput& input) { return RegionBuilder(input).build(); }

}  // namespace confidel::building
