// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/shrink.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "campaigns/instance.h"

namespace confidel::campaigns {

namespace {

/// How much there is to write down of a double: the bits of its mantissa and of its exponent. Zero is nothing.
std::size_t bits_of(double value) {
  if (value == 0) return 0;
  int exponent = 0;
  double mantissa = std::abs(std::frexp(value, &exponent));
  std::size_t bits = 0;
  while (mantissa != 0) {
    mantissa = 2 * mantissa - std::floor(2 * mantissa);
    ++bits;
  }
  // 2^0, 2^1, ... are simpler than 2^-1: integers first.
  const int lowest = exponent - static_cast<int>(bits);
  return 2 * bits + static_cast<std::size_t>(lowest < 0 ? -3 * lowest : lowest) + (value < 0 ? 1 : 0);
}

class Shrinker {
 public:
  Shrinker(Input input, const Shrinking& shrinking) : best_(std::move(input)), shrinking_(shrinking), size_(measure(best_)) {}

  Input run() {
    for (InputFacet& facet : best_.facets) facet.marker = 0;
    if (!good(best_)) throw std::invalid_argument("the input does not do what is to be kept, without its markers");
    for (bool again = true; again && !shrinking_.stop();) {
      again = remove_many<&Input::facets>();
      again = remove_many<&Input::segments>() || again;
      again = remove_polygons() || again;
      again = remove_corners() || again;
      if (best_.dimension == 2) again = remove_vertices() || again;
      again = merge_vertices() || again;
      again = simplify_coordinates() || again;
    }
    return best_;
  }

 private:
  bool good(const Input& candidate) const {
    try {
      suffix_for(candidate);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return is_valid(candidate) && shrinking_.keeps(candidate);
  }

  bool accept(Input candidate) {
    candidate = without_unused_vertices(candidate);
    const Measure size = measure(candidate);
    if (size >= size_ || shrinking_.stop() || !good(candidate)) return false;
    best_ = std::move(candidate);
    size_ = size;
    return true;
  }

  /// Halves, quarters, ... single ones.
  template <auto Member>
  bool remove_many() {
    bool progress = false;
    for (std::size_t chunk = std::max<std::size_t>(1, (best_.*Member).size() / 2);; chunk /= 2) {
      for (std::size_t first = 0; first < (best_.*Member).size() && !shrinking_.stop();) {
        Input candidate = best_;
        auto& items = candidate.*Member;
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(first), items.begin() + static_cast<std::ptrdiff_t>(std::min(first + chunk, items.size())));
        if (accept(std::move(candidate))) progress = true;
        else first += chunk;
      }
      if (chunk <= 1) return progress;
    }
  }

  bool remove_polygons() {
    bool progress = false;
    for (std::size_t f = 0; f < best_.facets.size(); ++f)
      for (std::size_t p = 0; p < best_.facets[f].polygons.size();) {
        Input candidate = best_;
        InputFacet& facet = candidate.facets[f];
        facet.polygons.erase(facet.polygons.begin() + static_cast<std::ptrdiff_t>(p));
        // With the hole's loop its point has to go; which one it was, only a trial tells.
        bool accepted = !facet.polygons.empty() && accept(candidate);
        for (std::size_t h = 0; h < best_.facets[f].holes.size() && !accepted && !facet.polygons.empty(); ++h) {
          Input without_hole = candidate;
          auto& holes = without_hole.facets[f].holes;
          holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(h));
          accepted = accept(std::move(without_hole));
        }
        if (accepted) progress = true;
        else ++p;
      }
    return progress;
  }

  bool remove_corners() {
    bool progress = false;
    for (std::size_t f = 0; f < best_.facets.size(); ++f)
      for (std::size_t p = 0; p < best_.facets[f].polygons.size(); ++p)
        for (std::size_t c = 0; c < best_.facets[f].polygons[p].corners.size();) {
          Input candidate = best_;
          auto& corners = candidate.facets[f].polygons[p].corners;
          corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(c));
          if (!corners.empty() && accept(std::move(candidate))) progress = true;
          else ++c;
        }
    return progress;
  }

  /// In dimension 2: with the segments that end there.
  bool remove_vertices() {
    bool progress = false;
    for (std::size_t v = 0; v < best_.vertices.size();) {
      Input candidate = best_;
      const int gone = static_cast<int>(v);
      candidate.vertices.erase(candidate.vertices.begin() + gone);
      auto& segments = candidate.segments;
      segments.erase(std::remove_if(segments.begin(), segments.end(), [gone](const InputSegment& s) { return s.ends[0] == gone || s.ends[1] == gone; }), segments.end());
      for (InputSegment& segment : segments)
        for (int& end : segment.ends)
          if (end > gone) --end;
      if (accept(std::move(candidate))) progress = true;
      else ++v;
    }
    return progress;
  }

  /// A vertex takes another one's place: facets come to share it.
  bool merge_vertices() {
    bool progress = false;
    if (best_.dimension == 2) return false;
    for (std::size_t v = 0; v < best_.vertices.size(); ++v)
      for (std::size_t w = 0; w < best_.vertices.size() && v < best_.vertices.size() && !shrinking_.stop(); ++w) {
        if (v == w) continue;
        Input candidate = best_;
        const auto replace = [&](int& vertex) {
          if (vertex == static_cast<int>(v)) vertex = static_cast<int>(w);
        };
        for (InputFacet& facet : candidate.facets)
          for (InputPolygon& polygon : facet.polygons) std::for_each(polygon.corners.begin(), polygon.corners.end(), replace);
        for (InputSegment& segment : candidate.segments) std::for_each(segment.ends.begin(), segment.ends.end(), replace);
        if (accept(std::move(candidate))) progress = true;
      }
    return progress;
  }

  bool simplify_coordinates() {
    bool progress = false;
    // All at once first, then one by one.
    for (const int bits : {2, 3, 4, 5, 6, 8, 12, 16, 24, 32}) {
      Input candidate = best_;
      double greatest = 0;
      for (const InputVertex& vertex : best_.vertices)
        for (const double x : vertex.position) greatest = std::max(greatest, std::abs(x));
      int exponent = 0;
      std::frexp(greatest, &exponent);
      for (InputVertex& vertex : candidate.vertices)
        for (double& x : vertex.position) x = std::nearbyint(std::ldexp(x, bits - exponent)) + 0.0;  // integers below 2^bits
      for (InputFacet& facet : candidate.facets)
        for (Position& hole : facet.holes)
          for (double& x : hole) x = std::ldexp(x, bits - exponent);
      if (accept(std::move(candidate))) {
        progress = true;
        break;
      }
    }
    for (std::size_t v = 0; v < best_.vertices.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double x : simpler(best_.vertices[v].position[axis])) {
          if (shrinking_.stop()) return progress;
          Input candidate = best_;
          candidate.vertices[v].position[axis] = x + 0.0;
          if (accept(std::move(candidate))) {
            progress = true;
            break;
          }
        }
    return progress;
  }

  static std::vector<double> simpler(double x) {
    std::vector<double> result;
    int exponent = 0;
    std::frexp(x, &exponent);
    const auto add = [&](double y) {
      if (!std::isfinite(y)) return;  // a unit below the smallest double
      if (bits_of(y) < bits_of(x) && std::find(result.begin(), result.end(), y) == result.end()) result.push_back(y);
    };
    add(0);
    for (const int bits : {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 40}) {
      const double unit = std::ldexp(1.0, exponent - bits);
      add(std::nearbyint(x / unit) * unit);
      add(std::floor(x / unit) * unit);
      add(std::ceil(x / unit) * unit);
    }
    add(std::abs(x));
    return result;
  }

  Input best_;
  const Shrinking& shrinking_;
  Measure size_;
};

}  // namespace

Measure measure(const Input& input) {
  Measure size{input.facets.size() + input.segments.size(), 0, input.vertices.size(), 0};
  for (const InputFacet& facet : input.facets) {
    size[1] += facet.holes.size();
    for (const InputPolygon& polygon : facet.polygons) size[1] += 1 + polygon.corners.size();
  }
  for (const InputVertex& vertex : input.vertices)
    for (const double coordinate : vertex.position) size[3] += bits_of(coordinate);
  return size;
}

Input shrink(Input input, const Shrinking& shrinking) { return Shrinker(std::move(input), shrinking).run(); }

}  // namespace confidel::campaigns
