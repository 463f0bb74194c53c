// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/rational_region.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "core/numbers/point.h"

namespace confidel {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
struct FaceState {
  bool inside = false, known = false;
};
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceState, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using FT = Kernel::FT;

// CGAL::CGAL is found with GMPXX: its exact numbers are ours.
static_assert(std::is_same_v<FT::Exact_type, mpq_class>);

FT number(const mpq_class& value) { return FT(value); }

mpq_class rational(const FT& value) { return value.exact(); }

}  // namespace

struct RationalRegion::Implementation {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
};

RationalRegion::RationalRegion() : implementation_(std::make_unique<Implementation>()) {}
RationalRegion::~RationalRegion() = default;

int RationalRegion::insert(const RationalPoint2& point, int near) {
  auto& [triangulation, vertices] = *implementation_;
  const Triangulation::Face_handle hint = near >= 0 ? vertices[near]->face() : Triangulation::Face_handle();
  const auto vertex = triangulation.insert(Kernel::Point_2(number(point[0]), number(point[1])), hint);
  const int id = static_cast<int>(vertices.size());
  vertex->info() = id;
  vertices.push_back(vertex);
  if (triangulation.number_of_vertices() != vertices.size()) throw std::logic_error("RationalRegion: a vertex twice");
  return id;
}

void RationalRegion::constrain(int a, int b) {
  implementation_->triangulation.insert_constraint(implementation_->vertices[a], implementation_->vertices[b]);
}

void RationalRegion::mark() {
  auto& triangulation = implementation_->triangulation;
  if (triangulation.dimension() < 2) return;
  std::deque<std::pair<Triangulation::Face_handle, bool>> queue;
  const auto visit = [&](Triangulation::Face_handle face, bool inside) {
    if (face->info().known) return;
    face->info() = {inside, true};
    queue.emplace_back(face, inside);
  };
  visit(triangulation.infinite_face(), false);
  while (!queue.empty()) {
    const auto [face, inside] = queue.front();
    queue.pop_front();
    for (int i = 0; i < 3; ++i) visit(face->neighbor(i), face->is_constrained(i) ? !inside : inside);
  }
}

std::vector<RationalRegion::Step> RationalRegion::refine(const mpq_class& threshold, int bits, const std::function<bool(long)>& stopped) {
  auto& [triangulation, vertices] = *implementation_;
  const FT bound = number(threshold);
  using Names = std::array<int, 3>;
  const auto names = [](Triangulation::Face_handle face) {
    return Names{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
  };
  const auto large = [&](Triangulation::Face_handle face) {
    return face->info().inside &&
           CGAL::compare(CGAL::squared_radius(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()), bound) == CGAL::LARGER;
  };
  // Oldest first. A triangle that is gone when its turn comes is passed over; its names tell.
  std::deque<std::pair<Triangulation::Face_handle, Names>> queue;
  for (const auto& triangle : triangles()) {
    Triangulation::Face_handle face;
    if (triangulation.is_face(vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]], face) && large(face))
      queue.emplace_back(face, triangle);
  }
  std::vector<Step> steps;
  while (!queue.empty()) {
    const Names corners = queue.front().second;
    queue.pop_front();
    Triangulation::Face_handle face;
    if (!triangulation.is_face(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]], face) || !large(face)) continue;
    const Kernel::Point_2 centre = CGAL::circumcenter(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
    const auto rounded = [&](const FT& value) {
      const double steering = CGAL::to_double(value);
      // Beyond a double's digits the exact value is rounded.
      mpz_class multiple;
      const double scaled = std::ldexp(steering, bits);
      const double error = std::ldexp(CGAL::to_interval(value).second - CGAL::to_interval(value).first, bits);
      if (std::abs(scaled) < 0x1p52 && error < 0.25) {
        multiple = mpz_class(std::nearbyint(scaled));
      } else {
        const mpq_class exact = times_power_of_two(rational(value), bits) + mpq_class(1, 2);
        mpz_fdiv_q(multiple.get_mpz_t(), exact.get_num_mpz_t(), exact.get_den_mpz_t());
      }
      return times_power_of_two(multiple, -bits);
    };
    const RationalPoint2 position{rounded(centre.x()), rounded(centre.y())};
    const Kernel::Point_2 point(number(position[0]), number(position[1]));
    Triangulation::Locate_type type;
    int index;
    const Triangulation::Face_handle where = triangulation.locate(point, type, index, face);
    if ((type != Triangulation::FACE && type != Triangulation::EDGE) || !where->info().inside ||
        (type == Triangulation::EDGE && where->is_constrained(index)))
      throw std::logic_error("Chew's rule: a circumcentre is not inside");
    const auto vertex = triangulation.insert(point, type, where, index);
    vertex->info() = static_cast<int>(vertices.size());
    vertices.push_back(vertex);
    steps.push_back({corners, vertex->info()});
    auto around = triangulation.incident_faces(vertex), first = around;
    do {
      around->info() = {true, true};  // no constraint is crossed: all that is new lies in the region
      const Triangulation::Face_handle fresh = around;
      if (large(fresh)) queue.emplace_back(fresh, names(fresh));
    } while (++around != first);
    if (stopped(static_cast<long>(vertices.size()))) break;
  }
  return steps;
}

int RationalRegion::vertex_count() const { return static_cast<int>(implementation_->vertices.size()); }

RationalPoint2 RationalRegion::point(int vertex) const {
  const auto& point = implementation_->vertices[vertex]->point();
  return {rational(point.x()), rational(point.y())};
}

std::vector<std::array<int, 3>> RationalRegion::triangles() const {
  std::vector<std::array<int, 3>> result;
  const auto& triangulation = implementation_->triangulation;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    if (!face->info().inside) continue;
    std::array<int, 3> names{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(names.begin(), std::min_element(names.begin(), names.end()), names.end());
    result.push_back(names);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace confidel
