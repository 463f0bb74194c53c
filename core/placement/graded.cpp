// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/graded.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <span>

#include "core/placement/estimate.h"
#include "core/placement/local_claims.h"
#include "core/placement/open_hull.h"
#include "core/placement/point_index.h"
#include "core/placement/sphere.h"

namespace confidel {

BufferSizes graded_sizes(const Complex& complex, const Features& features) {
  BufferSizes sizes;
  const std::size_t vertices = complex.vertices.size();
  sizes.radius.resize(vertices);
  sizes.vertex_angle.assign(vertices, std::numbers::pi);
  for (std::size_t v = 0; v < vertices; ++v) sizes.radius[v] = std::min(1.0, features.vertex_distance[v] / 3);
  sizes.offset.resize(complex.segments.size());
  sizes.dihedral = features.dihedral_angle;
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    double d = features.segment_distance[s] / 3;
    for (int end = 0; end < 2; ++end) {
      const VertexId v = complex.segments[s][end];
      const double theta = features.segment_angle[s][end], omega = features.facet_angle[s][end];
      const double angle = std::min({theta / 3, 0.7 * omega, std::numbers::pi / 6});
      d = std::min(d, sizes.radius[v] * std::sin(angle));
      sizes.vertex_angle[v] = std::min({sizes.vertex_angle[v], theta, omega});
    }
    sizes.offset[s] = d;
  }
  // Arcs of facets that meet at an edge come as close as d_e sin(alpha_e) and end up about as short. Rounding must stay below the square of
  // that by 16 r_v (theory.md section 5), by a factor of four here: 2^-12 angle^2 r_v is that for this angle.
  for (std::size_t s = 0; s < complex.segments.size(); ++s)
    for (const VertexId v : complex.segments[s])
      sizes.vertex_angle[v] = std::min(sizes.vertex_angle[v], 8 * sizes.offset[s] / sizes.radius[v] * std::sin(std::min(features.dihedral_angle[s], std::numbers::pi / 2)));
  return sizes;
}

namespace {

// A refinement that ends within so many points needs no estimate: its number of points is known.
constexpr int pilot_points = 20000;
// The estimate must exceed --max-points by this factor before a run is refused for it.
constexpr double estimate_margin = 2;

class Refinement {
 public:
  Refinement(const Complex& complex, const Features& features, const Limits& limits, Progress& progress)
      : complex_(complex), features_(features), limits_(limits), progress_(progress), sizes_(graded_sizes(complex, features)), zones_(complex, sizes_), all_(complex.vertices) {
    for (const Facet& facet : complex.facets) {
      projections_.push_back(projection_of(facet.normal));
      double reach = 0;
      for (const auto& [a, c] : facet.boundary)
        reach = std::max(reach, length(approximate_difference(complex.vertices[a], complex.vertices[facet.frame[0]])));
      reach_.push_back(reach);
    }
    region_sizes_.assign(complex.facets.size(), 0);
  }

  Placement run() {
    index_new_points();
    for (;;) {
      settle_buffer_zones();
      if (!refine_regions()) break;
    }
    if (!estimated_) progress_.estimated(zones_.point_count());
    check_static_cells();
    Placement placement = zones_.result();
    claim_local(complex_, features_, sizes_, placement);
    return placement;
  }

 private:
  void index_new_points() {
    for (int id = static_cast<int>(all_.size()); id < zones_.point_count(); ++id) all_.insert(id, zones_.point(id).approximate());
    progress_.at("placing points", zones_.point_count());
    const bool stopped = progress_.stop_requested(zones_.point_count());
    estimate(stopped || (limits_.max_points > 0 && zones_.point_count() > limits_.max_points));
    if (limits_.max_points > 0 && zones_.point_count() > limits_.max_points) throw LimitReached("max-points", zones_.point_count());
    if (stopped) throw LimitReached("stopped", zones_.point_count());
  }

  // An index of the points since a given one; cells that were free before need to be tested against these only.
  PointIndex recent_points(int since) const {
    PointIndex recent(complex_.vertices);
    for (int id = since; id < zones_.point_count(); ++id) recent.insert(id, zones_.point(id).approximate());
    return recent;
  }

  bool encroached(const PointIndex& index, Projection projection, Ball& ball, const Point& a, const Point& b, const Point& c,
                  const Point* first = nullptr, const Point* second = nullptr) const {
    if (ball.radius < 0) ball = circumscribed_ball(a, b, c);
    return index.visit_ball(ball.centre, ball.radius, [&](int id) {
      const Point& p = zones_.point(id);
      if (&p == &a || &p == &b || &p == &c) return false;
      return encroaches(projection, a, b, c, p, first, second);
    });
  }

  bool segment_encroached(const PointIndex& index, const Point& a, const Point& b) const {
    const Ball ball = diametral_ball(a, b);
    return index.visit_ball(ball.centre, ball.radius, [&](int id) {
      const Point& p = zones_.point(id);
      return &p != &a && &p != &b && diametral_power(a, b, p) <= 0;
    });
  }

  bool rectangle_encroached(const PointIndex& index, const BufferZones::Row& row, const BufferZones::Protector& protector, std::size_t i) const {
    const Point *a = &zones_.point(row.stations[i].point), *b = &zones_.point(row.stations[i + 1].point);
    if (!protector.left) std::swap(a, b);
    Ball ball;
    return encroached(index, projections_[protector.facet], ball, *a, *b, zones_.point(protector.points[i]), a, b);
  }

  // Once, when the pilot's points are used up or a limit ends the run: what is known to be open is extrapolated.
  void estimate(bool at_once) {
    if (estimated_ || (zones_.point_count() <= pilot_points && !at_once)) return;
    estimated_ = true;
    std::vector<OpenInterval> intervals;
    for (const auto& row : zones_.rows())
      for (std::size_t i = 0; i + 1 < row.stations.size(); ++i) {
        bool free = row.protectors.empty() ? row.free[i] : true;
        for (const auto& protector : row.protectors) free = free && protector.free[i];
        if (!free)
          intervals.push_back({row.segment, 1 + static_cast<int>(row.protectors.size()), zones_.point(row.stations[i].point).approximate(),
                               zones_.point(row.stations[i + 1].point).approximate()});
      }
    const double expected = zones_.point_count() + estimate_further_points(complex_, sizes_, intervals);
    progress_.estimated(expected);
    if (limits_.max_points > 0 && expected > estimate_margin * static_cast<double>(limits_.max_points))
      throw LimitReached("max-points", zones_.point_count());
  }

  // Rules (0), (i) and (ii), until nothing changes.
  void settle_buffer_zones() {
    for (;;) {
      const PointIndex recent = recent_points(buffer_seen_);
      buffer_seen_ = zones_.point_count();
      test_rows(recent);
      test_sectors(recent);
      test_region_boundaries();
      if (zones_.apply_requests() == 0) return;
      index_new_points();
    }
  }

  void test_rows(const PointIndex& recent) {
    auto& rows = zones_.rows();
    for (std::size_t r = 0; r < rows.size(); ++r) {
      auto& row = rows[r];
      const std::size_t intervals = row.stations.size() - 1;
      for (auto& protector : row.protectors)
        for (std::size_t i = 0; i < intervals; ++i) {
          const bool bad = rectangle_encroached(protector.free[i] ? recent : all_, row, protector, i);
          protector.free[i] = !bad;
          if (bad) zones_.request_row(static_cast<int>(r), static_cast<int>(i));
        }
      if (!row.protectors.empty()) continue;
      for (std::size_t i = 0; i < intervals; ++i) {
        const bool bad = segment_encroached(row.free[i] ? recent : all_, zones_.point(row.stations[i].point), zones_.point(row.stations[i + 1].point));
        row.free[i] = !bad;
        if (bad) zones_.request_row(static_cast<int>(r), static_cast<int>(i));
      }
    }
  }

  void test_sectors(const PointIndex& recent) {
    auto& sectors = zones_.sectors();
    for (std::size_t s = 0; s < sectors.size(); ++s) {
      auto& sector = sectors[s];
      for (std::size_t i = 0; i + 1 < sector.arc.size(); ++i) {
        Ball ball;
        const bool bad = encroached(sector.free[i] ? recent : all_, projections_[sector.facet], ball, complex_.vertices[sector.vertex],
                                    zones_.point(sector.arc[i].point), zones_.point(sector.arc[i + 1].point));
        sector.free[i] = !bad;
        if (bad) zones_.request_sector(static_cast<int>(s), static_cast<int>(i));
      }
    }
  }

  void test_region_boundaries() {
    for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
      Region& region = zones_.region(static_cast<FacetId>(f));
      if (region.vertex_count() == region_sizes_[f]) continue;
      region_sizes_[f] = region.vertex_count();
      for (const auto& ends : region.encroached_boundary()) zones_.request_boundary(static_cast<FacetId>(f), ends);
    }
  }

  class Environment : public RegionEnvironment {
   public:
    Environment(Refinement& owner, FacetId facet, const PointIndex& recent) : owner_(owner), facet_(facet), recent_(recent) {}
    bool encroached(const Point& a, const Point& b, const Point& c, bool only_new, Ball& ball) override {
      return owner_.encroached(only_new ? recent_ : owner_.all_, owner_.projections_[facet_], ball, a, b, c);
    }
    bool near_new_point(const Ball& ball) override {
      return recent_.visit_ball(ball.centre, ball.radius, [](int) { return true; });
    }
    Point circumcentre(const Point& a, const Point& b, const Point& c) override {
      Double3 offset;
      circumscribed_ball(a, b, c, &offset);
      const double radius = length(offset);
      owner_.placed_.fetch_add(1, std::memory_order_relaxed);
      ++own_;
      const Point& origin = owner_.complex_.vertices[owner_.complex_.facets[facet_].frame[0]];
      // eta R / 4 with eta = 1/16 (theory.md section 5).
      return CircumcentreRounding{owner_.zones_.frame(facet_), origin, owner_.reach_[facet_]}.round(a, offset, radius / 64);
    }
    bool stopped() override {
      // A facet that uses up the pilot alone stops once, so that the estimate comes early: the same for any number of threads.
      if (!owner_.estimated_ && own_ >= pilot_points) return true;
      const long count = owner_.placed_.load(std::memory_order_relaxed) + owner_.base_count_;
      if (owner_.limits_.max_points > 0 && count > owner_.limits_.max_points) return true;
      return owner_.progress_.stop_requested(count);
    }

   private:
    Refinement& owner_;
    FacetId facet_;
    const PointIndex& recent_;
    int own_ = 0;
  };

  // Rule (iii). Facets are refined independently against the points known at the beginning; returns whether anything changed.
  bool refine_regions() {
    const PointIndex recent = recent_points(region_seen_);
    region_seen_ = zones_.point_count();
    base_count_ = zones_.point_count();
    placed_ = 0;
    const int facets = static_cast<int>(complex_.facets.size());
    std::vector<Region::Refinement> refinements(facets);
    tbb::task_arena arena(std::max(1, limits_.threads));
    arena.execute([&] {
      tbb::parallel_for(0, facets, [&](int f) {
        Environment environment(*this, f, recent);
        refinements[f] = zones_.region(f).refine(environment);
      });
    });
    const bool estimated_before = estimated_;
    bool changed = false;
    bool open = false;
    for (int f = 0; f < facets; ++f) {
      open |= refinements[f].open;
      if (refinements[f].stuck) throw StrategyFailed("graded: a circumcentre was rounded onto an existing point");
      zones_.adopt_new_vertices(f);
      changed |= refinements[f].inserted > 0;
      for (const auto& ends : refinements[f].blocking) zones_.request_boundary(f, ends);
    }
    changed |= zones_.apply_requests() > 0;
    index_new_points();
    if (open && estimated_before && limits_.max_points > 0) throw LimitReached("max-points", zones_.point_count());
    return changed || open;
  }

  // T cells are static: nothing can be split there, the sizes must have been right.
  void check_static_cells() const {
    for (const auto& sector : zones_.sectors_view()) {
      if (sector.full) continue;
      for (int side : {0, 1}) {
        const Point &v = complex_.vertices[sector.vertex], &m = zones_.point(zones_.projection_point(sector, side));
        const Point& a = zones_.point(side == 0 ? sector.arc.front().point : sector.arc.back().point);
        const Point *first = side == 0 ? &v : &m, *second = side == 0 ? &m : &v;
        Ball ball;
        if (encroached(all_, projections_[sector.facet], ball, v, m, a, first, second))
          throw StrategyFailed("graded: the triangle at the end of an edge is encroached (vertex " + std::to_string(sector.vertex) + ")");
      }
    }
  }

  const Complex& complex_;
  const Features& features_;
  const Limits& limits_;
  Progress& progress_;
  const BufferSizes sizes_;
  BufferZones zones_;
  PointIndex all_;
  std::vector<Projection> projections_;
  std::vector<double> reach_;
  std::vector<int> region_sizes_;
  std::atomic<long> placed_{0};
  long base_count_ = 0;
  bool estimated_ = false;
  int buffer_seen_ = 0, region_seen_ = 0;
};

}  // namespace

Placement place_graded(const Complex& complex, const Features& features, const Limits& limits, Progress& progress) {
  if (auto placement = place_with_open_hull(complex, features, limits, progress)) return std::move(*placement);
  try {
    Refinement refinement(complex, features, limits, progress);
    return refinement.run();
  } catch (const std::logic_error& failure) {
    throw StrategyFailed(failure.what());  // its sizes do not fit this input: undecided, never a crash
  }
}

}  // namespace confidel
