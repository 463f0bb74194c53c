// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audit/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/audit/location.h"
#include "core/numbers/predicates.h"
#include "core/placement/pencil.h"
#include "core/planar/facet_triangulation.h"
#include "core/planar/frame.h"
#include "core/tetrahedra/delaunay.h"

namespace confidel {
namespace {

using Triangle = std::array<int, 3>;

class Auditor {
 public:
  Auditor(const Complex& complex, const Mesh& mesh, double near) : complex_(complex), mesh_(mesh), locations_(locate(complex, mesh, near)) {}

  Audit run() {
    const std::set<int> duplicates(locations_.duplicates.begin(), locations_.duplicates.end());
    for (int id = 0; id < static_cast<int>(points().size()); ++id)
      if (duplicates.count(id) == 0) tetrahedra_.insert(id, points()[id], id - 1);
    flat_ = tetrahedra_.dimension() < 3;
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) audit_.facets.push_back(audit_facet(static_cast<FacetId>(f)));
    facets_of_ = facets_of_segments(complex_);
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) audit_.segments.push_back(audit_segment(static_cast<SegmentId>(s)));
    if (!flat_) audit_subfaces();
    audit_.off = std::move(locations_.off);
    audit_.duplicates = std::move(locations_.duplicates);
    audit_.inner_points = locations_.inner;
    for (const OffCarrier& off : audit_.off) audit_.worst_distance = std::max(audit_.worst_distance, off.distance);
    make_certificate();
    return std::move(audit_);
  }

 private:
  const std::vector<Point>& points() const { return locations_.points; }
  const Point& point(int id) const { return locations_.points[id]; }

  struct Cell {
    Triangle corners{};  ///< points of the mesh, counter-clockwise in their facet
    mpq_class offset;    ///< of its sphere, in the input's coordinates
  };

  /// The chain of points on a segment, its ends included. Pre: both ends are points.
  std::vector<int> chain(SegmentId segment) const {
    std::vector<int> result = locations_.on_segment[segment];
    result.insert(result.begin(), locations_.point_of_vertex[complex_.segments[segment][0]]);
    result.push_back(locations_.point_of_vertex[complex_.segments[segment][1]]);
    return result;
  }

  static std::set<VertexId> vertices_of(const Facet& facet) {
    std::set<VertexId> result(facet.isolated.begin(), facet.isolated.end());
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& edge : *edges) result.insert(edge.begin(), edge.end());
    return result;
  }

  AuditedPart audit_facet(FacetId f) {
    cells_.emplace_back();
    const Facet& facet = complex_.facets[f];
    AuditedPart part;
    std::set<int> own(locations_.on_facet[f].begin(), locations_.on_facet[f].end());
    for (const VertexId vertex : vertices_of(facet)) {
      if (locations_.point_of_vertex[vertex] < 0) part.missing.push_back(vertex);
      else own.insert(locations_.point_of_vertex[vertex]);
    }
    if (!part.missing.empty()) return part;
    FacetTriangulation planar(projection_of(facet.normal));
    std::vector<std::pair<std::array<int, 2>, bool>> pieces;
    for (const bool boundary : {true, false})
      for (const auto& [a, b] : boundary ? facet.boundary : facet.constraints) {
        const std::vector<int> along = chain(complex_.find_segment(a, b));
        own.insert(along.begin(), along.end());
        for (std::size_t i = 0; i + 1 < along.size(); ++i) pieces.push_back({{along[i], along[i + 1]}, boundary});
      }
    for (const int id : own) planar.add_vertex(id, point(id));
    for (const auto& [ends, boundary] : pieces) planar.add_constraint(ends[0], ends[1], boundary);
    planar.mark();

    part.standing = Standing::holds;
    const Difference normal = certificate_normal(complex_, facet);
    for (const Triangle& corners : planar.triangles()) {
      ++part.pieces;
      Cell cell{corners, 0};
      const Intrusion intrusion = flat_ ? flat_intrusion(corners, planar) : space_intrusion(corners, planar, normal, cell.offset);
      if (!intrusion.found) {
        cells_.back().push_back(std::move(cell));
        continue;
      }
      part.standing = Standing::fails;
      note(intrusion, corners, part.bad, part.piece, part.intrusion);
    }
    return part;
  }

  static void note(const Intrusion& intrusion, const Triangle& corners, int& count, Triangle& worst, Intrusion& worst_intrusion) {
    ++count;
    if (worst_intrusion.found && worst_intrusion.relative_depth >= intrusion.relative_depth) return;
    worst = corners;
    worst_intrusion = intrusion;
  }

  /// All points lie in one plane: the closed disk may hold further points on its circle, but none beyond a constraint.
  Intrusion flat_intrusion(const Triangle& corners, const FacetTriangulation& planar) const {
    const auto is_corner = [&](int id) { return std::find(corners.begin(), corners.end(), id) != corners.end(); };
    const Point &a = point(corners[0]), &b = point(corners[1]), &c = point(corners[2]);
    if (const Intrusion inside = find_intrusion(a, b, c, points(), [&](int id) { return is_corner(id); }); inside.found) return inside;
    const Projection projection = projection_of(plane_normal(a, b, c));
    const int turn = planar_orientation(projection, a, b, c);
    for (int i = 0; i < 3; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 3];
      if (!planar.is_constraint(from, to)) continue;
      for (int id = 0; id < static_cast<int>(points().size()); ++id)
        if (!is_corner(id) && diametral_power(a, b, c, point(id)) == 0 && planar_orientation(projection, point(from), point(to), point(id)) * turn < 0) return {true, id, -1, 0};
    }
    return {};
  }

  /// Exact: some sphere of the pencil is empty, strictly off the plane, and no tie lies beyond a constraint. Then offset is that of one.
  Intrusion space_intrusion(const Triangle& t, const FacetTriangulation& planar, const Difference& normal, mpq_class& offset) {
    const Intrusion intrusion = face_intrusion(t);
    if (intrusion.found) return intrusion;
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (!planar.is_constraint(a, b)) continue;
      for (const int d : tetrahedra_.coplanar_across(a, b, c))
        if (diametral_power(point(a), point(b), point(c), point(d)) == 0) return {true, d, -1, 0};
    }
    offset = offset_of(t, normal);
    return {};
  }

  /// A face of the tetrahedralization with two neighbours that are not cospherical has an empty sphere between theirs. Everything else is
  /// decided by all points.
  Intrusion face_intrusion(const Triangle& t) const {
    const auto face = tetrahedra_.face(t[0], t[1], t[2]);
    if (face.exists && (face.above < 0 || face.below < 0 || in_sphere(point(t[0]), point(t[1]), point(t[2]), point(face.above), point(face.below)) != 0)) return {};
    return find_intrusion(point(t[0]), point(t[1]), point(t[2]), points(), [&](int id) { return id == t[0] || id == t[1] || id == t[2]; });
  }

  mpq_class offset_of(const Triangle& t, const Difference& normal) const {
    auto face = tetrahedra_.face(t[0], t[1], t[2]);
    if (!face.exists) face = tetrahedra_.cocircular_face(t[0], t[1], t[2]);
    const Point &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    std::optional<mpq_class> low, high;
    if (face.above >= 0) high = pencil_parameter(a, b, c, point(face.above), normal);
    if (face.below >= 0) low = pencil_parameter(a, b, c, point(face.below), normal);
    const Double3 u = approximate_difference(b, a), w = approximate_difference(c, a), n = cross(u, w);
    const double radius = length(u) * length(w) * length(u - w) / (2 * length(n));
    const Double3 steered{mpz_class(normal.vector[0]).get_d(), mpz_class(normal.vector[1]).get_d(), mpz_class(normal.vector[2]).get_d()};
    const mpq_class offset = choose_offset(low, high, radius / std::ldexp(length(steered), -normal.exponent));
    // t n is a length: in the input's coordinates n grows by 4^scale and lengths by 2^scale.
    return times_power_of_two(offset, -complex_.scale);
  }

  AuditedPart audit_segment(SegmentId s) const {
    AuditedPart part;
    for (const VertexId vertex : complex_.segments[s])
      if (locations_.point_of_vertex[vertex] < 0) part.missing.push_back(vertex);
    if (!part.missing.empty()) return part;
    const std::vector<int> along = chain(s);
    part.pieces = static_cast<int>(along.size()) - 1;
    part.standing = Standing::holds;
    for (const FacetId f : facets_of_[s])
      if (audit_.facets[f].standing == Standing::holds) return part;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      if (is_clear(along[i], along[i + 1])) continue;
      ++part.bad;
      const bool is_edge = tetrahedra_.dimension() >= 1 && tetrahedra_.is_edge(along[i], along[i + 1]);
      if (part.piece[0] < 0 || !is_edge) part.piece = {along[i], along[i + 1], -1};
      if (!is_edge) part.standing = Standing::fails;
      else if (part.standing == Standing::holds) part.standing = Standing::present;
    }
    return part;
  }

  /// No other point in or on the diametral ball: the rule `hanging`.
  bool is_clear(int a, int b) const {
    for (int id = 0; id < static_cast<int>(points().size()); ++id)
      if (id != a && id != b && diametral_power(point(a), point(b), point(id)) <= 0) return false;
    return true;
  }

  // --- the mesh's own triangles ----------------------------------------------------------------------------------------------------

  std::set<Triangle> faces_of_mesh() const {
    std::set<Triangle> result;
    const auto add = [&](Triangle face) {
      std::sort(face.begin(), face.end());
      if (face[0] != face[1] && face[1] != face[2]) result.insert(face);
    };
    for (const Triangle& face : mesh_.faces) add(face);
    if (result.empty())
      for (const auto& [a, b, c, d] : mesh_.tetrahedra) add({a, b, c}), add({a, b, d}), add({a, c, d}), add({b, c, d});
    return result;
  }

  bool contains_centroid(FacetId f, const Triangle& face) const {
    Double3 centroid{};
    for (const int id : face) centroid = centroid + (1.0 / 3) * point(id).approximate();
    const Facet& facet = complex_.facets[f];
    const Projection projection = projection_of(facet.normal);
    const Point p = Point::from_doubles(centroid[0], centroid[1], centroid[2]);
    for (const auto& corners : facet.triangles) {
      bool inside = true;
      for (int i = 0; i < 3 && inside; ++i)
        inside = planar_orientation(projection, complex_.vertices[corners[i]], complex_.vertices[corners[(i + 1) % 3]], p) >= 0;
      if (inside) return true;
    }
    return false;
  }

  void audit_subfaces() {
    for (const Triangle& face : faces_of_mesh()) {
      const auto& first = locations_.near_facets[face[0]];
      for (const FacetId f : first) {
        const auto has = [&](int id) { return std::binary_search(locations_.near_facets[id].begin(), locations_.near_facets[id].end(), f); };
        if (!has(face[1]) || !has(face[2]) || !contains_centroid(f, face)) continue;
        AuditedPart& part = audit_.facets[f];
        ++part.subfaces;
        if (collinear(point(face[0]), point(face[1]), point(face[2]))) {
          ++part.bad_subfaces;
          continue;
        }
        const Intrusion intrusion = face_intrusion(face);
        if (intrusion.found) note(intrusion, face, part.bad_subfaces, part.subface, part.subface_intrusion);
      }
    }
  }

  // --- what holds, as a certificate's complex ----------------------------------------------------------------------------------------

  bool kept(SegmentId s) const { return audit_.segments[s].standing == Standing::holds; }
  bool kept_facet(FacetId f) const { return audit_.facets[f].standing == Standing::holds; }

  void make_certificate() {
    const std::set<int> duplicates(audit_.duplicates.begin(), audit_.duplicates.end());
    Complex& complex = audit_.complex;
    complex.dimension = complex_.dimension;
    complex.scale = complex_.scale;
    std::vector<int> carried(points().size(), 0);
    for (std::size_t s = 0; s < complex_.segments.size(); ++s)
      if (kept(static_cast<SegmentId>(s)))
        for (const int id : locations_.on_segment[s]) carried[id] = 1;
    for (std::size_t f = 0; f < complex_.facets.size(); ++f)
      if (kept_facet(static_cast<FacetId>(f)))
        for (const int id : locations_.on_facet[f]) carried[id] = 1;

    // Vertices first, in the complex's order, then the points that belong to nothing that holds, then the carried ones.
    std::vector<VertexId> vertex_name(complex_.vertices.size(), -1);
    std::vector<int> name(points().size(), -1);
    for (std::size_t v = 0; v < complex_.vertices.size(); ++v) {
      if (locations_.point_of_vertex[v] < 0) continue;
      name[locations_.point_of_vertex[v]] = vertex_name[v] = static_cast<int>(complex.vertices.size());
      complex.vertices.push_back(complex_.vertices[v]);
    }
    bool foreign = false;
    for (int id = 0; id < static_cast<int>(points().size()); ++id) {
      if (name[id] >= 0 || carried[id] != 0 || duplicates.count(id) != 0) continue;
      foreign = true;
      name[id] = static_cast<int>(complex.vertices.size());
      complex.vertices.push_back(point(id));
    }
    audit_.whole = !foreign && audit_.conforms();

    Placement& placement = audit_.placement;
    for (const Point& vertex : complex.vertices) placement.points.push_back({vertex, PointKind::vertex, -1});
    const auto carry = [&](const std::vector<int>& ids, PointKind kind, int carrier) {
      for (const int id : ids) {
        if (name[id] >= 0) continue;
        name[id] = static_cast<int>(placement.points.size());
        placement.points.push_back({point(id), kind, carrier});
      }
    };
    const auto renamed = [&](std::array<VertexId, 2> edge) { return std::array<VertexId, 2>{vertex_name[edge[0]], vertex_name[edge[1]]}; };
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      if (!kept(static_cast<SegmentId>(s))) continue;
      carry(locations_.on_segment[s], PointKind::edge, static_cast<int>(complex.segments.size()));
      complex.segments.push_back(renamed(complex_.segments[s]));
      complex.segment_markers.push_back(complex_.segment_markers[s]);
    }
    std::set<Segment> in_facets;
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
      if (!kept_facet(static_cast<FacetId>(f))) continue;
      const int facet_name = static_cast<int>(complex.facets.size());
      carry(locations_.on_facet[f], PointKind::interior, facet_name);
      Facet facet = complex_.facets[f];
      for (VertexId& vertex : facet.frame) vertex = vertex_name[vertex];
      for (auto* edges : {&facet.boundary, &facet.constraints})
        for (auto& edge : *edges) {
          edge = renamed(edge);
          in_facets.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
        }
      for (VertexId& vertex : facet.isolated) vertex = vertex_name[vertex];
      facet.triangles.clear();
      complex.facets.push_back(std::move(facet));
      for (Cell& cell : cells_[f])
        placement.cells.push_back({facet_name, {name[cell.corners[0]], name[cell.corners[1]], name[cell.corners[2]]}, CellKind::C, -1, cell.offset});
    }
    SegmentId segment_name = 0;
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      if (!kept(static_cast<SegmentId>(s))) continue;
      if (in_facets.count(complex.segments[segment_name]) == 0) {
        const std::vector<int> along = chain(static_cast<SegmentId>(s));
        for (std::size_t i = 0; i + 1 < along.size(); ++i) placement.hanging.push_back({segment_name, name[along[i]], name[along[i + 1]]});
      }
      ++segment_name;
    }
  }

  const Complex& complex_;
  const Mesh& mesh_;
  Locations locations_;
  DelaunayTetrahedralization tetrahedra_;
  bool flat_ = false;
  Audit audit_;
  std::vector<std::vector<Cell>> cells_;  ///< of each facet: those that hold
  std::vector<std::vector<FacetId>> facets_of_;
};

}  // namespace

bool Audit::conforms() const {
  const auto holds = [](const AuditedPart& part) { return part.standing == Standing::holds; };
  return std::all_of(segments.begin(), segments.end(), holds) && std::all_of(facets.begin(), facets.end(), holds);
}

bool Audit::fails() const {
  const auto fails = [](const AuditedPart& part) { return part.standing == Standing::fails; };
  return std::any_of(segments.begin(), segments.end(), fails) || std::any_of(facets.begin(), facets.end(), fails);
}

Audit audit_mesh(const Complex& complex, const Mesh& mesh, double near) {
  if (complex.dimension == 2)
    for (const auto& point : mesh.points)
      if (point[2] != 0) throw InputError({{"E-VALUE", {mesh.file, 0, 0}, "the input is planar, but the mesh has points off the plane z = 0"}});
  if (complex.dimension == 3 && mesh.dimension == 2) throw InputError({{"E-VALUE", {mesh.file, 0, 0}, "the input is of dimension 3, but the mesh of dimension 2"}});
  return Auditor(complex, mesh, near).run();
}

}  // namespace confidel
