// SPDX-License-Identifier: GPL-3.0-or-later
// confidel canonical FILE [-o OUT]: the input as certificates spell it.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "core/complex/build.h"
#include "core/io/read.h"

namespace confidel {

namespace {

struct CanonicalOptions {
  std::string file;
  std::string output;
  BuildOptions build;
  bool json = false;
};

int run_canonical(const CanonicalOptions& options) {
  const BuiltComplex built = build_complex(read_input(options.file), options.build);
  const std::string text = canonical_text(built.complex);
  write_output(options.output, text);
  if (options.json) {
    const nlohmann::ordered_json report{{"file", options.file}, {"output", options.output}, {"bytes", text.size()}, {"sha256", sha256(text)}};
    fmt::print("{}\n", report.dump(2));
  }
  return exit_success;
}

}  // namespace

void add_canonical(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<CanonicalOptions>();
  CLI::App* command =
      app.add_subcommand("canonical", "Write the canonical complex of a file (docs/certificate-format.md, section 2)");
  command->add_option("FILE", options->file, "The input: .poly, .smesh, .off, .obj, .stl, .ply, .mesh, .edg")
      ->required();
  command->add_option("-o,--output", options->output, "Where to write it; standard output by default");
  add_json_option(*command, selection);
  add_build_options(*command, options->build);
  command->footer("Examples:\n  confidel canonical examples/w3.smesh -o w3.plc\n  confidel canonical examples/tetrahedron.off");
  command->callback([options, &selection] {
    if (selection.json && options->output.empty()) throw CLI::ValidationError("--json", "standard output cannot hold both: name a file with -o");
    options->json = selection.json;
    selection.run = [options] { return run_canonical(*options); };
  });
}

}  // namespace confidel
