// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/draw/vtu.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "apps/draw/svg.h"

namespace confidel {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays below are written as they are in memory");

template <class Value>
const char* type_name();
template <>
const char* type_name<double>() { return "Float64"; }
template <>
const char* type_name<std::int64_t>() { return "Int64"; }
template <>
const char* type_name<std::uint8_t>() { return "UInt8"; }

/// Scalars have no NumberOfComponents: meshio makes matrices of one column of them otherwise.
template <class Value>
std::string array(const std::string& name, const std::vector<Value>& values, int components = 1) {
  std::string bytes(sizeof(std::uint64_t) + values.size() * sizeof(Value), '\0');
  const std::uint64_t size = values.size() * sizeof(Value);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">{}</DataArray>\n", type_name<Value>(), name,
                     components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "", base64(bytes.data(), bytes.size()));
}

double value_of(const Nearest& nearest) {
  return nearest.point < 0 ? std::numeric_limits<double>::quiet_NaN() : nearest_double(nearest.relative_power);
}

}  // namespace

std::string base64(const void* bytes, std::size_t size) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* data = static_cast<const unsigned char*>(bytes);
  std::string result;
  result.reserve((size + 2) / 3 * 4);
  for (std::size_t i = 0; i < size; i += 3) {
    const unsigned a = data[i], b = i + 1 < size ? data[i + 1] : 0, c = i + 2 < size ? data[i + 2] : 0;
    result += digits[a >> 2];
    result += digits[(a & 3) << 4 | b >> 4];
    result += i + 1 < size ? digits[(b & 15) << 2 | c >> 6] : '=';
    result += i + 2 < size ? digits[c & 63] : '=';
  }
  return result;
}

std::string draw_vtu(const Picture& picture) {
  const Certificate& certificate = picture.certificate;
  std::vector<double> coordinates;
  std::vector<std::int64_t> point_kinds, carriers;
  for (std::size_t p = 0; p < certificate.points.size(); ++p) {
    coordinates.insert(coordinates.end(), picture.positions[p].begin(), picture.positions[p].end());
    point_kinds.push_back(static_cast<int>(certificate.kinds[p]));
    carriers.push_back(certificate.carriers[p]);
  }
  constexpr std::uint8_t vtk_line = 3, vtk_triangle = 5;
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::int64_t> connectivity, offsets, kinds, facets, segments, lines, boxes, nearest, nearest_off_plane, violated;
  std::vector<std::uint8_t> types;
  std::vector<double> slack, power, radius;
  for (std::size_t i = 0; i < certificate.cells.size(); ++i) {
    const CertificateCell& cell = certificate.cells[i];
    const CellClearance& clearance = picture.clearances[i];
    connectivity.insert(connectivity.end(), cell.corners.begin(), cell.corners.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(vtk_triangle);
    kinds.push_back(static_cast<int>(cell.kind));
    facets.push_back(cell.facet);
    segments.push_back(-1);
    lines.push_back(cell.line);
    boxes.push_back(cell.box);
    slack.push_back(value_of(picture.slack(i)));
    power.push_back(value_of(clearance.all));
    nearest.push_back(clearance.all.point);
    nearest_off_plane.push_back(clearance.off_plane.point);
    violated.push_back(clearance.violated() ? 1 : 0);
    radius.push_back(clearance.degenerate ? none : clearance.radius);
  }
  for (const auto& [segment, a, b] : certificate.hanging) {
    connectivity.insert(connectivity.end(), {a, b});
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(vtk_line);
    for (auto* list : {&kinds, &facets, &lines, &boxes, &nearest, &nearest_off_plane}) list->push_back(-1);
    segments.push_back(segment);
    violated.push_back(0);
    for (auto* list : {&slack, &power, &radius}) list->push_back(none);
  }
  std::string verdict = escaped(picture.verdict);  // a comment must not hold two hyphens in a row
  for (std::size_t at; (at = verdict.find("--")) != std::string::npos;) verdict[at] = '_';
  std::string out = "<?xml version=\"1.0\"?>\n<!-- confidel draw: " + verdict +
                    ". point kind: 0 vertex, 1 projection, 2 edge, 3 offset, 4 arc, 5 interior; cell kind: 0 T, 1 S, 2 R, 3 C -->\n";
  out += "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  out += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", certificate.points.size(), types.size());
  out += array("Points", coordinates, 3) + "</Points>\n<Cells>\n";
  out += array("connectivity", connectivity) + array("offsets", offsets) + array("types", types) + "</Cells>\n<PointData>\n";
  out += array("kind", point_kinds) + array("carrier", carriers) + "</PointData>\n<CellData Scalars=\"slack\">\n";
  out += array("slack", slack) + array("relative-power", power) + array("radius", radius) + array("kind", kinds) + array("facet", facets) + array("segment", segments) +
         array("box", boxes) + array("line", lines) + array("nearest", nearest) + array("nearest-off-plane", nearest_off_plane) + array("violated", violated);
  for (LemmaSlacks lemma : picture.lemmas) {
    lemma.cells.resize(types.size(), none);
    out += array("slack-" + lemma.id, lemma.cells);
  }
  return out + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace confidel
