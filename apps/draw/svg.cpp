// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/draw/embedded.h"
#include "core/complex/input.h"

namespace confidel {
namespace {

constexpr double plot_side = 1000;  // units of the picture for the longer side of what is shown
constexpr double panel_width = 300;
constexpr std::size_t refused_above = 20;
constexpr int bins = 6;

using Position = std::array<double, 3>;

/// An object of a layer: how it is drawn, and what it says.
struct Shape {
  std::string path;     ///< `d` of a path
  std::string classes;
  std::string id;
  std::string title;
};

struct Layer {
  std::string id, name, swatch;  ///< swatch: classes of its sample in the legend
  bool shown = true, filled = false;
  std::vector<Shape> shapes;
  bool merged = false;
};

class Drawing {
 public:
  Drawing(const Picture& picture, const SvgOptions& options) : picture_(picture), certificate_(picture.certificate), options_(options) { choose_window(); }

  SvgResult draw() {
    make_bins();
    cells();
    edges();
    circles();
    input();
    points();
    violations();
    witness();
    choose_shown();
    cap();
    return write();
  }

 private:
  void choose_window() {
    low_ = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    high_ = {-low_[0], -low_[1]};
    if (options_.window) {
      low_ = {(*options_.window)[0], (*options_.window)[1]};
      high_ = {(*options_.window)[2], (*options_.window)[3]};
    } else {
      for (const Position& position : picture_.positions)
        for (int axis = 0; axis < 2; ++axis) {
          low_[axis] = std::min(low_[axis], position[axis]);
          high_[axis] = std::max(high_[axis], position[axis]);
        }
      for (const DrawnBall& ball : picture_.balls)
        for (int axis = 0; axis < 2; ++axis) {
          low_[axis] = std::min(low_[axis], picture_.positions[ball.vertex][axis] - ball.radius);
          high_[axis] = std::max(high_[axis], picture_.positions[ball.vertex][axis] + ball.radius);
        }
    }
    if (!(low_[0] <= high_[0])) low_ = high_ = {0, 0};
    const double longer = std::max(high_[0] - low_[0], high_[1] - low_[1]);
    scale_ = longer > 0 ? plot_side / longer : 1;
    width_ = std::max((high_[0] - low_[0]) * scale_, plot_side / 4);
    height_ = std::max((high_[1] - low_[1]) * scale_, plot_side / 4);
  }

  double x(double value) const { return (value - (low_[0] + high_[0]) / 2) * scale_ + width_ / 2; }
  double y(double value) const { return ((low_[1] + high_[1]) / 2 - value) * scale_ + height_ / 2; }
  std::string xy(int point) const { return fmt::format("{:.9g} {:.9g}", x(picture_.positions[point][0]), y(picture_.positions[point][1])); }

  bool inside(double x0, double y0, double x1, double y1) const {
    return !options_.window || (x1 >= low_[0] && x0 <= high_[0] && y1 >= low_[1] && y0 <= high_[1]);
  }
  template <class Points>
  bool inside(const Points& points) const {
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
    for (int point : points) {
      x0 = std::min(x0, picture_.positions[point][0]);
      x1 = std::max(x1, picture_.positions[point][0]);
      y0 = std::min(y0, picture_.positions[point][1]);
      y1 = std::max(y1, picture_.positions[point][1]);
    }
    return inside(x0, y0, x1, y1);
  }

  std::string circle(double centre_x, double centre_y, double radius) const {
    const double r = radius * scale_;
    return fmt::format("M{:.9g} {:.9g}a{:.9g} {:.9g} 0 1 0 {:.9g} 0a{:.9g} {:.9g} 0 1 0 {:.9g} 0z", x(centre_x) - r, y(centre_y), r, r, 2 * r, r, r, -2 * r);
  }
  std::string line(int a, int b) const { return "M" + xy(a) + "L" + xy(b); }

  Layer& layer(const char* id, const char* name, const char* swatch, bool shown, bool filled = false) {
    layers_.push_back({id, name, swatch, shown, filled, {}, false});
    return layers_.back();
  }

  /// Equally many cells in each class: relative powers spread over many orders of magnitude.
  void make_bins() {
    std::vector<double> values;
    slack_.resize(certificate_.cells.size());
    for (std::size_t i = 0; i < slack_.size(); ++i) {
      slack_[i] = picture_.slack_value(i);
      if (std::isfinite(slack_[i])) values.push_back(slack_[i]);
    }
    std::sort(values.begin(), values.end());
    for (int k = 1; k < bins && !values.empty(); ++k) bounds_.push_back(values[values.size() * k / bins]);
    if (!values.empty()) range_ = {values.front(), values.back()};
  }
  int bin(std::size_t cell) const {
    return static_cast<int>(std::upper_bound(bounds_.begin(), bounds_.end(), slack_[cell]) - bounds_.begin());
  }

  std::string cell_title(std::size_t index) const {
    const CertificateCell& cell = certificate_.cells[index];
    const CellClearance& clearance = picture_.clearances[index];
    std::string text = fmt::format("cell {} (line {}), kind {}\ncorners {}, {}, {}\n", index, cell.line, name_of(cell.kind), point_name(certificate_, cell.corners[0]),
                                   point_name(certificate_, cell.corners[1]), point_name(certificate_, cell.corners[2]));
    if (clearance.degenerate) return text + "its corners are collinear";
    text += fmt::format("circumradius {:.9g}\n", clearance.radius);
    if (clearance.all.point < 0) return text + "there is no other point";
    return text + fmt::format("nearest point {}\nits relative power {}", point_name(certificate_, clearance.all.point),
                              exact_text(clearance.all.relative_power, options_.in_full));
  }

  /// What every object says of the cells that it belongs to.
  std::string tightest_title(int cell) const {
    if (cell < 0 || picture_.slack(cell).point < 0) return "";
    const Nearest& nearest = picture_.slack(cell);
    return fmt::format("\ntightest of its cells: {}, relative power {} of point {}", cell, exact_text(nearest.relative_power, options_.in_full),
                       point_name(certificate_, nearest.point));
  }

  void cells() {
    of_point_.assign(certificate_.points.size(), -1);
    of_box_point_.assign(certificate_.points.size(), -1);
    for (std::size_t i = 0; i < certificate_.cells.size(); ++i)
      for (int corner : certificate_.cells[i].corners) {
        of_point_[corner] = picture_.tighter(of_point_[corner], static_cast<int>(i));
        if (certificate_.cells[i].kind == CellKind::R) of_box_point_[corner] = picture_.tighter(of_box_point_[corner], static_cast<int>(i));
      }
    of_segment_.assign(certificate_.segments.size(), -1);
    for (const CellEdge& edge : picture_.edges)
      if (edge.segment >= 0) of_segment_[edge.segment] = picture_.tighter(of_segment_[edge.segment], edge.tightest);
    Layer chew = {"chew", "Chew region (C)", "C", true, true, {}, false};
    Layer buffer = {"buffer", "buffer zones (T, S, R)", "S", true, true, {}, false};
    Layer circumcircles = {"circumcircles", "circumcircles", "circumcircle", false, false, {}, false};
    for (std::size_t i = 0; i < certificate_.cells.size(); ++i) {
      const CertificateCell& cell = certificate_.cells[i];
      if (!inside(cell.corners)) continue;
      std::string title = cell_title(i);
      if (!picture_.clearances[i].degenerate)
        circumcircles.shapes.push_back({circle(picture_.clearances[i].centre[0], picture_.clearances[i].centre[1], picture_.clearances[i].radius), "circumcircle",
                                        fmt::format("o{}", i), "circumcircle of " + title});
      (cell.kind == CellKind::C ? chew : buffer)
          .shapes.push_back({"M" + xy(cell.corners[0]) + "L" + xy(cell.corners[1]) + "L" + xy(cell.corners[2]) + "z", fmt::format("cell {} s{}", name_of(cell.kind), bin(i)),
                             fmt::format("c{}", i), std::move(title)});
    }
    layers_.push_back(std::move(chew));
    layers_.push_back(std::move(buffer));
    circumcircles_ = std::move(circumcircles);
  }

  void edges() {
    Layer all = {"triangulation", "triangulation", "edge", true, false, {}, false};
    Layer chew = {"chew-boundary", "boundary of the Chew region", "chew", false, false, {}, false};
    diametral_ = {"diametral", "diametral circles of edges", "diametral", false, false, {}, false};
    for (const CellEdge& edge : picture_.edges) {
      const auto [a, b] = edge.ends;
      if (!inside(edge.ends)) continue;
      std::string title = fmt::format("edge {} - {}", point_name(certificate_, a), point_name(certificate_, b));
      if (edge.segment >= 0) title += fmt::format("\non segment {}", edge.segment);
      title += tightest_title(edge.tightest);
      if (edge.chew_boundary) chew.shapes.push_back({line(a, b), "chew", "", title + "\nboundary of the Chew region"});
      if (edge.segment >= 0) {
        const Position &p = picture_.positions[a], &q = picture_.positions[b];
        diametral_.shapes.push_back({circle((p[0] + q[0]) / 2, (p[1] + q[1]) / 2, std::hypot(p[0] - q[0], p[1] - q[1]) / 2), "diametral", "", "diametral circle of " + title});
      }
      all.shapes.push_back({line(a, b), "edge", "", std::move(title)});
    }
    layers_.push_back(std::move(all));
    layers_.push_back(std::move(chew));
  }

  void circles() {
    Layer& rows = layer("rows", "edge protectors", "row", true);
    for (const CertificateRow& row : certificate_.rows) {
      if (row.facet < 0 || row.points.empty() || !inside(row.points)) continue;
      std::string path = "M" + xy(row.points[0]);
      int tightest = -1;
      for (int point : row.points) tightest = picture_.tighter(tightest, of_box_point_[point]);
      for (std::size_t k = 1; k < row.points.size(); ++k) path += "L" + xy(row.points[k]);
      rows.shapes.push_back({path, "row", "", fmt::format("protector of segment {}, {} side, {} points", row.segment, row.left ? "left" : "right", row.points.size()) + tightest_title(tightest)});
    }
    layers_.push_back(std::move(circumcircles_));
    layers_.push_back(std::move(diametral_));
    Layer& balls = layer("circles", "protecting circles", "ball", true);
    for (const DrawnBall& ball : picture_.balls) {
      const Position& centre = picture_.positions[ball.vertex];
      if (!inside(centre[0] - ball.radius, centre[1] - ball.radius, centre[0] + ball.radius, centre[1] + ball.radius)) continue;
      balls.shapes.push_back({circle(centre[0], centre[1], ball.radius), "ball", "",
                              fmt::format("protecting circle of vertex {}\nradius {:.9g}\nits square, at point {}: {}", ball.vertex, ball.radius, point_name(certificate_, ball.point),
                                          exact_text(ball.radius_square, options_.in_full)) + tightest_title(ball.tightest)});
    }
  }

  void input() {
    Layer& segments = layer("input", "input", "input", true);
    for (std::size_t s = 0; s < certificate_.segments.size(); ++s) {
      const auto [a, b] = certificate_.segments[s];
      if (!inside(certificate_.segments[s])) continue;
      mpq_class square;
      for (int axis = 0; axis < 2; ++axis) {
        const mpq_class d = certificate_.points[a].coordinate(axis) - certificate_.points[b].coordinate(axis);
        square += d * d;
      }
      segments.shapes.push_back({line(a, b), "input", "",
                                 fmt::format("segment {}: vertices {} and {}\nlength {:.9g}, its square {}", s, a, b, std::sqrt(nearest_double(square)), exact_text(square, options_.in_full)) + tightest_title(of_segment_[s])});
    }
    for (int v = 0; v < certificate_.vertex_count; ++v)
      if (inside(std::array{v})) segments.shapes.push_back({"M" + xy(v) + "h0", "point vertex", "", fmt::format("vertex {}\n{}", v, point_text(picture_, v, options_.in_full)) + tightest_title(of_point_[v])});
  }

  void points() {
    Layer& layer_points = layer("points", "Steiner points", "point arc", true);
    for (int p = certificate_.vertex_count; p < static_cast<int>(certificate_.points.size()); ++p) {
      if (!inside(std::array{p})) continue;
      const PointKind kind = certificate_.kinds[p];
      const bool on_segment = kind == PointKind::projection || kind == PointKind::edge;
      layer_points.shapes.push_back({"M" + xy(p) + "h0", fmt::format("point {}", kind == PointKind::edge ? "edge-point" : name_of(kind)), "",
                                     fmt::format("point {}{} (line {})\n{}", point_name(certificate_, p), on_segment ? fmt::format(" of segment {}", certificate_.carriers[p]) : "",
                                                 certificate_.point_lines[p], point_text(picture_, p, options_.in_full)) + tightest_title(of_point_[p])});
    }
  }

  void violations() {
    Layer& violations = layer("violations", "violations", "violation", true);
    for (int cell : picture_.violated) {
      const CellClearance& clearance = picture_.clearances[cell];
      if (!inside(certificate_.cells[cell].corners)) continue;
      violations.shapes.push_back({circle(clearance.centre[0], clearance.centre[1], clearance.radius), "violation", "", "VIOLATED: a point inside the circumcircle\n" + cell_title(cell)});
      violations.shapes.push_back({mark(clearance.all.point), "intruder", "",
                                   fmt::format("point {} inside the circumcircle of cell {}\nrelative power {}", point_name(certificate_, clearance.all.point), cell,
                                               exact_text(clearance.all.relative_power, options_.in_full))});
    }
  }

  std::string mark(int point) const {
    const double arm = 9;
    return fmt::format("M{:.9g} {:.9g}l{} {}m0 {}l{} {}", x(picture_.positions[point][0]) - arm, y(picture_.positions[point][1]) - arm, 2 * arm, 2 * arm, -2 * arm, -2 * arm, 2 * arm);
  }

  void witness() {
    const Witness& witness = picture_.witness;
    if (witness.statement.empty()) return;
    Layer& shown = layer("witness", "witness of the refutation", "witness", true);
    for (int cell : witness.cells) {
      const CellClearance& clearance = picture_.clearances[cell];
      const auto& corners = certificate_.cells[cell].corners;
      const std::string title = "witness against " + witness.statement + "\n" + cell_title(cell);
      if (!clearance.degenerate) shown.shapes.push_back({circle(clearance.centre[0], clearance.centre[1], clearance.radius), "witness", "", title});
      shown.shapes.push_back({"M" + xy(corners[0]) + "L" + xy(corners[1]) + "L" + xy(corners[2]) + "z", "witness", "", title});
    }
    for (int point : witness.points)
      shown.shapes.push_back({mark(point), "intruder", "",
                              fmt::format("witness against {}\npoint {}\n{}", witness.statement, point_name(certificate_, point), point_text(picture_, point, options_.in_full)) +
                                  tightest_title(of_point_[point])});
  }

  void choose_shown() {
    if (options_.layers.empty()) return;
    for (Layer& layer : layers_) layer.shown = std::find(options_.layers.begin(), options_.layers.end(), layer.id) != options_.layers.end();
  }

  /// Too many objects make browsers slow: the largest layers lose their tooltips first.
  void cap() {
    std::size_t total = 0;
    for (const Layer& layer : layers_) total += layer.shapes.size();
    if (total > refused_above * options_.most_elements)
      throw InputError({{"E-TOO-LARGE", {certificate_.file, 0, 0},
                         fmt::format("{} objects are too many for one SVG (at most {} times --max-elements {}); show a part of it with --window XMIN YMIN XMAX YMAX, or write .vtu for ParaView",
                                     total, refused_above, options_.most_elements)}});
    if (total <= options_.most_elements) return;
    std::string names;
    const std::size_t before = total;
    while (total > options_.most_elements) {
      Layer* largest = nullptr;
      for (Layer& layer : layers_)
        if (!layer.merged && layer.id != "violations" && (largest == nullptr || layer.shapes.size() > largest->shapes.size())) largest = &layer;
      if (largest == nullptr || largest->shapes.empty()) break;
      total -= largest->shapes.size();
      largest->merged = true;
      names += (names.empty() ? "" : ", ") + largest->name;
    }
    remarks_.push_back(fmt::format("{} objects are more than {} (--max-elements): without tooltips are {}; --window XMIN YMIN XMAX YMAX shows a part with all of them", before,
                                   options_.most_elements, names));
  }

  SvgResult write() {
    const double panel = options_.panel ? panel_width : 0, margin = 24;
    const double view_width = width_ + 2 * margin, view_height = std::max(height_ + 2 * margin, options_.panel ? 590.0 : 0.0);
    std::string& out = result_.text;
    out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- made by confidel draw; SPDX-License-Identifier: CC0-1.0 -->\n";
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.6g} {:.6g}\" role=\"img\" aria-label=\"{}\">\n", view_width + panel, view_height,
                       escaped(fmt::format("certificate {}: {}", certificate_.file, picture_.verdict)));
    out += "<style>\n" + std::string(embedded_svg_css) + "</style>\n";
    out += fmt::format("<rect id=\"frame\" width=\"100%\" height=\"100%\"/>\n<svg id=\"plot\" x=\"0\" y=\"0\" width=\"{:.6g}\" height=\"{:.6g}\" viewBox=\"{:.6g} {:.6g} {:.6g} {:.6g}\">\n<g id=\"scene\">\n",
                       view_width, view_height, -margin, -(view_height - height_) / 2, view_width, view_height);
    // Without the panel nothing could switch on what is hidden.
    for (const Layer& layer : layers_)
      if (options_.panel || layer.shown) write_layer(layer);
    out += "</g>\n</svg>\n";
    if (options_.panel) {
      write_panel(view_width);
      out += "<script><![CDATA[\n" + std::string(embedded_svg_js) + "]]></script>\n";
    }
    out += "</svg>\n";
    result_.remarks = remarks_;
    return std::move(result_);
  }

  void write_layer(const Layer& layer) {
    std::string& out = result_.text;
    out += fmt::format("<g id=\"{}\"{}>\n", layer.id, layer.shown ? "" : " class=\"off\"");
    if (layer.merged) {
      std::vector<std::pair<std::string, std::string>> paths;  // by classes
      for (const Shape& shape : layer.shapes) {
        auto path = std::find_if(paths.begin(), paths.end(), [&](const auto& entry) { return entry.first == shape.classes; });
        if (path == paths.end()) path = paths.insert(paths.end(), {shape.classes, ""});
        path->second += shape.path;
      }
      for (const auto& [classes, path] : paths) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", classes, path);
    } else {
      for (const Shape& shape : layer.shapes)
        out += fmt::format("<path{} class=\"{}\" d=\"{}\"><title>{}</title></path>\n", shape.id.empty() ? "" : " id=\"" + shape.id + "\"", shape.classes, shape.path, escaped(shape.title));
    }
    out += "</g>\n";
  }

  void text(double left, double top, const char* classes, const std::string& content) {
    const std::string shown = content.size() > 52 ? content.substr(0, 51) + "…" : content;
    result_.text += fmt::format("<text x=\"{:.6g}\" y=\"{:.6g}\" class=\"{}\">{}{}</text>\n", left, top, classes, escaped(shown), content == shown ? "" : "<title>" + escaped(content) + "</title>");
  }

  void item(double left, double top, const std::string& id, const std::string& name, bool on, const std::string& sample) {
    result_.text += fmt::format(
        "<g class=\"item\" role=\"checkbox\" tabindex=\"0\" aria-checked=\"{}\" aria-label=\"{}\" data-layer=\"{}\"><rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"250\" height=\"22\" fill-opacity=\"0\"/>"
        "<rect class=\"box\" x=\"{:.6g}\" y=\"{:.6g}\" width=\"12\" height=\"12\"/><path class=\"tick\" d=\"M{:.6g} {:.6g}l3.5 4l5 -8\"/>{}<text x=\"{:.6g}\" y=\"{:.6g}\">{}</text></g>\n",
        on ? "true" : "false", escaped(name), id, left - 4, top - 15, left, top - 10, left + 2, top - 4, sample, left + 52, top, escaped(name));
  }

  void write_panel(double left) {
    left += 8;
    double top = 34;
    const std::size_t slash = certificate_.file.rfind('/');
    text(left, top, "title", slash == std::string::npos ? certificate_.file : certificate_.file.substr(slash + 1));
    text(left, top += 20, "", picture_.check.is_null() ? picture_.verdict : "confidel-check: " + picture_.verdict);
    text(left, top += 18, "small", fmt::format("{} vertices, {} segments, {} Steiner points", certificate_.vertex_count, certificate_.segments.size(),
                                               certificate_.points.size() - certificate_.vertex_count));
    std::array<std::size_t, 4> kinds{};
    for (const CertificateCell& cell : certificate_.cells) ++kinds[static_cast<int>(cell.kind)];
    text(left, top += 16, "small", fmt::format("{} cells: {} T, {} S, {} R, {} C", certificate_.cells.size(), kinds[0], kinds[1], kinds[2], kinds[3]));
    if (!certificate_.note("strategy").empty()) text(left, top += 16, "small", "strategy " + certificate_.note("strategy"));
    top += 14;
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
      top += 24;
      std::string sample;
      if (layer->id == "buffer")
        for (int k = 0; k < 3; ++k) sample += fmt::format("<rect class=\"{}\" x=\"{:.6g}\" y=\"{:.6g}\" width=\"8\" height=\"12\"/>", "TSR"[k], left + 20 + 9 * k, top - 10);
      else if (layer->filled)
        sample = fmt::format("<rect class=\"{}\" x=\"{:.6g}\" y=\"{:.6g}\" width=\"26\" height=\"12\"/>", layer->swatch, left + 20, top - 10);
      else if (layer->id == "points")
        for (const char* kind : {"projection", "edge-point", "offset", "arc", "interior"})
          sample += fmt::format("<path class=\"point {}\" d=\"M{:.6g} {:.6g}h0\"><title>{}</title></path>", kind, left + 21 + 6 * sample_index_++, top - 4, kind);
      else
        sample = fmt::format("<path class=\"{}\" d=\"M{:.6g} {:.6g}h26\"/>", layer->swatch, left + 20, top - 4);
      item(left, top, layer->id, fmt::format("{} ({}{})", layer->name, layer->shapes.size(), layer->merged ? ", no tooltips" : ""), layer->shown, sample);
    }
    top += 32;
    item(left, top, "by-slack", "colour cells by slack", false, "");
    result_.text += "<g class=\"scale\">\n";
    text(left, top += 24, "small", "relative power of the nearest point:");
    for (int k = 0; k < bins && !bounds_.empty(); ++k) {
      top += 17;
      result_.text += fmt::format("<rect class=\"s{}\" x=\"{:.6g}\" y=\"{:.6g}\" width=\"26\" height=\"13\"/>\n", k, left, top - 11);
      text(left + 34, top, "small", fmt::format("{:.3g} to {:.3g}", k == 0 ? range_[0] : bounds_[k - 1], k + 1 == bins ? range_[1] : bounds_[k]));
    }
    result_.text += "</g>\n";
    top += 28;
    text(left, top, "small", "point at it: what it is; click a cell: its circle");
    text(left, top + 15, "small", "wheel, drag, + - and arrows: zoom, move; 0: all");
  }

  const Picture& picture_;
  const Certificate& certificate_;
  const SvgOptions& options_;
  std::array<double, 2> low_{}, high_{};
  double scale_ = 1, width_ = 1, height_ = 1;
  std::vector<Layer> layers_;  ///< from the bottom to the top
  Layer circumcircles_, diametral_;
  std::vector<double> slack_, bounds_;
  std::array<double, 2> range_{};
  std::vector<int> of_point_, of_box_point_, of_segment_;  ///< the tightest cells
  std::vector<std::string> remarks_;
  int sample_index_ = 0;
  SvgResult result_;
};

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? '?' : c;
    }
  }
  return result;
}

const std::vector<std::string>& svg_layers() {
  static const std::vector<std::string> names = {"witness", "violations", "points", "input", "circles", "diametral", "circumcircles", "rows", "chew-boundary", "triangulation", "buffer", "chew"};
  return names;
}

SvgResult draw_svg(const Picture& picture, const SvgOptions& options) { return Drawing(picture, options).draw(); }

}  // namespace confidel
