// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/writer.h"

#include <fmt/format.h>

#include "proofs/certificate/output_file.h"

namespace confidel {
namespace {

const char* name_of(PointKind kind) {
  switch (kind) {
    case PointKind::projection: return "projection";
    case PointKind::edge: return "edge";
    case PointKind::offset: return "offset";
    case PointKind::arc: return "arc";
    case PointKind::interior: return "interior";
    case PointKind::vertex: break;
  }
  throw std::logic_error("certificate: a vertex among the Steiner points");
}

char name_of(CellKind kind) { return "TSRC"[static_cast<int>(kind)]; }

}  // namespace

CertificateSummary write_certificate(const std::string& path, const std::string& temporary, const Complex& complex, const Placement& placement,
                                     const CertificateNotes& notes) {
  OutputFile file(path, temporary);
  CertificateSummary summary;
  const std::string canonical = canonical_text(complex);
  summary.complex_sha256 = sha256(canonical);
  file.write("confidel-certificate 1\n");
  file.write(canonical);
  file.write("claims 1\nclaim conforms\n");
  file.write(fmt::format("notes {}\n", notes.size()));
  for (const auto& [key, text] : notes) file.write(fmt::format("n {} {}\n", key, text));
  file.write("parameters 0\n");

  const std::size_t vertices = complex.vertices.size();
  file.write(fmt::format("points {}\n", placement.points.size() - vertices));
  for (std::size_t id = vertices; id < placement.points.size(); ++id) {
    const PlacedPoint& point = placement.points[id];
    file.write(fmt::format("q {} {} {}\n", name_of(point.kind), point.carrier,
                           canonical_point(point.position.scaled(complex.scale), complex.dimension)));
  }
  file.write(fmt::format("cells {}\n", placement.cells.size()));
  for (const PlacedCell& cell : placement.cells) {
    std::string line = fmt::format("t {} {} {} {} {}", cell.facet, cell.corners[0], cell.corners[1], cell.corners[2], name_of(cell.kind));
    if (cell.kind == CellKind::R) line += fmt::format(" {}", cell.box);
    if (cell.offset != 0) line += ' ' + cell.offset.get_num().get_str(16) + '/' + cell.offset.get_den().get_str(16);
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
  file.write("evidence 0\n");
  const std::string digest = file.digest();
  file.write(fmt::format("end {} {} {} {} {} {} {} {}\n", vertices, complex.segments.size(), complex.facets.size(),
                         placement.points.size() - vertices, placement.cells.size(), blocks, placement.hanging.size(), digest));
  summary.text_bytes = file.text_bytes();
  summary.file_bytes = file.commit();
  return summary;
}

}  // namespace confidel
