// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/writer.h"

#include <fmt/format.h>

#include "proofs/certificate/output_file.h"
#include "proofs/lemmas/lemma.h"

namespace confidel {
namespace {

std::string rational(const mpq_class& value) { return value.get_num().get_str(16) + '/' + value.get_den().get_str(16); }

/// X Y Z W with the smallest common W.
std::string homogeneous(const std::array<mpq_class, 3>& position, int dimension) {
  mpz_class weight = 1;
  for (int axis = 0; axis < dimension; ++axis) mpz_lcm(weight.get_mpz_t(), weight.get_mpz_t(), position[axis].get_den_mpz_t());
  std::string text;
  for (int axis = 0; axis < dimension; ++axis) text += mpz_class(position[axis].get_num() * (weight / position[axis].get_den())).get_str(16) + ' ';
  return text + weight.get_str(16);
}

/// A section: its lines, counted.
std::string section(const char* name, const std::vector<std::string>& lines) {
  std::string text = fmt::format("{} {}\n", name, lines.size());
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

std::vector<std::string> claim_lines(const Complex& complex, const Placement& placement) {
  std::vector<std::string> lines;
  if (!placement.refutation) lines.push_back("claim conforms");
  if (!placement.claims.empty()) {
    const Instance instance = instance_of(complex, placement, false);
    for (const std::string& id : placement.claims) lines.push_back(fmt::format("claim {} {}", id, find_lemma(id).count(instance)));
  }
  if (placement.refutation) lines.push_back("refutes " + placement.refutation->statement);
  return lines;
}

std::vector<std::string> parameter_lines(const Parameters& parameters) {
  std::vector<std::string> lines;
  if (parameters.radius) lines.push_back("r " + rational(*parameters.radius));
  if (parameters.spacing) lines.push_back("h " + rational(*parameters.spacing));
  if (parameters.angle_multiple > 0) lines.push_back(fmt::format("angle {} {}", parameters.angle_multiple, rational(parameters.angle_cosine)));
  if (parameters.beta > 0) lines.push_back(fmt::format("beta {}", parameters.beta));
  if (parameters.offset > 0) lines.push_back(fmt::format("offset {}", parameters.offset));
  if (parameters.chord > 0) lines.push_back(fmt::format("chord {}", parameters.chord));
  if (parameters.greatest_circumradius) lines.push_back("r-max " + rational(*parameters.greatest_circumradius));
  for (const auto& [vertex, radius] : parameters.balls) lines.push_back(fmt::format("ball {} {}", vertex, rational(radius)));
  for (const Parameters::Row& row : parameters.rows)
    lines.push_back(fmt::format("row {} {} {} {} {} {}", row.segment, rational(row.offset), rational(row.edge_cosine[0]), rational(row.facet_cosine[0]),
                                rational(row.edge_cosine[1]), rational(row.facet_cosine[1])));
  return lines;
}

std::vector<std::string> evidence_lines(const Placement& placement) {
  std::vector<std::string> lines;
  for (const Insertion& insertion : placement.insertions)
    lines.push_back(fmt::format("c {} {} {} {} {}", insertion.facet, insertion.corners[0], insertion.corners[1], insertion.corners[2], insertion.point));
  if (!placement.refutation) return lines;
  const auto& [statement, cells, points, values] = *placement.refutation;
  if (cells.size() == 2 && values.size() == 1)
    lines.push_back(fmt::format("x {} {} {}", cells[0], cells[1], rational(values[0])));
  else if (cells.size() == 1 && points.size() == values.size() && (points.size() == 1 || points.size() == 2)) {
    lines.push_back(fmt::format("x {}", cells[0]));
    for (std::size_t i = 0; i < points.size(); ++i) lines.back() += fmt::format(" {} {}", points[i], rational(values[i]));
  } else {
    throw std::logic_error("certificate: a refutation of an unknown form");
  }
  return lines;
}

}  // namespace

CertificateSummary write_certificate(const std::string& path, const std::string& temporary, const Complex& complex, const Placement& placement,
                                     const CertificateNotes& notes) {
  OutputFile file(path, temporary);
  CertificateSummary summary;
  const std::string canonical = canonical_text(complex);
  summary.complex_sha256 = sha256(canonical);
  file.write("confidel-certificate 1\n");
  file.write(canonical);
  file.write(section("claims", claim_lines(complex, placement)));
  file.write(fmt::format("notes {}\n", notes.size()));
  for (const auto& [key, text] : notes) file.write(fmt::format("n {} {}\n", key, text));
  file.write(section("parameters", parameter_lines(placement.parameters)));

  const std::size_t vertices = complex.vertices.size();
  file.write(fmt::format("points {}\n", placement.points.size() - vertices));
  for (std::size_t id = vertices; id < placement.points.size(); ++id) {
    const PlacedPoint& point = placement.points[id];
    if (point.kind == PointKind::vertex) throw std::logic_error("certificate: a vertex among the Steiner points");
    const std::string position = placement.rational_positions.empty() ? canonical_point(point.position.scaled(complex.scale), complex.dimension)
                                                                      : homogeneous(placement.rational_positions[id], complex.dimension);
    file.write(fmt::format("q {} {} {}\n", name_of(point.kind), point.carrier, position));
  }
  file.write(fmt::format("cells {}\n", placement.cells.size()));
  for (const PlacedCell& cell : placement.cells) {
    std::string line = fmt::format("t {} {} {} {} {}", cell.facet, cell.corners[0], cell.corners[1], cell.corners[2], name_of(cell.kind));
    if (cell.kind == CellKind::R) line += fmt::format(" {}", cell.box);
    if (!cell.offset.is_zero()) line += ' ' + rational(cell.offset.value());
    file.write(line + '\n');
  }
  std::size_t blocks = 0;
  for (const PlacedRow& row : placement.rows) blocks += 1 + row.protectors.size();
  file.write(fmt::format("rows {}\n", blocks));
  const auto ids = [&](const std::vector<int>& list) {
    for (int id : list) file.write(fmt::format("{}\n", id));
  };
  for (const PlacedRow& row : placement.rows) {
    file.write(fmt::format("r {} {}\n", row.segment, row.points.size()));
    ids(row.points);
    for (const auto& protector : row.protectors) {
      file.write(fmt::format("r {} {} {} {}\n", row.segment, protector.points.size(), protector.facet, protector.left ? '+' : '-'));
      ids(protector.points);
    }
  }
  file.write(fmt::format("hanging {}\n", placement.hanging.size()));
  for (const auto& [segment, a, b] : placement.hanging) file.write(fmt::format("h {} {} {}\n", segment, a, b));
  file.write(section("evidence", evidence_lines(placement)));
  const std::string digest = file.digest();
  file.write(fmt::format("end {} {} {} {} {} {} {} {}\n", vertices, complex.segments.size(), complex.facets.size(),
                         placement.points.size() - vertices, placement.cells.size(), blocks, placement.hanging.size(), digest));
  summary.text_bytes = file.text_bytes();
  summary.file_bytes = file.commit();
  return summary;
}

}  // namespace confidel
