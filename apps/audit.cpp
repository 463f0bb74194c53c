// SPDX-License-Identifier: GPL-3.0-or-later
// confidel audit INPUT MESH: is somebody else's mesh conforming Delaunay? What is not, and by how much.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/audit_report.h"
#include "apps/checker_process.h"
#include "apps/command.h"
#include "apps/interrupt.h"
#include "apps/style.h"
#include "core/io/read.h"
#include "proofs/certificate/writer.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

struct AuditOptions {
  std::string file, mesh, output;
  BuildOptions build;
  double near = -1;
  int threads = 0;
  bool json = false, quiet = false;
};

/// The certificate of what holds, where the user wants it or for the check only; the checker's answer.
CheckerRun certify(const AuditOptions& options, const BuiltComplex& built, const Audit& audit) {
  const bool keep = !options.output.empty();
  const PartialFile unkept((std::filesystem::temp_directory_path() / "confidel-audit.cert").string());
  const std::string path = keep ? options.output : unkept.name();
  const PartialFile temporary(path), complex_file(path + ".plc");
  write_output(complex_file.name(), canonical_text(audit.whole ? built.complex : audit.complex));
  write_certificate(path, temporary.name(), audit.complex, audit.placement, {{"strategy", "none: the points are those of a mesh"}, {"tool", "confidel " CONFIDEL_VERSION}});
  return run_checker(path, complex_file.name(), options.threads, 0, 0);
}

int run_audit(const AuditOptions& options) {
  const Input input = read_input(options.file);
  const BuiltComplex built = build_complex(input, options.build);
  const Mesh mesh = read_mesh(options.mesh);
  const double near = options.near >= 0 ? options.near : default_nearness(mesh);
  const Audit audit = audit_mesh(built.complex, mesh, near);
  const AuditReport report(input, built, mesh, audit, near);

  const CheckerRun checker = certify(options, built, audit);
  std::string verdict = checker.verdict;
  int code = checker.exit_code;
  if (code != exit_success && code != exit_undecided && code != exit_interrupted) {
    fmt::print(stderr, "confidel: error[E-INTERNAL]: the checker does not accept the certificate of what holds ({}); please report it with {} and {}\n", checker.verdict,
               options.file, options.mesh);
    return exit_internal;
  }
  if (audit.fails()) {
    verdict = "s REFUTED conforms " + report.worst_object();
    code = exit_refuted;
  } else if (!audit.conforms()) {
    verdict = "s UNDECIDED no-certificate";
    code = exit_undecided;
  }
  if (options.json) {
    Json document = report.json();
    document["certificate"] = {{"file", options.output}, {"about", audit.whole ? "the input" : "the parts that hold"}, {"verdict", checker.verdict}};
    document["verdict"] = verdict;
    document["exit"] = code;
    fmt::print("{}\n", document.dump(2));
    fmt::print(stderr, "{}\n", styled_verdict(verdict, stderr));
    return code;
  }
  if (!options.quiet) {
    fmt::print("{}", report.text());
    fmt::print("{} {}: {}\n", options.output.empty() ? "a certificate of" : options.output + ", a certificate of",
               audit.whole ? "the whole input" : "the parts that hold, the mesh's other points being vertices", checker.verdict);
  }
  fmt::print("{}\n", styled_verdict(verdict, stdout));
  return code;
}

}  // namespace

void add_audit(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<AuditOptions>();
  CLI::App* command = app.add_subcommand("audit", "Judge another tool's mesh: which segments and facets are unions of Delaunay edges and triangles, exactly");
  command->add_option("INPUT", options->file, "The complex that was meshed: .poly, .smesh, .off, .obj, .stl, .ply, .mesh, .edg")->required();
  command->add_option("MESH", options->mesh, "The mesh: .node with .ele, .face (TetGen, Triangle; the common name will do), medit .mesh, .vtu")->required();
  command->add_option("-o,--output", options->output, "Keep the certificate of what holds here: .cert or .cert.zst");
  command->add_option("--near", options->near, "Points up to this distance off a segment or facet are reported as off it; 1e-9 of the mesh's size by default. The verdict does not depend on it")
      ->check(CLI::NonNegativeNumber);
  command->add_option("-j,--threads", options->threads, "Threads of the checker; 0: as many as the machine has")->check(CLI::NonNegativeNumber);
  add_build_options(*command, options->build);
  add_json_option(*command, selection);
  command->add_flag("-q,--quiet", options->quiet, "Only the last line");
  command->footer(
      "Examples:\n  confidel audit examples/cube.off examples/cube-mesh.node\n  confidel audit examples/cube.off examples/cube-mesh.node -o cube.cert --json\n\n"
      "Exit codes: 0 the mesh's points conform, 1 they do not: witnesses are shown, 2 bad input, 3 undecided, 4 unreadable file, 70 internal error, 130 interrupted.");
  command->callback([options, &selection] {
    options->json = selection.json;
    if (options->threads == 0) options->threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    selection.run = [options] { return run_audit(*options); };
  });
}

}  // namespace confidel
