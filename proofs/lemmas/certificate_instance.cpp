// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/certificate_instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/io/problems.h"
#include "proofs/lemmas/lemma.h"
#include "proofs/lemmas/rational_geometry.h"

namespace confidel {
namespace {

/// The fields of one line whose meaning the reader leaves to others.
class Fields {
 public:
  Fields(const std::string& file, const CertificateLine& line) : file_(file), line_(line.line) {
    std::istringstream words(line.text);
    for (std::string word; words >> word;) fields_.push_back(word);
  }

  const std::string& word() const { return fields_.front(); }
  std::size_t size() const { return fields_.size(); }
  int line() const { return line_; }
  [[noreturn]] void stop(const char* code, const std::string& message) const {
    io::Problems problems;
    problems.stop(code, {file_, line_, 0}, message);
  }
  void need(std::size_t count) const {
    if (fields_.size() != count) stop("E-SYNTAX", fmt::format("{} fields, but `{}` has {}", fields_.size(), word(), count));
  }
  const std::string& text(std::size_t field) const { return fields_[field]; }
  int index(std::size_t field, std::size_t below) const {
    const std::string& text = fields_[field];
    if (text.empty() || text.size() > 10 || text.find_first_not_of("0123456789") != std::string::npos) stop("E-SYNTAX", text + " is no index");
    const std::size_t value = std::stoull(text);
    if (value >= below) stop("E-RANGE", fmt::format("{} is out of range: it must be below {}", text, below));
    return static_cast<int>(value);
  }
  mpq_class rational(std::size_t field) const {
    const std::string& text = fields_[field];
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos || text.find_first_not_of("0123456789abcdef-/") != std::string::npos) stop("E-SYNTAX", text + " is no rational NUM/DEN");
    mpz_class numerator, denominator;
    if (numerator.set_str(text.substr(0, slash), 16) != 0 || denominator.set_str(text.substr(slash + 1), 16) != 0) stop("E-SYNTAX", text + " is no rational NUM/DEN");
    if (denominator <= 0) stop("E-VALUE", "the denominator is not positive");
    mpq_class value(numerator, denominator);
    value.canonicalize();
    return value;
  }
  mpq_class positive(std::size_t field, bool below_one = false) const {
    mpq_class value = rational(field);
    if (value <= 0 || (below_one && value >= 1)) stop("E-VALUE", below_one ? "the value is not between 0 and 1" : "the value is not positive");
    return value;
  }

 private:
  const std::string& file_;
  int line_;
  std::vector<std::string> fields_;
};

void read_parameters(const Certificate& certificate, Instance& instance) {
  Parameters& parameters = instance.parameters;
  for (const CertificateLine& line : certificate.parameters) {
    const Fields fields(certificate.file, line);
    const std::string& word = fields.word();
    if (word == "r" || word == "h" || word == "r-max") {
      fields.need(2);
      auto& parameter = word == "r" ? parameters.radius : word == "h" ? parameters.spacing : parameters.greatest_circumradius;
      if (parameter) fields.stop("E-ORDER", word + " is said twice");
      parameter = fields.positive(1);
      if (word == "r") instance.lines.radius = line.line;
    } else if (word == "angle") {
      fields.need(3);
      parameters.angle_multiple = fields.index(1, 65);
      parameters.angle_cosine = fields.positive(2, true);
      instance.lines.angle = line.line;
      if (parameters.angle_multiple == 0) fields.stop("E-VALUE", "the multiple of an angle is at least 1");
    } else if (word == "beta" || word == "offset" || word == "chord") {
      fields.need(2);
      int& parameter = word == "beta" ? parameters.beta : word == "offset" ? parameters.offset : parameters.chord;
      parameter = fields.index(1, 1U << 31);
      if (parameter == 0) fields.stop("E-VALUE", word + " is at least 1");
      (word == "chord" ? instance.lines.chord : instance.lines.offset) = line.line;
    } else if (word == "ball") {
      fields.need(3);
      parameters.balls.push_back({fields.index(1, certificate.vertex_count), fields.positive(2)});
      instance.lines.balls.push_back(line.line);
      if (parameters.balls.size() > 1 && parameters.balls[parameters.balls.size() - 2].vertex >= parameters.balls.back().vertex) fields.stop("E-ORDER", "balls are not sorted");
    } else if (word == "row") {
      fields.need(7);
      parameters.rows.push_back({fields.index(1, certificate.segments.size()),
                                 fields.positive(2),
                                 {fields.positive(3, true), fields.positive(5, true)},
                                 {fields.positive(4, true), fields.positive(6, true)}});
      instance.lines.row_sizes.push_back(line.line);
      if (parameters.rows.size() > 1 && parameters.rows[parameters.rows.size() - 2].segment >= parameters.rows.back().segment) fields.stop("E-ORDER", "rows are not sorted");
    } else {
      fields.stop("E-SYNTAX", word + " is no parameter");
    }
  }
}

void read_claims(const Certificate& certificate, CertificateInstance& result) {
  for (const CertificateLine& line : certificate.claims) {
    const Fields fields(certificate.file, line);
    if (fields.word() == "refutes") {
      fields.need(2);
      result.refutes = fields.text(1);
    } else if (fields.word() != "claim" || fields.size() < 2) {
      fields.stop("E-SYNTAX", "no claim");
    } else if (fields.text(1) == "conforms") {
      fields.need(2);
    } else {
      fields.need(3);
      try {
        find_lemma(fields.text(1));
      } catch (const std::out_of_range&) {
        fields.stop("E-SYNTAX", fields.text(1) + " is no statement that this program knows (`confidel lemma list`)");
      }
      result.claims.push_back({fields.text(1), fields.index(2, 1U << 31), line.line});
    }
  }
}

void read_evidence(const Certificate& certificate, Instance& instance) {
  for (const CertificateLine& line : certificate.evidence) {
    const Fields fields(certificate.file, line);
    if (fields.word() == "x") continue;  // a refutation: confidel-check tests it
    if (fields.word() != "c") fields.stop("E-SYNTAX", fields.word() + " is no evidence");
    fields.need(6);
    const std::size_t points = certificate.points.size();
    instance.insertions.push_back({fields.index(1, certificate.facets.size()), {fields.index(2, points), fields.index(3, points), fields.index(4, points)}, fields.index(5, points)});
    instance.lines.insertions.push_back(line.line);
  }
}

/// Lines of records that the reader does not keep, from the numbers of records before them.
void find_lines(const Certificate& certificate, Instance& instance) {
  int line = 4 + certificate.vertex_count + 1;  // `segments S`
  for (std::size_t s = 0; s < certificate.segments.size(); ++s) instance.lines.segments.push_back(++line);
  ++line;
  for (const CertificateFacet& facet : certificate.facets) {
    instance.lines.facets.push_back(++line);
    line += 3 + static_cast<int>(facet.boundary.size() + facet.constraints.size() + facet.isolated.size());
  }
  line += 1;  // `end`
  const auto section = [&](std::size_t records) { line += 1 + static_cast<int>(records); };
  section(certificate.claims.size());
  section(certificate.notes.size());
  section(certificate.parameters.size());
  section(certificate.points.size() - certificate.vertex_count);
  section(certificate.cells.size());
  ++line;
  for (const CertificateRow& row : certificate.rows) {
    ++line;
    if (row.facet < 0) instance.lines.rows.push_back(line);
    line += static_cast<int>(row.points.size());
  }
  ++line;
  for (std::size_t h = 0; h < certificate.hanging.size(); ++h) instance.lines.hanging.push_back(++line);
}

class Preconditions {
 public:
  Preconditions(const Certificate& certificate, const Instance& instance) : certificate_(certificate), instance_(instance) {}

  void test() const {
    if (!std::is_sorted(instance_.segments.begin(), instance_.segments.end())) stop(0, "segments are not sorted");
    std::vector<int> order(instance_.positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return instance_.positions[a] < instance_.positions[b]; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (instance_.positions[order[i - 1]] == instance_.positions[order[i]]) stop(certificate_.point_lines[std::max(order[i - 1], order[i])], "two points coincide");
    for (std::size_t s = 0; s < instance_.segments.size(); ++s)
      if (instance_.segments[s][0] >= instance_.segments[s][1]) stop(instance_.lines.segments[s], "a segment does not go from a smaller to a greater vertex");
    for (std::size_t f = 0; f < instance_.facets.size(); ++f) {
      const Facet& facet = instance_.facets[f];
      if (collinear(facet.frame)) stop(instance_.lines.facets[f], "the three vertices of a facet's plane are collinear");
      for (const auto* edges : {&facet.boundary, &facet.constraints})
        for (const auto& [a, c] : *edges)
          if (instance_.find_segment(a, c) < 0) stop(instance_.lines.facets[f], fmt::format("the edge {} {} of a facet is no segment", a, c));
    }
    for (const CertificateCell& cell : certificate_.cells)
      if (collinear(cell.corners)) stop(cell.line, "the corners of a cell are collinear");
    for (std::size_t r = 0; r < instance_.rows.size(); ++r)
      for (const auto& protector : instance_.rows[r].protectors)
        if (protector.points.size() != instance_.rows[r].points.size() || protector.points.empty() || protector.points.front() == instance_.rows[r].points.front())
          stop(instance_.lines.rows[r], "a protector has another number of points than its segment");
  }

 private:
  bool collinear(const std::array<int, 3>& corners) const {
    const auto& p = instance_.positions;
    return squared(cross(minus(p[corners[1]], p[corners[0]]), minus(p[corners[2]], p[corners[0]]))) == 0;
  }
  [[noreturn]] void stop(int line, const std::string& what) const {
    io::Problems problems;
    problems.stop("E-VALUE", {certificate_.file, line, 0}, what + "; confidel-check says which rule the certificate violates");
  }

  const Certificate& certificate_;
  const Instance& instance_;
};

}  // namespace

CertificateInstance instance_of(const Certificate& certificate) {
  CertificateInstance result;
  Instance& instance = result.instance;
  instance.dimension = certificate.dimension;
  instance.vertex_count = certificate.vertex_count;
  for (const HomogeneousPoint& point : certificate.points) instance.positions.push_back({point.coordinate(0), point.coordinate(1), point.coordinate(2)});
  instance.kinds = certificate.kinds;
  instance.carriers = certificate.carriers;
  for (const auto& segment : certificate.segments) instance.segments.push_back(segment);
  for (const CertificateFacet& facet : certificate.facets) {
    Facet& copy = instance.facets.emplace_back();
    copy.frame = facet.frame;
    copy.boundary = facet.boundary;
    copy.constraints = facet.constraints;
    copy.isolated = facet.isolated;
  }
  for (const CertificateCell& cell : certificate.cells) instance.cells.push_back({cell.facet, cell.corners, cell.kind, cell.box, cell.offset});
  for (const CertificateRow& row : certificate.rows) {
    if (row.facet < 0) {
      instance.rows.push_back({row.segment, row.points, {}});
    } else {
      if (instance.rows.empty() || instance.rows.back().segment != row.segment) {
        io::Problems problems;
        problems.stop("E-ORDER", {certificate.file, 0, 0}, fmt::format("a protector of segment {} comes before the segment's own row", row.segment));
      }
      instance.rows.back().protectors.push_back({row.facet, row.left, row.points});
    }
  }
  instance.hanging = certificate.hanging;
  instance.lines.points = certificate.point_lines;
  for (const CertificateCell& cell : certificate.cells) instance.lines.cells.push_back(cell.line);
  find_lines(certificate, instance);
  read_claims(certificate, result);
  read_parameters(certificate, instance);
  read_evidence(certificate, instance);
  instance.whole = result.refutes.empty();
  Preconditions(certificate, instance).test();
  instance.derive();
  return result;
}

std::string objection_to(const CertificateInstance& given) {
  std::vector<std::string> statements{"L18", "L18b", "L19", "L22"};
  for (const ClaimedLemma& claim : given.claims) statements.push_back(claim.id);
  for (const std::string& id : statements)
    if (const LemmaResult result = evaluate(find_lemma(id), given.instance); result.failure) return fmt::format("{} fails at {}", id, result.failure->object);
  return "";
}

}  // namespace confidel
