// SPDX-License-Identifier: GPL-3.0-or-later
// A small reader of the canonical complex, written from docs/certificate-format.md section 2, and the section's rules
// in rationals.
#pragma once

#include <gmpxx.h>

#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace confidel::test {

using Rational3 = std::array<mpq_class, 3>;
using Pair = std::array<int, 2>;

inline Rational3 minus(const Rational3& a, const Rational3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Rational3 times(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class scalar(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct CanonicalFacet {
  std::array<int, 3> frame{};
  std::vector<Pair> boundary, constraints;
  std::vector<int> isolated;
};

struct CanonicalComplex {
  int dimension = 0;
  std::vector<Rational3> vertices;
  std::vector<Pair> segments;
  std::vector<CanonicalFacet> facets;
};

inline void require(bool holds, const std::string& rule) {
  if (!holds) throw std::runtime_error("canonical complex: " + rule);
}

class CanonicalReader {
 public:
  explicit CanonicalReader(const std::string& text) {
    require(!text.empty() && text.back() == '\n', "ends with LF");
    std::string line;
    for (const char c : text) {
      if (c == '\n')
        lines_.push_back(line), line.clear();
      else
        line += c;
    }
  }

  CanonicalComplex read() {
    CanonicalComplex complex;
    require(next() == std::vector<std::string>{"plc", "1"}, "begins with plc 1");
    complex.dimension = announced("dim");
    const int vertices = announced("vertices");
    for (int i = 0; i < vertices; ++i) complex.vertices.push_back(point(complex.dimension));
    const int segments = announced("segments");
    for (int i = 0; i < segments; ++i) complex.segments.push_back(pair("s"));
    const int facets = announced("facets");
    for (int i = 0; i < facets; ++i) complex.facets.push_back(facet());
    require(next() == std::vector<std::string>{"end"} && position_ == lines_.size(), "end is the end");
    return complex;
  }

 private:
  std::vector<std::string> next() {
    require(position_ < lines_.size(), "is complete");
    std::vector<std::string> fields;
    const std::string& line = lines_[position_++];
    std::istringstream stream(line);
    for (std::string field; stream >> field;) fields.push_back(field);
    std::string again;
    for (const auto& field : fields) again += (again.empty() ? "" : " ") + field;
    require(again == line, "has single spaces: " + line);
    return fields;
  }

  static int index(const std::string& field) {
    const int value = std::stoi(field);
    require(std::to_string(value) == field && value >= 0, "an index is decimal: " + field);
    return value;
  }

  int announced(const std::string& word) {
    const auto fields = next();
    require(fields.size() == 2 && fields[0] == word, "has " + word);
    return index(fields[1]);
  }

  Rational3 point(int dimension) {
    const auto fields = next();
    require(static_cast<int>(fields.size()) == dimension + 2 && fields[0] == "v", "has a vertex");
    std::vector<mpz_class> values;
    mpz_class divisor = 0;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      values.emplace_back(fields[i], 16);
      require(values.back().get_str(16) == fields[i], "an integer is lower-case hexadecimal: " + fields[i]);
      divisor = gcd(divisor, values.back());
    }
    require(values.back() > 0 && divisor == 1, "W > 0 and the gcd is 1");
    Rational3 result;
    for (int axis = 0; axis < dimension; ++axis) {
      result[axis] = mpq_class(values[axis], values.back());
      result[axis].canonicalize();
    }
    return result;
  }

  Pair pair(const std::string& word) {
    const auto fields = next();
    if (word.empty()) {
      require(fields.size() == 2, "has a pair");
      return {index(fields[0]), index(fields[1])};
    }
    require(fields.size() == 3 && fields[0] == word, "has " + word);
    return {index(fields[1]), index(fields[2])};
  }

  CanonicalFacet facet() {
    CanonicalFacet result;
    const auto fields = next();
    require(fields.size() == 4 && fields[0] == "f", "has a facet");
    for (int i = 0; i < 3; ++i) result.frame[i] = index(fields[i + 1]);
    const int boundary = announced("b");
    for (int i = 0; i < boundary; ++i) result.boundary.push_back(pair(""));
    const int constraints = announced("c");
    for (int i = 0; i < constraints; ++i) result.constraints.push_back(pair(""));
    const int isolated = announced("p");
    for (int i = 0; i < isolated; ++i) {
      const auto line = next();
      require(line.size() == 1, "has an isolated vertex");
      result.isolated.push_back(index(line[0]));
    }
    return result;
  }

  std::vector<std::string> lines_;
  std::size_t position_ = 0;
};

template <typename Element>
bool is_increasing(const std::vector<Element>& elements) {
  for (std::size_t i = 1; i < elements.size(); ++i)
    if (!(elements[i - 1] < elements[i])) return false;
  return true;
}

inline Rational3 facet_normal(const CanonicalComplex& complex, const CanonicalFacet& facet) {
  const Rational3& origin = complex.vertices[facet.frame[0]];
  return times(minus(complex.vertices[facet.frame[1]], origin), minus(complex.vertices[facet.frame[2]], origin));
}

/// The rules of section 2. Throws with the rule that fails.
inline void require_rules(const CanonicalComplex& complex) {
  const int count = static_cast<int>(complex.vertices.size());
  for (const auto& [a, b] : complex.segments) require(a < b && a >= 0 && b < count, "segment ends");
  require(is_increasing(complex.segments), "segments increase");
  const std::set<Pair> segments(complex.segments.begin(), complex.segments.end());
  require(complex.dimension == 3 || complex.facets.size() <= 1, "dimension 2 has at most one facet");
  for (const CanonicalFacet& facet : complex.facets) {
    require(facet.boundary.size() >= 3, "at least three boundary edges");
    require(is_increasing(facet.boundary) && is_increasing(facet.constraints) && is_increasing(facet.isolated),
            "sorted");
    std::set<Pair> edges;
    std::set<int> on_edges, used(facet.isolated.begin(), facet.isolated.end());
    std::map<int, int> balance;
    for (const auto& [a, c] : facet.boundary) {
      require(edges.insert({std::min(a, c), std::max(a, c)}).second, "no boundary edge in both directions");
      ++balance[a], --balance[c];
      on_edges.insert({a, c});
    }
    for (const auto& [vertex, surplus] : balance) require(surplus == 0, "as many boundary edges arrive as leave");
    for (const auto& [a, c] : facet.constraints) {
      require(a < c && edges.insert({a, c}).second, "no segment is both");
      on_edges.insert({a, c});
    }
    for (const Pair& edge : edges) require(segments.count(edge) == 1, "every edge is a segment");
    for (const int vertex : facet.isolated) require(on_edges.count(vertex) == 0, "isolated vertices are on no edge");
    used.insert(on_edges.begin(), on_edges.end());
    for (const int vertex : facet.frame) require(used.count(vertex) == 1, "the frame is of the facet");
    const Rational3 normal = facet_normal(complex, facet);
    require(scalar(normal, normal) > 0, "the frame is not collinear");
    require(complex.dimension == 3 || normal[2] > 0, "the frame is counter-clockwise");
    for (const int vertex : used) {
      require(vertex >= 0 && vertex < count, "vertices exist");
      require(scalar(normal, minus(complex.vertices[vertex], complex.vertices[facet.frame[0]])) == 0, "coplanar");
    }
  }
}

}  // namespace confidel::test
