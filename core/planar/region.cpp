// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/region.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>
#include <tuple>

#include "core/planar/traits.h"

namespace confidel {
namespace {

struct FaceInfo {
  bool inside = false;
  bool free = false;  // known not to be encroached by anything but later points
  Ball ball{};        // where those would be
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, PlanarTraits>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, PlanarTraits, CGAL::Constrained_triangulation_face_base_2<PlanarTraits>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<PlanarTraits, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Edge = Triangulation::Edge;

}  // namespace

constexpr std::size_t beyond_cache = 10000;  // vertices, of more than a kilobyte each

// Places on a curve that stays in one octant of the box, and of each part of it, before it goes to the next (Morton order).
struct Box {
  Double3 low, high;
  std::uint64_t place(const Point& p) const {
    std::uint64_t result = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double width = high[axis] - low[axis];
      if (width <= 0) continue;
      std::uint64_t x = static_cast<std::uint64_t>(std::clamp((p.high(axis) - low[axis]) / width, 0.0, 1.0) * 0x1fffff);
      // Two free bits before each.
      x = (x | x << 32) & 0x1f00000000ffff;
      x = (x | x << 16) & 0x1f0000ff0000ff;
      x = (x | x << 8) & 0x100f00f00f00f00f;
      x = (x | x << 4) & 0x10c30c30c30c30c3;
      x = (x | x << 2) & 0x1249249249249249;
      result |= x << axis;
    }
    return result;
  }
};

struct Region::Implementation {
  explicit Implementation(Projection chosen) : projection(chosen), triangulation(PlanarTraits(chosen)) {}

  Projection projection;
  Triangulation triangulation;
  std::vector<VertexHandle> vertices;
  std::deque<Point> own_points;  // stable addresses
  FaceHandle hint;

  const Point& point(VertexHandle v) const { return *v->point().point; }

  Box box() const {
    Box result;
    result.low.fill(1e300);
    result.high.fill(-1e300);
    for (const VertexHandle v : vertices)
      for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = std::min(result.low[axis], point(v).high(axis));
        result.high[axis] = std::max(result.high[axis], point(v).high(axis));
      }
    return result;
  }

  VertexHandle insert(const Point& p) {
    VertexHandle v = triangulation.insert(PlanarPoint{&p}, hint);
    return number(v);
  }

  VertexHandle number(VertexHandle v) {
    v->info() = static_cast<int>(vertices.size());
    vertices.push_back(v);
    hint = v->face();
    return v;
  }

  bool inside(FaceHandle f) const { return !triangulation.is_infinite(f) && f->info().inside; }

  void mark() {
    for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = FaceInfo{.inside = false};
    // Breadth-first over faces; a face's depth is the number of boundary segments crossed.
    std::vector<std::pair<FaceHandle, bool>> todo{{triangulation.infinite_face(), false}};
    CGAL::Unique_hash_map<FaceHandle, bool> seen(false);
    seen[triangulation.infinite_face()] = true;
    while (!todo.empty()) {
      auto [f, within] = todo.back();
      todo.pop_back();
      f->info().inside = within;
      for (int i = 0; i < 3; ++i) {
        FaceHandle g = f->neighbor(i);
        if (seen[g]) continue;
        seen[g] = true;
        todo.emplace_back(g, triangulation.is_constrained(Edge(f, i)) ? !within : within);
      }
    }
  }

  // The face inside that has the boundary segment ab, and the index of the vertex opposite to it.
  Edge inner_edge(int a, int b) const {
    FaceHandle f;
    int i = 0;
    if (!triangulation.is_edge(vertices[a], vertices[b], f, i)) throw std::logic_error("region: no such boundary segment");
    if (inside(f)) return Edge(f, i);
    return Edge(f->neighbor(i), triangulation.mirror_index(f, i));
  }

  bool encroaches(const Edge& e, const Point& p) const {
    return diametral_power(point(e.first->vertex(Triangulation::ccw(e.second))),
                           point(e.first->vertex(Triangulation::cw(e.second))), p) < 0;
  }

  // Walks from inside a face to the face that contains p; stops at the first boundary segment in the way.
  // Returns the face, or a null handle and the blocking edge.
  std::pair<FaceHandle, Edge> walk(FaceHandle f, const Point& p) const {
    FaceHandle previous;
    // A visibility walk may cycle in a constrained triangulation; then a search by CGAL decides.
    for (int steps = 0; steps < 10000; ++steps) {
      int crossed = -1;
      for (int k = 0; k < 3 && crossed < 0; ++k) {
        const int i = (k + steps) % 3;
        if (f->neighbor(i) == previous) continue;
        const Point& a = point(f->vertex(Triangulation::ccw(i)));
        const Point& b = point(f->vertex(Triangulation::cw(i)));
        if (planar_orientation(projection, a, b, p) < 0) crossed = i;
      }
      if (crossed < 0) return {f, Edge()};
      if (triangulation.is_constrained(Edge(f, crossed))) return {FaceHandle(), Edge(f, crossed)};
      previous = f;
      f = f->neighbor(crossed);
    }
    f = triangulation.locate(PlanarPoint{&p}, f);
    if (inside(f)) return {f, Edge()};
    return {FaceHandle(), Edge()};
  }

  // The face inside that contains p, or a null handle. A walk may run into the boundary although the straight way from f is free.
  FaceHandle home(FaceHandle f, const Point& p) const {
    const FaceHandle walked = walk(f, p).first;
    return walked != FaceHandle() ? walked : located(f, p);
  }
  FaceHandle located(FaceHandle f, const Point& p) const {
    const FaceHandle result = triangulation.locate(PlanarPoint{&p}, f);
    return inside(result) ? result : FaceHandle();
  }

  std::array<int, 2> ends(const Edge& e) const {
    const int a = e.first->vertex(Triangulation::ccw(e.second))->info();
    const int b = e.first->vertex(Triangulation::cw(e.second))->info();
    return {std::min(a, b), std::max(a, b)};
  }
};

Region::Region(Projection projection) : implementation_(std::make_unique<Implementation>(projection)) {}
Region::~Region() = default;
Region::Region(Region&&) noexcept = default;
Region& Region::operator=(Region&&) noexcept = default;

int Region::insert(const Point& point) { return implementation_->insert(point)->info(); }

void Region::constrain(int a, int b) {
  implementation_->triangulation.insert_constraint(implementation_->vertices[a], implementation_->vertices[b]);
  implementation_->hint = FaceHandle();
}

void Region::mark() { implementation_->mark(); }

int Region::split(int a, int b, const Point& p) {
  auto& self = *implementation_;
  auto& t = self.triangulation;
  const Edge edge = self.inner_edge(a, b);
  const Point& pa = self.point(self.vertices[a]);
  const Point& pb = self.point(self.vertices[b]);
  const int side = planar_orientation(self.projection, pa, pb, self.point(edge.first->vertex(edge.second)));
  if (planar_orientation(self.projection, pa, pb, p) == 0) {
    VertexHandle v = self.number(t.insert(PlanarPoint{&p}, Triangulation::EDGE, edge.first, edge.second));
    auto f = t.incident_faces(v), end = f;
    do {
      bool within = false;
      if (!t.is_infinite(f))
        for (int i = 0; i < 3 && !within; ++i)
          within = planar_orientation(self.projection, pa, pb, self.point(f->vertex(i))) == side;
      f->info() = FaceInfo{.inside = within};
    } while (++f != end);
    return v->info();
  }
  const FaceHandle face = self.home(edge.first, p);
  const char* const beyond = "region: an arc point lies beyond a boundary segment";
  if (face == FaceHandle()) throw std::logic_error(beyond);
  VertexHandle v = self.number(t.insert(PlanarPoint{&p}, face));
  auto f = t.incident_faces(v), end = f;
  do f->info() = FaceInfo{.inside = true};
  while (++f != end);
  bool simple = true;
  for (int other : {a, b}) {
    FaceHandle g;
    int i = 0;
    if (!t.is_edge(v, self.vertices[other], g, i)) simple = false;
    try {
      t.insert_constraint(v, self.vertices[other]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw std::logic_error(beyond);  // inside, but not in front of ab
    }
  }
  const Edge old = [&] {
    // The triangle a b p: the side of ab where p is.
    FaceHandle g;
    int i = 0;
    t.is_edge(self.vertices[a], self.vertices[b], g, i);
    if (g->vertex(i) == v) return Edge(g, i);
    return Edge(g->neighbor(i), t.mirror_index(g, i));
  }();
  old.first->info() = FaceInfo{.inside = false};
  t.remove_constrained_edge(old.first, old.second);
  if (!simple) self.mark();  // constraints were forced through triangles: which are new is unknown
  self.hint = v->face();
  return v->info();
}

std::vector<std::array<int, 2>> Region::encroached_boundary() const {
  const auto& self = *implementation_;
  std::vector<std::array<int, 2>> result;
  for (auto f = self.triangulation.finite_faces_begin(); f != self.triangulation.finite_faces_end(); ++f) {
    if (!f->info().inside) continue;
    for (int i = 0; i < 3; ++i) {
      const Edge e(f, i);
      // In a constrained Delaunay triangulation the opposite vertex encroaches if any visible one does.
      if (self.triangulation.is_constrained(e) && self.encroaches(e, self.point(f->vertex(i)))) result.push_back(self.ends(e));
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Region::Refinement Region::refine(RegionEnvironment& environment) {
  auto& self = *implementation_;
  auto& t = self.triangulation;
  Refinement result;
  const bool ruppert = environment.boundary_gives_way();
  // Greatest circumradius first (approximate: it only steers). In a region that is larger than the cache only up to a factor of 2: triangles of one
  // size follow their neighbours, so that they find what they need there. Ties by vertex numbers.
  const Box box = self.box();
  using Entry = std::tuple<double, std::uint64_t, int, int, int>;
  std::priority_queue<Entry> queue;
  const auto push = [&](FaceHandle f) {
    const Point &a = self.point(f->vertex(0)), &b = self.point(f->vertex(1)), &c = self.point(f->vertex(2));
    const auto edge = [](const Point& p, const Point& q) {
      return std::hypot(p.high(0) - q.high(0), p.high(1) - q.high(1), p.high(2) - q.high(2));
    };
    const double x = edge(a, b), y = edge(b, c), z = edge(c, a);
    const double area = std::sqrt(std::max(0.0, (x + y + z) * (-x + y + z) * (x - y + z) * (x + y - z)));
    const int first = f->vertex(0)->info(), second = f->vertex(1)->info(), third = f->vertex(2)->info();
    std::array<int, 3> v{first, second, third};
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    const double size = area > 0 ? x * y * z / area : 1e300;
    if (self.vertices.size() < beyond_cache) queue.emplace(size, 0, -v[0], -v[1], -v[2]);
    else queue.emplace(std::ldexp(1.0, std::ilogb(size)), box.place(a), -v[0], -v[1], -v[2]);
  };
  const auto examine = [&](FaceHandle f) {
    FaceInfo& info = f->info();
    if (info.free && info.ball.radius >= 0 && !environment.near_new_point(info.ball)) return;
    const bool bad = environment.encroached(self.point(f->vertex(0)), self.point(f->vertex(1)), self.point(f->vertex(2)), info.free, info.ball);
    info.free = !bad;
    if (bad) push(f);
  };
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    if (f->info().inside) examine(f);

  std::vector<FaceHandle> conflicts;
  std::vector<Edge> rim;
  while (!queue.empty()) {
    const auto [size, place, first, second, third] = queue.top();
    queue.pop();
    FaceHandle f;
    if (!t.is_face(self.vertices[-first], self.vertices[-second], self.vertices[-third], f)) continue;
    if (!f->info().inside || f->info().free) continue;
    if (environment.stopped()) {
      result.open = true;
      break;
    }
    self.own_points.push_back(
        environment.circumcentre(self.point(f->vertex(0)), self.point(f->vertex(1)), self.point(f->vertex(2))));
    const Point& centre = self.own_points.back();
    auto [home, blocking] = self.walk(f, centre);
    if (home == FaceHandle() && !ruppert) home = self.located(f, centre);
    if (home == FaceHandle()) {
      if (blocking.first != FaceHandle())
        result.blocking.push_back(self.ends(blocking));
      else
        result.stuck = true;
      self.own_points.pop_back();
      continue;
    }
    bool taken = false;
    for (int i = 0; i < 3; ++i) taken |= self.point(home->vertex(i)) == centre;
    conflicts.clear();
    rim.clear();
    t.get_conflicts_and_boundary(PlanarPoint{&centre}, std::back_inserter(conflicts), std::back_inserter(rim), home);
    const std::size_t before = result.blocking.size();
    for (const Edge& e : rim)
      if (ruppert && t.is_constrained(e) && self.encroaches(e, centre)) result.blocking.push_back(self.ends(e));
    if (taken) result.stuck = true;
    if (taken || result.blocking.size() > before) {
      self.own_points.pop_back();
      continue;
    }
    const std::array<int, 3> corners{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    VertexHandle v = self.number(t.insert(PlanarPoint{&centre}, home));
    ++result.inserted;
    environment.inserted(corners, v->info());
    auto g = t.incident_faces(v), end = g;
    do {
      g->info() = FaceInfo{.inside = true};
      examine(g);
    } while (++g != end);
  }
  std::sort(result.blocking.begin(), result.blocking.end());
  result.blocking.erase(std::unique(result.blocking.begin(), result.blocking.end()), result.blocking.end());
  return result;
}

int Region::vertex_count() const { return static_cast<int>(implementation_->vertices.size()); }
const Point& Region::point(int vertex) const { return implementation_->point(implementation_->vertices[vertex]); }

std::vector<std::array<int, 3>> Region::triangles() const {
  std::vector<std::array<int, 3>> result;
  const auto& t = implementation_->triangulation;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    if (!f->info().inside) continue;
    std::array<int, 3> v{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    result.push_back(v);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t Region::triangle_count() const {
  std::size_t count = 0;
  const auto& t = implementation_->triangulation;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) count += f->info().inside;
  return count;
}

}  // namespace confidel
