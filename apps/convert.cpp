// SPDX-License-Identifier: GPL-3.0-or-later
// confidel convert IN OUT: the same input in another format; with options, explicit repairs, each of which is reported.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "core/complex/repair.h"
#include "core/io/read.h"
#include "core/io/write.h"

namespace confidel {
namespace {

struct ConvertOptions {
  std::string file, output, merge = "off", facets = "keep";
  bool split = false, json = false;
};

constexpr std::size_t shown = 20;

int run_convert(const ConvertOptions& options) {
  Input input = read_input(options.file);
  std::vector<Repair> repairs;
  const auto add = [&](std::vector<Repair> more) { std::move(more.begin(), more.end(), std::back_inserter(repairs)); };
  if (options.merge == "exact") add(merge_identical_vertices(input));
  if (options.facets == "triangulate") add(triangulate_facets(input));
  if (options.split) add(split_crossings(input));
  const WrittenInput written = written_input(input, options.output);
  write_output(options.output, written.text);

  double moved = 0;
  for (const Repair& repair : repairs) moved = std::max(moved, repair.moved);
  if (options.json) {
    nlohmann::ordered_json report{{"file", options.file},       {"output", options.output},           {"dimension", input.dimension},
                                  {"vertices", input.vertices.size()}, {"segments", input.segments.size()}, {"facets", input.facets.size()},
                                  {"greatest_move", moved},     {"repairs", nlohmann::ordered_json::array()}};
    for (const Repair& repair : repairs) report["repairs"].push_back({{"kind", repair.kind}, {"message", repair.message}, {"moved", repair.moved}});
    report["lost"] = written.lost;
    report["remarks"] = input.remarks;
    fmt::print("{}\n", report.dump(2));
    return exit_success;
  }
  std::string text = fmt::format("{}: {} vertices, {} segments, {} facets\n", options.output, input.vertices.size(), input.segments.size(), input.facets.size());
  for (std::size_t i = 0; i < std::min(shown, repairs.size()); ++i) text += "  " + repairs[i].message + "\n";
  if (repairs.size() > shown) text += fmt::format("  ... {} repairs in all; --json lists every one\n", repairs.size());
  if (moved > 0) text += fmt::format("  the points that were made lie up to {:.3g} away from their exact places\n", moved);
  for (const std::string& each : written.lost) text += "  not written: " + each + "\n";
  for (const std::string& remark : input.remarks) text += "  " + remark + "\n";
  write_output("", text);
  return exit_success;
}

}  // namespace

void add_convert(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Write an input in another format; repair it on request, and say what was done");
  command->add_option("IN", options->file, "The input: .poly, .smesh, .off, .obj, .stl, .ply, .mesh, .edg")->required();
  command->add_option("OUT", options->output, "What to write: .poly, .smesh, .off, .obj")->required();
  command->add_option("--merge", options->merge, "exact: vertices with bit-identical positions become one; off: they stay (the corners of .stl are always merged so, there being no vertices)")
      ->check(CLI::IsMember({"exact", "off"}))->option_text("exact|off");
  command->add_option("--facets", options->facets, "triangulate: polygons that are not flat, exactly, become triangles; keep: they stay")
      ->check(CLI::IsMember({"triangulate", "keep"}))->option_text("triangulate|keep");
  command->add_flag("--split-crossings", options->split, "In the plane: segments that cross get a common vertex, at the crossing's nearest double");
  add_json_option(*command, selection);
  command->footer(
      "Examples:\n  confidel convert examples/w3.smesh w3.off\n  confidel convert examples/bent.off flat.off --facets triangulate\n"
      "  confidel convert examples/crossing.poly planar.poly --split-crossings");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_convert(*options); };
  });
}

}  // namespace confidel
