// SPDX-License-Identifier: GPL-3.0-or-later
// confidel info FILE [--json]: what is in a file, and how hard it is going to be.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "apps/command.h"
#include "core/complex/build.h"
#include "core/features/features.h"
#include "core/io/read.h"

namespace confidel {

namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string file;
  bool json = false;
  BuildOptions build;
};

/// The smallest of some angles, and the segment and vertex where it is.
struct SmallestAngle {
  double degrees = 180;
  SegmentId segment = -1;
  VertexId vertex = -1;  ///< -1: the segment as a whole

  void add(double radians, SegmentId at_segment, VertexId at_vertex) {
    // pi stands for "there is none"; an angle of exactly pi is not worth a word.
    const double angle = radians * (180 / std::numbers::pi);
    if (angle >= degrees) return;
    degrees = angle;
    segment = at_segment;
    vertex = at_vertex;
  }
  bool exists() const { return segment >= 0; }
};

struct Spread {
  double least = 0, median = 0, greatest = 0;
};

/// In the input's units; infinite values say that there is nothing to be distant from.
std::optional<Spread> spread_of(std::vector<double> values, int scale) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
               values.end());
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto in_units = [&](double value) { return std::ldexp(value, scale); };
  return Spread{in_units(values.front()), in_units(values[values.size() / 2]), in_units(values.back())};
}

struct Summary {
  std::size_t triangles = 0, boundary = 0, constraints = 0, isolated = 0;
  std::vector<SegmentId> hanging;
  SmallestAngle segments, segment_facet, dihedral;
  std::optional<Spread> vertex_distance, segment_distance;
  std::string digest;
};

void count(const Complex& complex, Summary& summary) {
  std::vector<bool> in_facet(complex.segments.size(), false);
  for (const Facet& facet : complex.facets) {
    summary.triangles += facet.triangles.size();
    summary.boundary += facet.boundary.size();
    summary.constraints += facet.constraints.size();
    summary.isolated += facet.isolated.size();
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [a, b] : *edges) in_facet[complex.find_segment(a, b)] = true;
  }
  for (SegmentId segment = 0; segment < static_cast<SegmentId>(in_facet.size()); ++segment)
    if (!in_facet[segment]) summary.hanging.push_back(segment);
}

void measure(const Complex& complex, Summary& summary) {
  const Features features = compute_features(complex);
  for (SegmentId segment = 0; segment < static_cast<SegmentId>(complex.segments.size()); ++segment) {
    for (int end = 0; end < 2; ++end) {
      const VertexId vertex = complex.segments[segment][end];
      summary.segments.add(features.segment_angle[segment][end], segment, vertex);
      summary.segment_facet.add(features.facet_angle[segment][end], segment, vertex);
    }
    summary.dihedral.add(features.dihedral_angle[segment], segment, -1);
  }
  summary.vertex_distance = spread_of(features.vertex_distance, complex.scale);
  summary.segment_distance = spread_of(features.segment_distance, complex.scale);
}

/// Numbers of vertices as the file counts them.
class InfoWriter {
 public:
  InfoWriter(const Input& input, const BuiltComplex& built, const Summary& summary)
      : input_(input), complex_(built.complex), report_(built.report), summary_(summary) {}

  Json json() const {
    Json document;
    document["file"] = input_.file;
    document["valid"] = true;
    document["dimension"] = complex_.dimension;
    document["first_index"] = input_.first_index;
    document["vertices"] = complex_.vertices.size();
    document["segments"] = complex_.segments.size();
    document["hanging_segments"] = segments(summary_.hanging);
    document["artificial_segments"] = report_.artificial_segments;
    document["facets"] = complex_.facets.size();
    document["triangles"] = summary_.triangles;
    document["boundary_edges"] = summary_.boundary;
    document["inner_constraints"] = summary_.constraints;
    document["isolated_vertices"] = summary_.isolated;
    document["smallest_angle_between_segments"] = angle(summary_.segments);
    document["smallest_angle_between_segment_and_facet"] = angle(summary_.segment_facet);
    document["smallest_dihedral_angle"] = angle(summary_.dihedral);
    document["vertex_feature_size"] = spread(summary_.vertex_distance);
    document["segment_feature_size"] = spread(summary_.segment_distance);
    document["split_segments"] = Json::array();
    for (const auto& [first, second, on_it] : report_.split_segments)
      document["split_segments"].push_back({{"segment", {number(first), number(second)}}, {"at", number(on_it)}});
    document["remarks"] = remarks();
    document["sha256"] = summary_.digest;
    return document;
  }

  std::string text() const {
    std::string result =
        fmt::format("{}: valid, exactly: {}\n", input_.file,
                    complex_.dimension == 2 ? "no segments cross" : "every facet is flat, nothing crosses or overlaps");
    const auto line = [&](const std::string& name, const std::string& value) {
      result += fmt::format("  {:<34}{}\n", name, value);
    };
    line("dimension", std::to_string(complex_.dimension));
    line("vertices", std::to_string(complex_.vertices.size()));
    line("segments", fmt::format("{}, of these {} in no facet (hanging){}", complex_.segments.size(),
                                 summary_.hanging.size(), list(summary_.hanging)));
    if (complex_.dimension == 2) {
      line("artificial segments", std::to_string(report_.artificial_segments));
      line("domain", complex_.facets.empty() ? "none" : contents());
    } else {
      line("facets", fmt::format("{}: {}", complex_.facets.size(), contents()));
    }
    line("smallest angle between segments", angle_text(summary_.segments));
    if (complex_.dimension == 3) {
      line("smallest angle segment to facet", angle_text(summary_.segment_facet));
      line("smallest dihedral angle", angle_text(summary_.dihedral));
    }
    line("feature size of vertices", spread_text(summary_.vertex_distance));
    line("feature size of segments", spread_text(summary_.segment_distance));
    line("SHA-256 of the canonical complex", summary_.digest);
    append_notes(result);
    return result;
  }

 private:
  static constexpr std::size_t shown = 20;

  int number(VertexId vertex) const { return report_.input_index[vertex] + input_.first_index; }

  std::string contents() const {
    return fmt::format("{} triangles, {} boundary edges, {} inner constraints, {} isolated vertices",
                       summary_.triangles, summary_.boundary, summary_.constraints, summary_.isolated);
  }

  std::string segment_text(SegmentId segment) const {
    return fmt::format("{}-{}", number(complex_.segments[segment][0]), number(complex_.segments[segment][1]));
  }

  std::string list(const std::vector<SegmentId>& segments) const {
    std::string result;
    for (std::size_t i = 0; i < std::min<std::size_t>(segments.size(), 8); ++i)
      result += (i == 0 ? ": " : ", ") + segment_text(segments[i]);
    return segments.size() > 8 ? result + ", ..." : result;
  }

  Json segments(const std::vector<SegmentId>& ids) const {
    Json result = Json::array();
    for (const SegmentId id : ids)
      result.push_back({number(complex_.segments[id][0]), number(complex_.segments[id][1])});
    return result;
  }

  Json angle(const SmallestAngle& smallest) const {
    if (!smallest.exists()) return nullptr;
    const Segment& segment = complex_.segments[smallest.segment];
    Json result{{"degrees", smallest.degrees}, {"segment", {number(segment[0]), number(segment[1])}}};
    if (smallest.vertex >= 0) result["vertex"] = number(smallest.vertex);
    return result;
  }

  std::string angle_text(const SmallestAngle& smallest) const {
    if (!smallest.exists()) return "none";
    const std::string segment = segment_text(smallest.segment);
    if (smallest.vertex < 0) return fmt::format("{:.6g} degrees, at segment {}", smallest.degrees, segment);
    return fmt::format("{:.6g} degrees, at vertex {} of segment {}", smallest.degrees, number(smallest.vertex),
                       segment);
  }

  static Json spread(const std::optional<Spread>& values) {
    if (!values) return nullptr;
    return {{"min", values->least}, {"median", values->median}, {"max", values->greatest}};
  }

  static std::string spread_text(const std::optional<Spread>& values) {
    if (!values) return "none";
    return fmt::format("smallest {:.6g}, median {:.6g}, largest {:.6g}", values->least, values->median,
                       values->greatest);
  }

  std::vector<std::string> remarks() const {
    std::vector<std::string> all = input_.remarks;
    all.insert(all.end(), report_.remarks.begin(), report_.remarks.end());
    return all;
  }

  void append_notes(std::string& result) const {
    std::vector<std::string> notes;
    for (const auto& [first, second, on_it] : report_.split_segments)
      notes.push_back(fmt::format("segment {}-{} is split at vertex {}, which lies exactly on it", number(first),
                                  number(second), number(on_it)));
    const std::vector<std::string> others = remarks();
    notes.insert(notes.end(), others.begin(), others.end());
    if (notes.empty()) return;
    result += "remarks\n";
    for (std::size_t i = 0; i < std::min(shown, notes.size()); ++i) result += "  " + notes[i] + "\n";
    if (notes.size() > shown) result += fmt::format("  ... {} in all; --json lists every one\n", notes.size());
  }

  const Input& input_;
  const Complex& complex_;
  const BuildReport& report_;
  const Summary& summary_;
};

int run_info(const InfoOptions& options) {
  const Input input = read_input(options.file);
  const BuiltComplex built = build_complex(input, options.build);
  Summary summary;
  count(built.complex, summary);
  measure(built.complex, summary);
  summary.digest = sha256(canonical_text(built.complex));
  const InfoWriter writer(input, built, summary);
  write_output("", options.json ? writer.json().dump(2) + "\n" : writer.text());
  return exit_success;
}

}  // namespace

void add_info(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      app.add_subcommand("info", "Say what is in a file: counts, exact validity, smallest angles, feature sizes");
  command->add_option("FILE", options->file, "The input: .poly, .smesh, .off, .obj, .stl, .ply, .mesh, .edg")
      ->required();
  add_json_option(*command, selection);
  add_build_options(*command, options->build);
  command->footer("Examples:\n  confidel info examples/w3.smesh\n  confidel info examples/cube-triangles.off --json");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_info(*options); };
  });
}

}  // namespace confidel
