// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/planar/region.h"

#include <boost/test/unit_test.hpp>
#include <deque>
#include <random>

#include "tests/core/planar/region_model.h"

using namespace confidel;
using namespace confidel::test;

namespace {

using Generator = std::mt19937_64;

int integer(Generator& generator, int low, int high) {
  return low + static_cast<int>(generator() % static_cast<std::uint64_t>(high - low + 1));
}

const std::vector<Embedding> embeddings{{{1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {1, 0, 0}}, {{2, 1, -2}, {1, 2, 2}}, {{1, 2, 2}, {2, 1, -2}}, {{0, -1, 0}, {0, 0, 1}}};

Pair sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// A region, and the same domain in planar coordinates.
struct Domain {
  explicit Domain(const Embedding& chosen) : embedding(chosen), region(chosen.projection) {}

  const Embedding& embedding;
  std::vector<Planar> points;
  std::set<Pair> boundary;
  std::deque<Point> storage;
  Region region;

  int add(const Planar& p) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i] == p) return static_cast<int>(i);
    points.push_back(p);
    storage.push_back(embedding(p));
    const int id = region.insert(storage.back());
    BOOST_TEST(id == static_cast<int>(points.size()) - 1);
    return id;
  }

  void loop(const std::vector<Planar>& corners) {
    std::vector<int> ids;
    for (const Planar& p : corners) ids.push_back(add(p));
    for (std::size_t i = 0; i < ids.size(); ++i) boundary.insert(sorted(ids[i], ids[(i + 1) % ids.size()]));
  }

  void finish() {
    for (const auto& [a, b] : boundary) region.constrain(a, b);
    region.mark();
  }

  void check(std::size_t* ties = nullptr) const {
    const Reference reference(points, boundary);
    BOOST_TEST(region.vertex_count() == static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) BOOST_TEST((region.point(static_cast<int>(i)) == storage[i]));
    const auto triangles = region.triangles();
    BOOST_TEST(triangles.size() == region.triangle_count());
    BOOST_TEST(triangles.size() == reference.inner_faces());
    BOOST_TEST(reference.compare(triangles) == "");
    if (ties != nullptr) *ties += reference.ties();
  }

  /// Exact midpoint of two vertices, moved by a fraction of the edge's normal.
  Planar between(int a, int b, const mpq_class& t, const mpq_class& lift) const {
    const Planar &p = points[a], &q = points[b];
    return {p[0] + t * (q[0] - p[0]) - lift * (q[1] - p[1]), p[1] + t * (q[1] - p[1]) + lift * (q[0] - p[0])};
  }

  void split(const Pair& edge, const Planar& at) {
    storage.push_back(embedding(at));
    points.push_back(at);
    const int v = region.split(edge[0], edge[1], storage.back());
    BOOST_TEST(v == static_cast<int>(points.size()) - 1);
    boundary.erase(edge);
    boundary.insert(sorted(edge[0], v));
    boundary.insert(sorted(edge[1], v));
  }
};

/// A square with holes in cells of its own and vertices everywhere else; unit: the spacing of a grid that all coordinates are on.
void fill(Domain& domain, Generator& generator, int cells, int unit, int holes, int free_vertices) {
  const int side = 4 * cells * unit;
  domain.loop({{0, 0}, {side, 0}, {side, side}, {0, side}});
  std::set<Pair> taken;
  const auto coordinate = [&](int cell) { return mpq_class(4 * cell * unit + integer(generator, unit, 3 * unit) / 1); };
  for (int i = 0; i < holes; ++i) {
    const Pair cell{integer(generator, 0, cells - 1), integer(generator, 0, cells - 1)};
    if (!taken.insert(cell).second) continue;
    std::vector<Planar> corners;
    if (generator() % 2) {
      const mpq_class x = 4 * cell[0] * unit + unit, y = 4 * cell[1] * unit + unit, s = integer(generator, 1, 2 * unit);
      corners = {{x, y}, {x + s, y}, {x + s, y + s}, {x, y + s}};
    } else {
      for (int k = 0; k < 3; ++k) corners.push_back({coordinate(cell[0]), coordinate(cell[1])});
      const mpq_class area = (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) - (corners[2][0] - corners[0][0]) * (corners[1][1] - corners[0][1]);
      if (area == 0) continue;
    }
    domain.loop(corners);
  }
  for (int i = 0; i < free_vertices; ++i) {
    const Planar p{integer(generator, 1, side - 1), integer(generator, 1, side - 1)};
    if (!taken.count({static_cast<int>(p[0].get_d()) / (4 * unit), static_cast<int>(p[1].get_d()) / (4 * unit)})) domain.add(p);
  }
  domain.finish();
}

int side(const Planar& a, const Planar& b, const Planar& c) {
  return sgn(mpq_class((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

/// Nothing of the domain's vertices and boundary in the closed triangle a b p but the segment ab.
bool is_clear(const Domain& domain, const Pair& edge, const Planar& p) {
  const Planar &a = domain.points[edge[0]], &b = domain.points[edge[1]];
  const int turn = side(a, b, p);
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    if (static_cast<int>(i) == edge[0] || static_cast<int>(i) == edge[1]) continue;
    const Planar& x = domain.points[i];
    if (turn * side(a, b, x) >= 0 && turn * side(b, p, x) >= 0 && turn * side(p, a, x) >= 0) return false;
  }
  for (const Pair& other : domain.boundary)
    for (const int end : edge) {
      const Planar &q = domain.points[end], &c = domain.points[other[0]], &d = domain.points[other[1]];
      if (other == edge || other[0] == end || other[1] == end) continue;
      if (side(c, d, p) * side(c, d, q) <= 0 && side(p, q, c) * side(p, q, d) <= 0) return false;
    }
  return true;
}

/// The side of a boundary segment where the region is: +1 left of a -> b.
int inner_side(const Domain& domain, const Pair& edge) {
  for (const auto& [a, b, c] : domain.region.triangles())
    for (const Pair& directed : {Pair{a, b}, Pair{b, c}, Pair{c, a}}) {
      if (directed == edge) return 1;
      if (directed == Pair{edge[1], edge[0]}) return -1;
    }
  BOOST_FAIL("a boundary segment without a triangle inside");
  return 0;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(region)

BOOST_AUTO_TEST_CASE(random_domains) {
  Generator generator(1);
  for (int round = 0; round < 30; ++round) {
    Domain domain(embeddings[round % embeddings.size()]);
    fill(domain, generator, integer(generator, 1, 4), 1000, integer(generator, 0, 6), integer(generator, 0, 40));
    domain.check();
  }
}

BOOST_AUTO_TEST_CASE(grids_full_of_ties) {
  Generator generator(2);
  std::size_t ties = 0;
  for (int round = 0; round < 40; ++round) {
    Domain domain(embeddings[round % embeddings.size()]);
    fill(domain, generator, integer(generator, 1, 3), integer(generator, 1, 2), integer(generator, 0, 5), integer(generator, 10, 120));
    domain.check(&ties);
  }
  BOOST_TEST(ties > 100);
}

BOOST_AUTO_TEST_CASE(nested_loops) {
  // An island in a hole in a square: even-odd.
  Domain domain(embeddings[2]);
  const auto square = [](int low, int high) { return std::vector<Planar>{{low, low}, {high, low}, {high, high}, {low, high}}; };
  domain.loop(square(0, 12));
  domain.loop(square(2, 10));
  domain.loop(square(4, 8));
  domain.finish();
  domain.check();
  mpq_class area = 0;
  for (const auto& [a, b, c] : domain.region.triangles()) {
    const Planar &p = domain.points[a], &q = domain.points[b], &r = domain.points[c];
    area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }
  BOOST_TEST((area == 144 - 64 + 16));
}

BOOST_AUTO_TEST_CASE(splits_on_and_off_the_boundary) {
  Generator generator(3);
  int on = 0, off = 0;
  for (int round = 0; round < 25; ++round) {
    Domain domain(embeddings[round % embeddings.size()]);
    fill(domain, generator, integer(generator, 1, 3), generator() % 2 ? 1 : 64, integer(generator, 0, 5), integer(generator, 0, 30));
    for (int step = 0; step < 15; ++step) {
      auto place = domain.boundary.begin();
      std::advance(place, generator() % domain.boundary.size());
      const Pair edge = *place;
      const mpq_class t(integer(generator, 1, 7), 8);
      if (generator() % 2) {
        domain.split(edge, domain.between(edge[0], edge[1], t, 0));
        ++on;
      } else {
        // In front of the middle, within the diametral disk, as a point of an arc over its chord.
        const mpq_class lift = inner_side(domain, edge) * mpq_class(1, 1 << integer(generator, 2, 6));
        const Planar p = domain.between(edge[0], edge[1], {1, 2}, lift);
        if (!is_clear(domain, edge, p)) continue;
        domain.split(edge, p);
        ++off;
      }
      if (step % 3 == 0) domain.check();
    }
    domain.check();
  }
  BOOST_TEST(on > 100);
  BOOST_TEST(off > 50);
}

BOOST_AUTO_TEST_CASE(split_of_what_is_no_boundary) {
  Domain domain(embeddings[0]);
  domain.loop({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  domain.finish();
  const Point outside = domain.embedding({2, -1});
  BOOST_CHECK_THROW(domain.region.split(0, 1, outside), std::logic_error);
}

BOOST_AUTO_TEST_CASE(encroached_boundary) {
  Generator generator(4);
  std::size_t found = 0;
  for (int round = 0; round < 40; ++round) {
    Domain domain(embeddings[round % embeddings.size()]);
    const int holes = round % 2 ? 0 : 4;
    fill(domain, generator, integer(generator, 1, 3), generator() % 2 ? 2 : 500, holes, integer(generator, 0, 30));
    const Reference reference(domain.points, domain.boundary);
    const auto result = domain.region.encroached_boundary();
    found += result.size();
    std::vector<Pair> by_all_vertices;
    for (const auto& [a, b] : domain.boundary)
      for (std::size_t c = 0; c < domain.points.size(); ++c)
        if (reference.in_disk(a, b, static_cast<int>(c))) {
          by_all_vertices.push_back({a, b});
          break;
        }
    BOOST_TEST((result == reference.encroached()));
    BOOST_TEST(std::includes(by_all_vertices.begin(), by_all_vertices.end(), result.begin(), result.end()));
    // Without holes every vertex is visible.
    if (holes == 0) BOOST_TEST((result == by_all_vertices));
  }
  BOOST_TEST(found > 50);
}

namespace {

/// Triangles with a circumradius above a bound are encroached; circumcentres are rounded to multiples of 1/2^20 of the frame.
class SizeBound : public RegionEnvironment {
 public:
  SizeBound(const Embedding& embedding, const mpq_class& square, int stop_after = -1) : embedding_(embedding), square_(square), stop_after_(stop_after) {}

  static Rational3 centre(const Point& a, const Point& b, const Point& c) {
    const Rational3 p = rational(a), u = minus(rational(b), p), w = minus(rational(c), p), n = times(u, w);
    return plus(p, scaled(1 / (2 * squared(n)), plus(scaled(squared(u), times(w, n)), scaled(squared(w), times(n, u)))));
  }
  bool encroached(const Point& a, const Point& b, const Point& c, bool only_new, Ball&) override {
    return !only_new && squared(minus(centre(a, b, c), rational(a))) > square_;
  }
  Point circumcentre(const Point& a, const Point& b, const Point& c) override {
    const Rational3 z = centre(a, b, c), u = rational(embedding_.u), v = rational(embedding_.v);
    Planar p;
    p[0] = scalar(z, u) / squared(u) * (1 << 20);
    p[1] = scalar(z, v) / squared(v) * (1 << 20);
    for (auto& x : p) x = mpq_class(x.get_num() / x.get_den()) / (1 << 20);
    --stop_after_;
    return embedding_(p);
  }
  bool stopped() override { return stop_after_ == 0; }

 private:
  const Embedding& embedding_;
  mpq_class square_;
  int stop_after_;
};

void adopt(Domain& domain, const Region::Refinement& refinement) {
  const int before = static_cast<int>(domain.points.size());
  BOOST_TEST(domain.region.vertex_count() == before + refinement.inserted);
  const Rational3 u = rational(domain.embedding.u), v = rational(domain.embedding.v);
  for (int i = before; i < domain.region.vertex_count(); ++i) {
    const Rational3 p = rational(domain.region.point(i));
    domain.points.push_back({scalar(p, u) / squared(u), scalar(p, v) / squared(v)});
    domain.storage.push_back(domain.region.point(i));
    BOOST_TEST((domain.embedding(domain.points.back()) == domain.storage.back()));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(refinement) {
  Generator generator(5);
  for (int round = 0; round < 12; ++round) {
    Domain domain(embeddings[round % embeddings.size()]);
    fill(domain, generator, integer(generator, 1, 2), 64, integer(generator, 0, 2), integer(generator, 0, 6));
    const mpq_class bound = 48 * 48 * squared(rational(domain.embedding.u));
    SizeBound environment(domain.embedding, bound);
    int turns = 0;
    for (;; ++turns) {
      BOOST_REQUIRE(turns < 60);
      const Region::Refinement result = domain.region.refine(environment);
      BOOST_REQUIRE(!result.stuck);
      BOOST_TEST(!result.open);
      adopt(domain, result);
      std::set<Pair> split(result.blocking.begin(), result.blocking.end());
      BOOST_TEST(split.size() == result.blocking.size());
      if (split.empty() && result.inserted == 0) {
        const auto encroached = domain.region.encroached_boundary();
        split.insert(encroached.begin(), encroached.end());
      }
      for (const Pair& edge : split) {
        BOOST_REQUIRE(domain.boundary.count(edge));
        domain.split(edge, domain.between(edge[0], edge[1], {1, 2}, 0));
      }
      if (split.empty() && result.inserted == 0) break;
    }
    domain.check();
    for (const auto& [a, b, c] : domain.region.triangles()) {
      Ball ball;
      BOOST_TEST(!environment.encroached(domain.storage[a], domain.storage[b], domain.storage[c], false, ball));
    }
    BOOST_TEST(domain.points.size() > 20);
  }
}

BOOST_AUTO_TEST_CASE(refinement_stops_when_told) {
  Domain domain(embeddings[0]);
  domain.loop({{0, 0}, {64, 0}, {64, 64}, {0, 64}});
  domain.add({31, 30});
  domain.add({7, 40});
  domain.finish();
  SizeBound environment(domain.embedding, 4, 3);
  const auto result = domain.region.refine(environment);
  BOOST_TEST(result.open);
  BOOST_TEST(result.inserted <= 3);
  adopt(domain, result);
  domain.check();
  // It can be taken up again.
  SizeBound patient(domain.embedding, 400);
  BOOST_TEST(!domain.region.refine(patient).open);
}

// A triangle that is free is asked about again only if its ball is not known, or something new is near it.
BOOST_AUTO_TEST_CASE(free_triangles_are_asked_about_their_ball_only) {
  class Counting : public SizeBound {
   public:
    using SizeBound::SizeBound;
    bool encroached(const Point& a, const Point& b, const Point& c, bool only_new, Ball& ball) override {
      ++asked;
      if (known) ball = {a.approximate(), 1};
      return SizeBound::encroached(a, b, c, only_new, ball);
    }
    bool near_new_point(const Ball& ball) override {
      ++looked;
      BOOST_TEST(ball.radius == 1);
      return something_new;
    }
    bool known = false, something_new = false;
    int asked = 0, looked = 0;
  };
  Domain domain(embeddings[0]);
  domain.loop({{0, 0}, {64, 0}, {64, 64}, {0, 64}});
  domain.add({31, 30});
  domain.finish();
  const int triangles = static_cast<int>(domain.region.triangles().size());
  Counting environment(domain.embedding, 1000000);
  const auto counts = [&] {
    environment.asked = environment.looked = 0;
    BOOST_TEST(domain.region.refine(environment).inserted == 0);
    return std::pair(environment.asked, environment.looked);
  };
  BOOST_TEST((counts() == std::pair(triangles, 0)));
  environment.known = true;
  BOOST_TEST((counts() == std::pair(triangles, 0)));
  BOOST_TEST((counts() == std::pair(0, triangles)));
  environment.something_new = true;
  BOOST_TEST((counts() == std::pair(triangles, triangles)));
}

BOOST_AUTO_TEST_SUITE_END()
