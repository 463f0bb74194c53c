// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/estimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/features/bounding_volumes.h"

namespace confidel {
namespace {

// docs/results.md shows the estimate beside the result.
constexpr double points_per_row_unit = 0.3;
constexpr double points_per_facet_unit = 0.2;
constexpr int descents = 600;
constexpr int greatest_depth = 60;
constexpr double tiny = 1e-30;
constexpr double far = 4;  // beyond everything in working coordinates

using Triangle = std::array<Double3, 3>;

double distance_to_segment(const Double3& p, const Double3& a, const Double3& b) {
  const Double3 u = b - a, w = p - a;
  const double square = dot(u, u);
  const double t = square > 0 ? std::clamp(dot(w, u) / square, 0.0, 1.0) : 0.0;
  return length(w - t * u);
}

double distance_to_triangle(const Double3& p, const Triangle& t) {
  const Double3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double size = length(n);
  bool above = size > 0;
  for (int i = 0; i < 3 && above; ++i) above = dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), n) >= 0;
  if (above) return std::abs(dot(p - t[0], n)) / size;
  return std::min({distance_to_segment(p, t[0], t[1]), distance_to_segment(p, t[1], t[2]), distance_to_segment(p, t[2], t[0])});
}

// A name per plane: coplanar facets do not encroach each other.
std::vector<int> planes_of(const Complex& complex) {
  std::map<std::array<std::string, 4>, int> names;
  std::vector<int> planes;
  for (const Facet& facet : complex.facets) {
    IntegerVector normal = facet.normal;
    int sign = 0;
    for (int axis = 0; axis < 3 && sign == 0; ++axis) sign = sgn(normal[axis]);
    if (sign < 0)
      for (auto& value : normal) value = -value;
    const Point& base = complex.vertices[facet.frame[0]];
    const mpz_class level = dot(normal, {base.numerator(0), base.numerator(1), base.numerator(2)});
    const mpq_class place = times_power_of_two(level, -base.exponent());
    planes.push_back(names.try_emplace({normal[0].get_str(36), normal[1].get_str(36), normal[2].get_str(36), place.get_str(36)},
                                       static_cast<int>(names.size())).first->second);
  }
  return planes;
}

class Surroundings {
 public:
  explicit Surroundings(const Complex& complex)
      : planes_(planes_of(complex)), facets_of_(complex.segments.size()),
        segments_of_(complex.facets.size()), blunt_(complex.facets.size()) {
    std::vector<Box> boxes;
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      for (const auto& [a, b, c] : complex.facets[f].triangles) add(complex, a, b, c, {planes_[f], static_cast<int>(f), -1}, boxes);
      for (const auto* edges : {&complex.facets[f].boundary, &complex.facets[f].constraints})
        for (const auto& [a, b] : *edges) {
          const SegmentId segment = complex.find_segment(a, b);
          facets_of_[segment].push_back(static_cast<int>(f));
          segments_of_[f].push_back(segment);
        }
      std::sort(segments_of_[f].begin(), segments_of_[f].end());
    }
    for (std::size_t s = 0; s < complex.segments.size(); ++s) {
      const auto [a, b] = complex.segments[s];
      // A segment of facets matters in its own planes only: label -2 keeps it out of the other kind of search.
      add(complex, a, b, b, {facets_of_[s].empty() ? -1 : -2, -1, static_cast<int>(s)}, boxes);
    }
    tree_ = BoundingVolumes(boxes, labels_);
    find_blunt_neighbours(complex);
  }

  double off_plane(const Double3& x, FacetId facet) const {
    const int plane = planes_[facet];
    const auto& blunt = blunt_[facet];
    return search(x, [plane, &blunt](const Labels& labels) {
      return labels[0] == plane || labels[0] == -2 || (labels[1] >= 0 && std::binary_search(blunt.begin(), blunt.end(), labels[1]));
    });
  }

  SegmentId nearest_own_segment(const Double3& x, FacetId facet) const {
    Box box;
    box.lower = box.upper = x;
    const auto& own = segments_of_[facet];
    SegmentId nearest = -1;
    tree_.search(
        Probe(box), far, [](const Labels& labels) { return labels[0] != -2 && labels[2] == -1 && labels[0] >= 0; },
        [&](int item, double limit) {
          const int segment = labels_[item][2];
          if (segment < 0 || !std::binary_search(own.begin(), own.end(), segment)) return limit;
          const double distance = distance_to_triangle(x, items_[item]);
          if (distance < limit) nearest = segment;
          return std::min(limit, distance);
        });
    return nearest;
  }

  double off_segment(const Double3& x, SegmentId segment) const {
    const auto& own = facets_of_[segment];
    return search(x, [&](const Labels& labels) {
      return labels[2] == segment || (labels[1] >= 0 && std::find(own.begin(), own.end(), labels[1]) != own.end());
    });
  }

 private:
  void add(const Complex& complex, VertexId a, VertexId b, VertexId c, const Labels& labels, std::vector<Box>& boxes) {
    const Triangle t{complex.vertices[a].approximate(), complex.vertices[b].approximate(), complex.vertices[c].approximate()};
    Box box;
    for (const Double3& p : t)
      for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], p[axis]);
        box.upper[axis] = std::max(box.upper[axis], p[axis]);
      }
    items_.push_back(t);
    boxes.push_back(box);
    labels_.push_back(labels);
  }

  // Sheets that meet at 60 degrees or more do not encroach each other near their edge: the rows are aligned.
  void find_blunt_neighbours(const Complex& complex) {
    struct Sheet {
      int facet;
      Double3 inward;
    };
    std::vector<std::vector<Sheet>> sheets(complex.segments.size());
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      const Facet& facet = complex.facets[f];
      const Double3 normal = unit_vector(facet.normal);
      const auto inward = [&](VertexId a, VertexId b) {
        return cross(normal, unit_vector(direction(complex.vertices[a], complex.vertices[b])));
      };
      for (const auto& [a, b] : facet.boundary) sheets[complex.find_segment(a, b)].push_back({static_cast<int>(f), inward(a, b)});
      for (const auto& [a, b] : facet.constraints) {
        sheets[complex.find_segment(a, b)].push_back({static_cast<int>(f), inward(a, b)});
        sheets[complex.find_segment(a, b)].push_back({static_cast<int>(f), inward(b, a)});
      }
    }
    std::vector<std::vector<int>> sharp(complex.facets.size());
    for (const auto& list : sheets)
      for (const Sheet& one : list)
        for (const Sheet& other : list)
          if (one.facet != other.facet) (dot(one.inward, other.inward) <= 0.5 ? blunt_ : sharp)[one.facet].push_back(other.facet);
    for (std::size_t f = 0; f < blunt_.size(); ++f) {
      // Two facets may share several edges: the sharpest counts.
      std::erase_if(blunt_[f], [&](int g) { return std::find(sharp[f].begin(), sharp[f].end(), g) != sharp[f].end(); });
      std::sort(blunt_[f].begin(), blunt_[f].end());
    }
  }

  template <class Excluded>
  double search(const Double3& x, Excluded excluded) const {
    Box box;
    box.lower = box.upper = x;
    return tree_.search(Probe(box), far, excluded,
                        [&](int item, double limit) { return std::min(limit, distance_to_triangle(x, items_[item])); });
  }

  std::vector<int> planes_;
  std::vector<std::vector<int>> facets_of_, segments_of_, blunt_;
  std::vector<Triangle> items_;
  std::vector<Labels> labels_;
  BoundingVolumes tree_{{}};
};

// Estimates the integral of a density over pieces. Piece: mass() (its size times the density at its middle, clamped), small() and
// children(). Descends at random towards what weighs most, and divides by the probability of having come there.
template <class Piece>
double integrate(const std::vector<Piece>& roots) {
  std::mt19937_64 engine(20261122);  // a sequence that the standard specifies
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<double> sums;
  double total = 0;
  for (const Piece& root : roots) sums.push_back(total += root.mass);
  if (total <= 0) return 0;
  double result = 0;
  const double start = uniform();
  for (int k = 0; k < descents; ++k) {
    const std::size_t index =
        std::min<std::size_t>(std::lower_bound(sums.begin(), sums.end(), (k + start) / descents * total) - sums.begin(), roots.size() - 1);
    double probability = roots[index].mass / total;
    if (probability <= 0) continue;
    Piece piece = roots[index];
    for (int depth = 0; depth < greatest_depth && !piece.small; ++depth) {
      const auto children = piece.children();
      double all = 0;
      for (const Piece& child : children) all += child.mass;
      double draw = uniform() * all;
      std::size_t chosen = 0;
      while (chosen + 1 < children.size() && draw >= children[chosen].mass) draw -= children[chosen++].mass;
      probability *= children[chosen].mass / all;
      piece = children[chosen];
    }
    result += piece.mass / probability;
  }
  return result / descents;
}

struct Context {
  const Complex& complex;
  const BufferSizes& sizes;
  const Surroundings& surroundings;
};

struct RowPiece {
  const Context* context;
  SegmentId segment;
  double weight;
  Double3 a, b;
  double mass = 0;
  bool small = false;

  void weigh() {
    const double size = length(b - a), g = std::max(context->surroundings.off_segment(0.5 * (a + b), segment), tiny);
    mass = weight * size / g;
    small = size <= g;
  }
  std::array<RowPiece, 2> children() const {
    std::array<RowPiece, 2> result{*this, *this};
    result[0].b = result[1].a = 0.5 * (a + b);
    for (RowPiece& child : result) child.weigh();
    return result;
  }
};

struct FacetPiece {
  const Context* context;
  FacetId facet;
  Triangle t;
  double mass = 0;
  bool small = false;

  void weigh() {
    const Double3 x = (1.0 / 3) * (t[0] + t[1] + t[2]);
    if (context->complex.facets.size() < 2) {  // nothing is off the only plane but hanging segments
      small = true;
      return;
    }
    double distance = context->surroundings.off_plane(x, facet);
    if (const SegmentId nearest = context->surroundings.nearest_own_segment(x, facet); nearest >= 0) {
      const auto [a, b] = context->complex.segments[nearest];
      const Double3 p = context->complex.vertices[a].approximate(), q = context->complex.vertices[b].approximate();
      // Inside a strip of width d the density is that at its rim; inside a ball likewise.
      distance *= std::max({1.0, context->sizes.offset[nearest] / std::max(distance_to_segment(x, p, q), tiny),
                            context->sizes.radius[a] / std::max(length(x - p), tiny), context->sizes.radius[b] / std::max(length(x - q), tiny)});
    }
    distance = std::max(distance, tiny);
    const double area = 0.5 * length(cross(t[1] - t[0], t[2] - t[0]));
    mass = area / (distance * distance);
    small = std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])}) <= distance;
  }
  std::array<FacetPiece, 4> children() const {
    const Double3 m[3] = {0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]), 0.5 * (t[0] + t[1])};
    const Triangle parts[4] = {{t[0], m[2], m[1]}, {m[2], t[1], m[0]}, {m[1], m[0], t[2]}, {m[0], m[1], m[2]}};
    std::array<FacetPiece, 4> result{*this, *this, *this, *this};
    for (int i = 0; i < 4; ++i) {
      result[i].t = parts[i];
      result[i].weigh();
    }
    return result;
  }
};

}  // namespace

double estimate_further_points(const Complex& complex, const BufferSizes& sizes, const std::vector<OpenInterval>& intervals) {
  const Surroundings surroundings(complex);
  const Context context{complex, sizes, surroundings};
  std::vector<RowPiece> rows;
  for (const OpenInterval& open : intervals) {
    rows.push_back({&context, open.segment, static_cast<double>(open.rows), open.first, open.second});
    rows.back().weigh();
  }
  std::vector<FacetPiece> facets;
  for (std::size_t f = 0; f < complex.facets.size(); ++f)
    for (const auto& [a, b, c] : complex.facets[f].triangles) {
      facets.push_back({&context, static_cast<FacetId>(f),
                        {complex.vertices[a].approximate(), complex.vertices[b].approximate(), complex.vertices[c].approximate()}});
      facets.back().weigh();
    }
  return points_per_row_unit * integrate(rows) + points_per_facet_unit * integrate(facets);
}

}  // namespace confidel
