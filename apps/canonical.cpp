// SPDX-License-Identifier: GPL-3.0-or-later
// confidel canonical FILE [-o OUT]: the input as certificates spell it.
#include <memory>

#include "apps/command.h"
#include "core/complex/build.h"
#include "core/io/read.h"

namespace confidel {

namespace {

struct CanonicalOptions {
  std::string file;
  std::string output;
  BuildOptions build;
};

int run_canonical(const CanonicalOptions& options) {
  const BuiltComplex built = build_complex(read_input(options.file), options.build);
  write_output(options.output, canonical_text(built.complex));
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
  add_build_options(*command, options->build);
  command->callback([options, &selection] { selection.run = [options] { return run_canonical(*options); }; });
}

}  // namespace confidel
