// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/audit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t shown = 12;

const char* word(Standing standing) { return standing == Standing::holds ? "holds" : standing == Standing::present ? "present" : "fails"; }

std::string summary(const std::vector<AuditedPart>& parts, const char* what) {
  long holds = 0, present = 0;
  for (const AuditedPart& part : parts) holds += part.standing == Standing::holds, present += part.standing == Standing::present;
  const long fails = static_cast<long>(parts.size()) - holds - present;
  std::string text = fmt::format("{}: {} of {} hold", what, holds, parts.size());
  if (present > 0) text += fmt::format(", {} present without certificate", present);
  if (fails > 0) text += fmt::format(", {} fail", fails);
  return text + "\n";
}

}  // namespace

double default_nearness(const Mesh& mesh) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (const auto& point : mesh.points) low = std::min(low, point[axis]), high = std::max(high, point[axis]);
    if (high > low) extent = std::max(extent, high - low);
  }
  return 1e-9 * extent;
}

std::string AuditReport::part_name(bool segment, int index) const {
  const auto number = [&](VertexId vertex) { return report_.input_index[vertex] + input_.first_index; };
  if (segment) return fmt::format("segment {}-{}", number(complex_.segments[index][0]), number(complex_.segments[index][1]));
  if (complex_.dimension == 2) return "the domain";
  const int line = complex_.facets[index].line;
  return fmt::format("facet {}{}", index + input_.first_index, line > 0 ? fmt::format(" (line {})", line) : std::string());
}

std::string AuditReport::piece_name(const std::array<int, 3>& piece) const {
  std::string text = fmt::format("{}-{}", piece[0] + mesh_.first_index, piece[1] + mesh_.first_index);
  return piece[2] < 0 ? text : fmt::format("{}-{}", text, piece[2] + mesh_.first_index);
}

std::string AuditReport::witness(const Intrusion& intrusion) const {
  const int first = intrusion.first + mesh_.first_index;
  if (intrusion.relative_depth == 0) {
    return intrusion.second < 0 ? fmt::format("point {} lies exactly on its circle, beyond a segment: a tie", first)
                                : fmt::format("points {} and {} lie exactly on one sphere with it: a tie", first, intrusion.second + mesh_.first_index);
  }
  if (intrusion.second < 0) return fmt::format("point {} is in every sphere through it, {:.3g} r^2 deep", first, intrusion.relative_depth);
  return fmt::format("every sphere through it holds point {} or point {}, {:.3g} r^2 deep at the best", first, intrusion.second + mesh_.first_index, intrusion.relative_depth);
}

std::string AuditReport::failure(bool segment, int index, const AuditedPart& part) const {
  std::string text = part_name(segment, index) + ": ";
  if (!part.missing.empty())
    return text + fmt::format("vertex {} is no point of the mesh\n", report_.input_index[part.missing.front()] + input_.first_index);
  if (segment) {
    return text + fmt::format("{} of its {} subsegments {}, such as {}\n", part.bad, part.pieces,
                              part.standing == Standing::fails ? "are no Delaunay edges" : "have points in their smallest balls", piece_name(part.piece));
  }
  return text + fmt::format("{} of the {} triangles of the points on it have no empty sphere; {}: {}\n", part.bad, part.pieces, piece_name(part.piece), witness(part.intrusion));
}

std::string AuditReport::text() const {
  std::string text = fmt::format("{}: {} vertices, {} segments, {} facets\n{}: {} points, {} faces, {} tetrahedra; {} points lie near no segment or facet\n", input_.file,
                                 complex_.vertices.size(), complex_.segments.size(), complex_.facets.size(), mesh_.file, mesh_.points.size(), mesh_.faces.size(),
                                 mesh_.tetrahedra.size(), audit_.inner_points);
  text += summary(audit_.segments, "segments");
  text += summary(audit_.facets, complex_.dimension == 2 ? "domain" : "facets");
  std::size_t lines = 0, more = 0;
  for (const bool segment : {true, false}) {
    const auto& parts = segment ? audit_.segments : audit_.facets;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].standing == Standing::holds) continue;
      if (lines < shown) text += "  " + failure(segment, static_cast<int>(i), parts[i]), ++lines;
      else ++more;
    }
  }
  if (more > 0) text += fmt::format("  ... and {} more; --json lists every one\n", more);
  long subfaces = 0, bad = 0;
  const AuditedPart* worst = nullptr;
  for (const AuditedPart& part : audit_.facets) {
    subfaces += part.subfaces;
    bad += part.bad_subfaces;
    if (part.subface_intrusion.found && (worst == nullptr || part.subface_intrusion.relative_depth > worst->subface_intrusion.relative_depth)) worst = &part;
  }
  if (subfaces > 0) {
    text += fmt::format("the mesh's own triangles on facets: {} of {} have no empty sphere\n", bad, subfaces);
    if (worst != nullptr) text += fmt::format("  the worst, {}: {}\n", piece_name(worst->subface), witness(worst->subface_intrusion));
  }
  long on_segments = 0;
  const OffCarrier* farthest = nullptr;
  for (const OffCarrier& off : audit_.off) {
    on_segments += off.on_segment;
    if (farthest == nullptr || off.distance > farthest->distance) farthest = &off;
  }
  if (farthest != nullptr) {
    text += fmt::format("{} points are off their line, {} off their plane; the farthest, {}, is {:.3g} off {}\n", on_segments, static_cast<long>(audit_.off.size()) - on_segments,
                        farthest->point + mesh_.first_index, farthest->distance, part_name(farthest->on_segment, farthest->carrier));
  }
  if (!audit_.duplicates.empty()) text += fmt::format("{} points have the position of an earlier one\n", audit_.duplicates.size());
  return text;
}

Json AuditReport::intrusion_json(const std::array<int, 3>& piece, const Intrusion& intrusion) const {
  if (piece[0] < 0) return nullptr;
  Json result;
  result["piece"] = Json::array();
  for (const int corner : piece)
    if (corner >= 0) result["piece"].push_back(corner + mesh_.first_index);
  result["points"] = Json::array();
  for (const int point : {intrusion.first, intrusion.second})
    if (intrusion.found && point >= 0) result["points"].push_back(point + mesh_.first_index);
  result["relative_depth"] = intrusion.found ? Json(intrusion.relative_depth) : Json();
  return result;
}

Json AuditReport::part_json(bool segment, int index, const AuditedPart& part) const {
  Json result{{"name", part_name(segment, index)}, {"standing", word(part.standing)}, {"missing_vertices", Json::array()}, {"pieces", part.pieces}, {"bad_pieces", part.bad}};
  for (const VertexId vertex : part.missing) result["missing_vertices"].push_back(report_.input_index[vertex] + input_.first_index);
  result["witness"] = intrusion_json(part.piece, part.intrusion);
  if (segment) return result;
  result["subfaces"] = part.subfaces;
  result["bad_subfaces"] = part.bad_subfaces;
  result["subface_witness"] = intrusion_json(part.subface, part.subface_intrusion);
  return result;
}

Json AuditReport::json() const {
  Json document{{"file", input_.file},          {"mesh", mesh_.file},
                {"dimension", complex_.dimension}, {"points", mesh_.points.size()},
                {"faces", mesh_.faces.size()},  {"tetrahedra", mesh_.tetrahedra.size()},
                {"inner_points", audit_.inner_points}, {"duplicate_points", audit_.duplicates.size()},
                {"conforms", audit_.conforms()}, {"near", near_}, {"segments", Json::array()}, {"facets", Json::array()}, {"off", Json::array()}};
  for (std::size_t i = 0; i < audit_.segments.size(); ++i) document["segments"].push_back(part_json(true, static_cast<int>(i), audit_.segments[i]));
  for (std::size_t i = 0; i < audit_.facets.size(); ++i) document["facets"].push_back(part_json(false, static_cast<int>(i), audit_.facets[i]));
  for (const OffCarrier& off : audit_.off)
    document["off"].push_back({{"point", off.point + mesh_.first_index}, {"carrier", part_name(off.on_segment, off.carrier)}, {"distance", off.distance}});
  document["greatest_distance"] = audit_.worst_distance;
  return document;
}

std::string AuditReport::worst_object() const {
  const AuditedPart* worst = nullptr;
  bool of_segment = false;
  for (const bool segment : {false, true})
    for (const AuditedPart& part : segment ? audit_.segments : audit_.facets) {
      if (part.standing != Standing::fails) continue;
      if (worst != nullptr && (segment || worst->intrusion.relative_depth >= part.intrusion.relative_depth)) continue;
      worst = &part;
      of_segment = segment;
    }
  const auto& parts = of_segment ? audit_.segments : audit_.facets;
  std::string name = part_name(of_segment, static_cast<int>(worst - parts.data()));
  name = name.substr(0, name.find(" ("));
  std::replace(name.begin(), name.end(), ' ', '-');
  if (!worst->missing.empty()) return fmt::format("{}-vertex-{}", name, report_.input_index[worst->missing.front()] + input_.first_index);
  return fmt::format("{}-{}-{}", name, of_segment ? "subsegment" : "triangle", piece_name(worst->piece));
}

}  // namespace confidel
