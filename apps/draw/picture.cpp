// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/draw/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

namespace confidel {
namespace {

constexpr std::size_t short_text = 40;

mpq_class distance_square(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  mpq_class sum;
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class d = a.coordinate(axis) - b.coordinate(axis);
    sum += d * d;
  }
  return sum;
}

void find_balls(Picture& picture) {
  const Certificate& certificate = picture.certificate;
  std::map<int, std::pair<int, int>> on_ball;  // vertex -> a point of its ball, the tightest cell
  for (std::size_t i = 0; i < certificate.cells.size(); ++i) {
    const CertificateCell& cell = certificate.cells[i];
    if (cell.kind != CellKind::S && cell.kind != CellKind::T) continue;
    int vertex = -1, point = -1;
    for (int corner : cell.corners) {
      const PointKind kind = certificate.kinds[corner];
      if (kind == PointKind::vertex) vertex = corner;
      if (kind == PointKind::arc || (kind == PointKind::offset && point < 0) ||
          (cell.kind == CellKind::S && (kind == PointKind::projection || kind == PointKind::edge) && point < 0))
        point = corner;
    }
    if (vertex < 0 || point < 0) continue;
    int& tightest = on_ball.emplace(vertex, std::pair{point, -1}).first->second.second;
    tightest = picture.tighter(tightest, static_cast<int>(i));
  }
  // Saalfeld's circles have no cells of their own: their points on the segments are projections.
  for (std::size_t p = certificate.vertex_count; p < certificate.points.size(); ++p) {
    if (certificate.kinds[p] != PointKind::projection) continue;
    const auto& ends = certificate.segments[certificate.carriers[p]];
    const auto away = [&](int vertex) { return distance_square(certificate.points[vertex], certificate.points[p]); };
    on_ball.emplace(away(ends[0]) <= away(ends[1]) ? ends[0] : ends[1], std::pair{static_cast<int>(p), -1});
  }
  for (const auto& [vertex, found] : on_ball) {
    const auto [point, tightest] = found;
    DrawnBall ball;
    ball.vertex = vertex;
    ball.point = point;
    ball.tightest = tightest;
    ball.radius_square = distance_square(certificate.points[vertex], certificate.points[point]);
    ball.radius = std::sqrt(nearest_double(ball.radius_square));
    picture.balls.push_back(std::move(ball));
  }
}

class Segments {
 public:
  explicit Segments(const Certificate& certificate) : certificate_(certificate) {
    for (std::size_t s = 0; s < certificate.segments.size(); ++s) by_ends_.emplace(certificate.segments[s], static_cast<int>(s));
  }

  /// The segment that both points lie on, or -1.
  int under(int a, int b) const {
    if (is_carried(b)) std::swap(a, b);
    if (!is_carried(a)) {
      const auto entry = by_ends_.find({std::min(a, b), std::max(a, b)});
      return entry == by_ends_.end() ? -1 : entry->second;
    }
    const int segment = certificate_.carriers[a];
    const auto& ends = certificate_.segments[segment];
    const bool both = is_carried(b) ? certificate_.carriers[b] == segment : ends[0] == b || ends[1] == b;
    return both ? segment : -1;
  }

 private:
  bool is_carried(int point) const {
    return certificate_.kinds[point] == PointKind::projection || certificate_.kinds[point] == PointKind::edge;
  }

  const Certificate& certificate_;
  std::map<std::array<int, 2>, int> by_ends_;
};

void find_edges(Picture& picture) {
  const Certificate& certificate = picture.certificate;
  std::vector<std::tuple<int, std::array<int, 2>, bool, int>> sides;  // facet, ends, is of a cell of kind C, the cell
  sides.reserve(3 * certificate.cells.size());
  for (std::size_t i = 0; i < certificate.cells.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const CertificateCell& cell = certificate.cells[i];
      const int a = cell.corners[k], b = cell.corners[(k + 1) % 3];
      sides.emplace_back(cell.facet, std::array{std::min(a, b), std::max(a, b)}, cell.kind == CellKind::C, static_cast<int>(i));
    }
  std::sort(sides.begin(), sides.end());
  const Segments segments(certificate);
  bool buffers = false;
  for (const CertificateCell& cell : certificate.cells) buffers = buffers || cell.kind != CellKind::C;
  for (std::size_t i = 0, next; i < sides.size(); i = next) {
    next = i + 1;
    while (next < sides.size() && std::get<0>(sides[next]) == std::get<0>(sides[i]) && std::get<1>(sides[next]) == std::get<1>(sides[i])) ++next;
    CellEdge edge;
    edge.ends = std::get<1>(sides[i]);
    for (std::size_t k = i; k < next; ++k) edge.tightest = picture.tighter(edge.tightest, std::get<3>(sides[k]));
    edge.segment = segments.under(edge.ends[0], edge.ends[1]);
    const bool first = std::get<2>(sides[i]), last = std::get<2>(sides[next - 1]);
    edge.chew_boundary = buffers && (first != last || (next == i + 1 && last));
    picture.edges.push_back(edge);
  }
}

/// `refutes ID` among the claims, `x ...` in the evidence. What is not understood is left out: this is no verdict.
void find_witness(Picture& picture) {
  const Certificate& certificate = picture.certificate;
  for (const CertificateLine& claim : certificate.claims)
    if (claim.text.rfind("refutes ", 0) == 0) picture.witness.statement = claim.text.substr(8);
  if (picture.witness.statement.empty()) return;
  Witness& witness = picture.witness;
  for (const CertificateLine& line : certificate.evidence) {
    std::istringstream fields(line.text);
    std::string word, value;
    std::size_t first = 0, second = 0;
    if (!(fields >> word >> first >> second) || word != "x" || first >= certificate.cells.size()) continue;
    witness.cells.push_back(static_cast<int>(first));
    if (witness.statement == "L5") {
      if (second >= certificate.cells.size()) continue;
      witness.cells.push_back(static_cast<int>(second));
      for (int corner : certificate.cells[second].corners)
        if (certificate.kinds[corner] == PointKind::projection) witness.points.push_back(corner);
      continue;
    }
    if (second < certificate.points.size()) witness.points.push_back(static_cast<int>(second));
    if (witness.statement == "L18" && fields >> value >> second && second < certificate.points.size()) witness.points.push_back(static_cast<int>(second));
  }
}

std::string in_decimal(const mpq_class& value) { return value.get_den() == 1 ? value.get_num().get_str() : value.get_str(); }

}  // namespace

double nearest_double(const mpq_class& value) {
  HomogeneousPoint point;
  point.numerator[0] = value.get_num();
  point.denominator = value.get_den();
  return point.approximate(0);
}

double Picture::slack_value(std::size_t cell) const {
  const Nearest& nearest = slack(cell);
  return nearest.point < 0 ? std::numeric_limits<double>::infinity() : nearest_double(nearest.relative_power);
}

int Picture::tighter(int a, int b) const {
  if (a < 0 || b < 0) return std::max(a, b);
  const Nearest &first = slack(a), &second = slack(b);
  if (first.point < 0 || second.point < 0) return first.point < 0 ? b : a;
  const int order = cmp(first.relative_power, second.relative_power);
  return order < 0 || (order == 0 && a < b) ? a : b;
}

void derive(Picture& picture) {
  find_balls(picture);
  find_edges(picture);
  find_witness(picture);
  for (std::size_t i = 0; i < picture.clearances.size(); ++i)
    if (picture.clearances[i].violated()) picture.violated.push_back(static_cast<int>(i));
}

std::string exact_text(const mpq_class& value, bool in_full) {
  const std::string rounded = fmt::format("{:.17g}", nearest_double(value));
  // An estimate that is too small by at most one digit, without making the digits.
  const std::size_t digits = mpz_sizeinbase(value.get_num().get_mpz_t(), 10) + mpz_sizeinbase(value.get_den().get_mpz_t(), 10);
  if (!in_full && digits > short_text) return fmt::format("{} (rounded)", rounded);
  const std::string exact = in_decimal(value);
  return exact == rounded ? exact : fmt::format("{:.6g} (exactly {})", nearest_double(value), exact);
}

std::string point_text(const Picture& picture, int point, bool in_full) {
  std::string text = "(";
  for (int axis = 0; axis < picture.certificate.dimension; ++axis) {
    if (axis > 0) text += ", ";
    const mpq_class value = picture.certificate.points[point].coordinate(axis);
    text += in_full ? in_decimal(value) : fmt::format("{}", picture.positions[point][axis]);
  }
  return text + ")";
}

std::string point_name(const Certificate& certificate, int point) { return fmt::format("{} ({})", point, name_of(certificate.kinds[point])); }

}  // namespace confidel
