// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/draw/html.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "apps/draw/embedded.h"
#include "apps/draw/svg.h"
#include "apps/draw/vtu.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
std::string packed(const std::vector<Value>& values) {
  return base64(values.data(), values.size() * sizeof(Value));
}

/// The signed distance from a cell's circumcentre to the centre of its sphere, along the facet's normal: steering and drawing only.
double shift_of(const Picture& picture, const CertificateCell& cell) {
  if (cell.offset == 0) return 0;
  const auto& frame = picture.certificate.facets[cell.facet].frame;
  const auto& a = picture.positions[frame[0]];
  std::array<double, 3> u{}, v{};
  for (int axis = 0; axis < 3; ++axis) {
    u[axis] = picture.positions[frame[1]][axis] - a[axis];
    v[axis] = picture.positions[frame[2]][axis] - a[axis];
  }
  const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return nearest_double(cell.offset) * std::sqrt(x * x + y * y + z * z);
}

Json table_of(const Picture& picture) {
  Json table = Json::array();
  if (!picture.check.is_object()) return table;
  const Json& report = picture.check;
  if (report.contains("rules") && report["rules"].is_object())
    for (const auto& [name, count] : report["rules"].items()) {
      Json row = {{"name", name}, {"objects", count.dump()}, {"slack", "holds"}};
      if (name == "emptiness" && report.contains("smallest-relative-power") && report["smallest-relative-power"].is_object()) {
        row["slack"] = report["smallest-relative-power"].value("value", Json()).dump();
        row["line"] = report["smallest-relative-power"].value("cell-line", 0);
      }
      table.push_back(row);
    }
  // lemma-claims.md, section 3.
  if (report.contains("claims") && report["claims"].is_array())
    for (const Json& claim : report["claims"]) {
      if (!claim.is_object()) continue;
      const auto text = [&](const char* key) { return claim.contains(key) ? (claim[key].is_string() ? claim[key].get<std::string>() : claim[key].dump()) : std::string(); };
      const bool failed = claim.contains("failures") && claim["failures"] != 0;
      Json row = {{"name", text("id")}, {"objects", text("objects")}, {"slack", failed ? "fails" : claim.contains("slack") && claim["slack"].is_null() ? "holds" : text("slack")}};
      if (claim.contains("line") && claim["line"].is_number_integer()) row["line"] = claim["line"];
      table.push_back(row);
    }
  if (report.contains("rule")) {
    Json row = {{"name", report["rule"]}, {"objects", report.value("object", "")}, {"slack", report.value("verdict", "") == "REFUTED" ? "refuted" : "fails"}};
    if (report.contains("line")) row["line"] = report["line"];
    table.push_back(row);
  }
  return table;
}

void put_cells(const Picture& picture, Json& data) {
  const Certificate& certificate = picture.certificate;
  std::vector<std::int32_t> corners, facets, lines, nearest;
  std::vector<std::uint8_t> kinds;
  std::vector<double> slack, shift;
  bool shifted = false;
  for (std::size_t i = 0; i < certificate.cells.size(); ++i) {
    const CertificateCell& cell = certificate.cells[i];
    corners.insert(corners.end(), cell.corners.begin(), cell.corners.end());
    facets.push_back(cell.facet);
    lines.push_back(cell.line);
    kinds.push_back(static_cast<std::uint8_t>(cell.kind));
    const Nearest& near = picture.slack(i);
    nearest.push_back(near.point);
    slack.push_back(near.point < 0 ? std::numeric_limits<double>::quiet_NaN() : nearest_double(near.relative_power));
    shift.push_back(shift_of(picture, cell));
    shifted = shifted || cell.offset != 0;
  }
  if (!shifted) shift.clear();
  data["corners"] = packed(corners);
  data["cellKind"] = packed(kinds);
  data["cellFacet"] = packed(facets);
  data["cellLine"] = packed(lines);
  data["slack"] = packed(slack);
  data["nearest"] = packed(nearest);
  data["shift"] = packed(shift);
  data["violated"] = picture.violated;
  data["lemmas"] = Json::array();
  for (const LemmaSlacks& lemma : picture.lemmas) data["lemmas"].push_back({{"id", lemma.id}, {"slack", packed(lemma.cells)}});
  data["witness"] = {{"statement", picture.witness.statement}, {"cells", picture.witness.cells}, {"points", picture.witness.points}};
}

void put_lines(const Picture& picture, Json& data) {
  const Certificate& certificate = picture.certificate;
  std::vector<std::int32_t> segments, hanging, rows, chew, balls;
  std::vector<double> radii;
  for (const auto& [a, b] : certificate.segments) segments.insert(segments.end(), {a, b});
  for (const auto& [segment, a, b] : certificate.hanging) hanging.insert(hanging.end(), {a, b});
  int protectors = 0;
  for (const CertificateRow& row : certificate.rows) {
    if (row.facet < 0) continue;
    ++protectors;
    for (std::size_t k = 1; k < row.points.size(); ++k) rows.insert(rows.end(), {row.points[k - 1], row.points[k]});
  }
  for (const CellEdge& edge : picture.edges)
    if (edge.chew_boundary) chew.insert(chew.end(), {edge.ends[0], edge.ends[1]});
  for (const DrawnBall& ball : picture.balls) {
    balls.push_back(ball.vertex);
    radii.push_back(ball.radius);
  }
  data["segments"] = packed(segments);
  data["hanging"] = packed(hanging);
  data["rows"] = packed(rows);
  data["rowCount"] = protectors;
  data["chew"] = packed(chew);
  data["ballVertex"] = packed(balls);
  data["ballRadius"] = packed(radii);
}

Json data_of(const Picture& picture) {
  const Certificate& certificate = picture.certificate;
  const std::size_t slash = certificate.file.rfind('/');
  Json data;
  data["file"] = slash == std::string::npos ? certificate.file : certificate.file.substr(slash + 1);
  data["verdict"] = picture.verdict;
  data["dimension"] = certificate.dimension;
  const std::string strategy = certificate.note("strategy");
  data["counts"] = fmt::format("dimension {}: {} vertices, {} segments, {} facets, {} Steiner points, {} cells{}", certificate.dimension, certificate.vertex_count,
                               certificate.segments.size(), certificate.facets.size(), certificate.points.size() - certificate.vertex_count, certificate.cells.size(),
                               strategy.empty() ? "" : "; strategy " + strategy);
  data["made"] = fmt::format("Made by confidel draw. Slack: power over R² of the nearest point {}. Complex: SHA-256 {}.",
                             certificate.dimension == 3 ? "off the cell's plane" : "that is no corner", certificate.complex_sha256);
  data["vertexCount"] = certificate.vertex_count;
  data["table"] = table_of(picture);
  std::vector<double> coordinates;
  std::vector<std::uint8_t> kinds;
  for (std::size_t p = 0; p < certificate.points.size(); ++p) {
    coordinates.insert(coordinates.end(), picture.positions[p].begin(), picture.positions[p].end());
    kinds.push_back(static_cast<std::uint8_t>(certificate.kinds[p]));
  }
  data["points"] = packed(coordinates);
  data["pointKind"] = packed(kinds);
  put_cells(picture, data);
  put_lines(picture, data);
  return data;
}

}  // namespace

std::string draw_html(const Picture& picture) {
  // Inside a script element `</` would end it; in JSON strings `<` can be spelt otherwise.
  std::string data;
  for (char c : data_of(picture).dump(-1, ' ', true, Json::error_handler_t::replace)) c == '<' ? void(data += "\\u003c") : void(data += c);
  const std::size_t slash = picture.certificate.file.rfind('/');
  const std::string title = escaped(slash == std::string::npos ? picture.certificate.file : picture.certificate.file.substr(slash + 1)) + " - confidel";
  std::string script;
  for (std::string_view part : {embedded_viewer_data_js, embedded_viewer_gl_js, embedded_viewer_js, embedded_viewer_panel_js}) script += part;
  const std::pair<std::string_view, std::string_view> parts[] = {{"@TITLE@", title}, {"@CSS@", embedded_viewer_css}, {"@DATA@", data}, {"@JS@", script}};
  std::string out;
  std::string_view rest = embedded_viewer_html;
  for (const auto& [mark, text] : parts) {
    const std::size_t at = rest.find(mark);
    out += rest.substr(0, at);
    out += text;
    rest.remove_prefix(at + mark.size());
  }
  return out += rest;
}

}  // namespace confidel
