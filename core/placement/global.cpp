// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/global.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/placement/point_index.h"
#include "core/placement/refutation.h"
#include "core/placement/sphere.h"

namespace confidel {
namespace {

// The estimate must exceed --max-points by this factor before a run is refused for it.
constexpr double estimate_margin = 1.2;
// Buffer zones up to this size are built and tested even where --max-points will refuse what follows: they may refute.
constexpr double tested_points = 3e5;
// Chew's refinement puts one point on so many h^2 of a facet, half a point of its boundary counted; measured on cubes, fans and wedges.
constexpr double area_per_point = 1.7;

BufferSizes buffer_sizes(const Complex& complex, const Features& features, const GlobalSizes& global, double rounding) {
  BufferSizes sizes;
  const double ratio = global.greatest_spacing / global.offset;
  sizes.radius.assign(complex.vertices.size(), global.radius);
  sizes.offset.assign(complex.segments.size(), global.offset);
  sizes.dihedral = features.dihedral_angle;
  sizes.vertex_angle.assign(complex.vertices.size(), global.greatest_spacing / global.radius);
  sizes.vertex_precision = rounding;
  sizes.offset_precision = std::min(1.0, ratio * ratio) * rounding;
  return sizes;
}

class GlobalStrategy {
 public:
  GlobalStrategy(const Complex& complex, const Features& features, const GlobalRule& rule, const Limits& limits, Progress& progress)
      : complex_(complex), rule_(rule), limits_(limits), progress_(progress), sizes_(global_sizes(features, rule)),
        zones_(complex, buffer_sizes(complex, features, sizes_, rule.rounding), BufferZones::Stage::ends), index_(complex.vertices) {
    spacing_.place = sizes_.greatest_spacing;
    spacing_.least = spacing_.place * rule.least_share;
    spacing_.reaches = rule.reaches;
  }

  Placement run() {
    index_new_points();
    if (const auto witness = find_crossing(zones_)) return refuted(*witness);
    choose_spacing();
    if (count_arcs() > tested_points && too_many(estimate())) refuse();
    zones_.divide_sectors(spacing_);
    index_new_points();
    if (auto placement = test_buffer_zones(false)) return *placement;
    if (count_arcs() + count_rows() > tested_points && too_many(estimate())) refuse();
    zones_.divide_rows(spacing_);
    index_new_points();
    if (auto placement = test_buffer_zones(true)) return *placement;
    test_hanging();
    if (!rule_.fill) {
      zones_.build_regions();
      Placement placement = zones_.result();
      std::erase_if(placement.cells, [](const PlacedCell& cell) { return cell.kind == CellKind::C; });
      describe(placement, {});
      return placement;
    }
    const double expected = estimate();
    progress_.estimated(expected);
    if (too_many(expected)) refuse();
    zones_.build_regions();
    refine();
    test_regions();
    Placement placement = zones_.result();
    describe(placement, rule_.claims);
    // Evidence belongs to a claim.
    if (std::find(rule_.claims.begin(), rule_.claims.end(), "L8") != rule_.claims.end()) placement.insertions = std::move(insertions_);
    return placement;
  }

 private:
  void index_new_points() {
    for (int id = static_cast<int>(index_.size()); id < zones_.point_count(); ++id) index_.insert(id, zones_.point(id).approximate());
    progress_.at("placing points", zones_.point_count());
    if (progress_.stop_requested(zones_.point_count())) throw LimitReached("stopped", zones_.point_count());
  }

  // h'' of the paper: what every arc, edge and protector can be divided by. The repaired h fits without.
  void choose_spacing() {
    if (rule_.fit) {
      for (const auto& sector : zones_.sectors_view()) {
        const double angle = sector.last - sector.first;
        if (!(angle > 0)) throw StrategyFailed(rule_.name + ": nothing is left between two protectors");
        spacing_.place = std::min(spacing_.place, 2 * sizes_.radius * std::sin(angle / 4));
      }
      for (const auto& row : zones_.rows_view()) spacing_.place = std::min(spacing_.place, length_of(row) / 2);
    }
    spacing_.least = spacing_.place * rule_.least_share;
  }

  double length_of(const BufferZones::Row& row) const {
    return length(approximate_difference(zones_.point(row.stations.back().point), zones_.point(row.stations.front().point)));
  }

  double count_arcs() const {
    double angles = 0;
    for (const auto& sector : zones_.sectors_view()) angles += sector.last - sector.first;
    return complex_.vertices.size() + angles / (2 * std::asin(spacing_.place / (2 * sizes_.radius)));
  }
  double count_rows() const {
    double count = 0;
    for (const auto& row : zones_.rows_view()) count += (1.0 + row.protectors.size()) * (1 + length_of(row) / spacing_.place);
    return count;
  }
  bool exceeds(double points) const { return limits_.max_points > 0 && points > static_cast<double>(limits_.max_points); }
  bool too_many(double points) const { return exceeds(points / estimate_margin); }

  double estimate() const {
    double area = 0;
    for (const Facet& facet : complex_.facets)
      for (const auto& [a, b, c] : facet.triangles)
        area += 0.5 * length(cross(approximate_difference(complex_.vertices[b], complex_.vertices[a]), approximate_difference(complex_.vertices[c], complex_.vertices[a])));
    for (const auto& row : zones_.rows_view()) area -= row.protectors.size() * length_of(row) * sizes_.offset;
    for (const auto& sector : zones_.sectors_view()) area -= 0.5 * sizes_.radius * sizes_.radius * (sector.last - sector.first);
    double boundary = count_arcs();
    for (const auto& row : zones_.rows_view()) boundary += row.protectors.size() * length_of(row) / spacing_.place;
    return count_arcs() + count_rows() + std::max(0.0, area / (area_per_point * spacing_.least * spacing_.least) - boundary / 2);
  }

  [[noreturn]] void refuse() const {
    progress_.estimated(estimate());
    throw LimitReached("max-points", zones_.point_count());
  }

  std::optional<Placement> test_buffer_zones(bool rectangles) {
    const auto encroached = find_encroached(zones_, index_, rectangles, progress_);
    if (encroached.empty()) return {};
    const auto witness = strongest_witness(zones_, index_, encroached);
    if (!witness) throw StrategyFailed(rule_.name + ": a point lies on a sphere of the buffer zones, or in one that no lemma speaks of");
    return refuted(*witness);
  }

  void test_hanging() const {
    for (const auto& row : zones_.rows_view())
      for (std::size_t i = 0; row.protectors.empty() && i + 1 < row.stations.size(); ++i) {
        const Point &a = zones_.point(row.stations[i].point), &b = zones_.point(row.stations[i + 1].point);
        const Ball ball = diametral_ball(a, b);
        const bool bad = index_.visit_ball(ball.centre, ball.radius, [&](int id) {
          const Point& p = zones_.point(id);
          return &p != &a && &p != &b && diametral_power(a, b, p) <= 0;
        });
        if (bad) throw StrategyFailed(rule_.name + ": a piece of a hanging segment is encroached");
      }
  }

  // Chew: circumcentres of triangles with R > (1 + eta) h. Facets know nothing of each other.
  class Environment : public RegionEnvironment {
   public:
    Environment(GlobalStrategy& owner, FacetId facet)
        : owner_(owner), rounding_{owner.zones_.frame(facet), owner.complex_.vertices[owner.complex_.facets[facet].frame[0]], reach(owner.complex_, facet)} {}
    bool encroached(const Point& a, const Point& b, const Point& c, bool, Ball&) override {
      Double3 offset;
      circumscribed_ball(a, b, c, &offset);
      return !(length(offset) <= (1 + owner_.rule_.eta) * owner_.spacing_.least * (1 - 0x1p-30));
    }
    Point circumcentre(const Point& a, const Point& b, const Point& c) override {
      Double3 offset;
      circumscribed_ball(a, b, c, &offset);
      owner_.placed_.fetch_add(1, std::memory_order_relaxed);
      return rounding_.round(a, offset, owner_.spacing_.least * owner_.rule_.eta / 8);
    }
    bool stopped() override {
      const long count = owner_.zones_.point_count() + owner_.placed_.load(std::memory_order_relaxed);
      return owner_.exceeds(count) || owner_.progress_.stop_requested(count);
    }
    bool boundary_gives_way() override { return false; }
    void inserted(const std::array<int, 3>& triangle, int vertex) override { insertions.emplace_back(triangle, vertex); }

    std::vector<std::pair<std::array<int, 3>, int>> insertions;

   private:
    static double reach(const Complex& complex, FacetId f) {
      const Facet& facet = complex.facets[f];
      double result = 0;
      for (const auto& [a, c] : facet.boundary)
        result = std::max(result, length(approximate_difference(complex.vertices[a], complex.vertices[facet.frame[0]])));
      return result;
    }
    GlobalStrategy& owner_;
    CircumcentreRounding rounding_;
  };

  template <class Work>
  void for_each_facet(Work work) {
    tbb::task_arena arena(std::max(1, limits_.threads));
    arena.execute([&] { tbb::parallel_for(0, static_cast<int>(complex_.facets.size()), work); });
  }

  void refine() {
    const int facets = static_cast<int>(complex_.facets.size());
    std::vector<Region::Refinement> refinements(facets);
    std::vector<Environment> environments;
    for (int f = 0; f < facets; ++f) environments.emplace_back(*this, f);
    for_each_facet([&](int f) { refinements[f] = zones_.region(f).refine(environments[f]); });
    for (int f = 0; f < facets; ++f) {
      zones_.adopt_new_vertices(f);
      if (refinements[f].stuck || !refinements[f].blocking.empty())
        throw StrategyFailed(rule_.name + ": a circumcentre lies in the buffer zone of its facet");
      for (const auto& [triangle, vertex] : environments[f].insertions) {
        std::array<int, 3> corners{};
        for (int i = 0; i < 3; ++i) corners[i] = zones_.point_of(f, triangle[i]);
        insertions_.push_back({f, corners, zones_.point_of(f, vertex)});
      }
    }
    index_new_points();
    const bool open = std::any_of(refinements.begin(), refinements.end(), [](const auto& refinement) { return refinement.open; });
    if (open || exceeds(zones_.point_count())) throw LimitReached("max-points", zones_.point_count());
  }

  // What the refined triangles and the buffer zones do to each other: proved for `repaired`, and tested for all.
  void test_regions() {
    std::atomic<bool> bad{false};
    for_each_facet([&](int f) {
      const Projection projection = projection_of(complex_.facets[f].normal);
      for (const auto& [x, y, z] : zones_.region(f).triangles()) {
        const Point &a = zones_.point(zones_.point_of(f, x)), &b = zones_.point(zones_.point_of(f, y)), &c = zones_.point(zones_.point_of(f, z));
        const Ball ball = circumscribed_ball(a, b, c);
        if (index_.visit_ball(ball.centre, ball.radius, [&](int id) {
              const Point& p = zones_.point(id);
              return &p != &a && &p != &b && &p != &c && encroaches(projection, a, b, c, p);
            }))
          bad = true;
      }
    });
    if (bad) throw StrategyFailed(rule_.name + ": the sphere of a refined triangle is not empty");
    if (!find_encroached(zones_, index_, true, progress_).empty())
      throw StrategyFailed(rule_.name + ": a refined triangle's corner lies in a sphere of the buffer zones");
  }

  Placement refuted(const Witness& witness) const {
    Placement placement = refuting_placement(zones_, witness);
    describe(placement, {"H-angle", "H-ball", "H-offset", "H-chord", "L1", "L21"});
    return placement;
  }

  void describe(Placement& placement, const std::vector<std::string>& claims) const {
    Parameters& parameters = placement.parameters;
    parameters.radius = mpq_class(std::ldexp(sizes_.radius, complex_.scale));
    parameters.spacing = mpq_class(std::ldexp(spacing_.least, complex_.scale));
    parameters.angle_multiple = rule_.angle_multiple;
    parameters.angle_cosine = sizes_.angle_cosine;
    (rule_.beta > 0 ? parameters.beta : parameters.offset) = rule_.beta > 0 ? rule_.beta : rule_.chord;
    parameters.chord = rule_.chord;
    placement.claims = claims;
  }

  const Complex& complex_;
  const GlobalRule& rule_;
  const Limits& limits_;
  Progress& progress_;
  const GlobalSizes sizes_;
  BufferZones zones_;
  PointIndex index_;
  Spacing spacing_;
  std::atomic<long> placed_{0};
  std::vector<Insertion> insertions_;
};

}  // namespace

Placement place_global(const Complex& complex, const Features& features, const GlobalRule& rule, const Limits& limits, Progress& progress) {
  GlobalStrategy strategy(complex, features, rule, limits, progress);
  return strategy.run();
}

}  // namespace confidel
