// SPDX-License-Identifier: GPL-3.0-or-later
// confidel conform FILE -o OUT.cert: places Steiner points, writes the certificate, and has it checked by the checker program.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "apps/audit_report.h"
#include "apps/checker_process.h"
#include "apps/command.h"
#include "apps/interrupt.h"
#include "apps/meter.h"
#include "apps/style.h"
#include "core/complex/build.h"
#include "core/features/features.h"
#include "core/io/read.h"
#include "core/placement/conforming_mesh.h"
#include "core/placement/global.h"
#include "core/placement/graded.h"
#include "core/placement/lean.h"
#include "core/placement/planar.h"
#include "core/placement/saalfeld.h"
#include "proofs/certificate/writer.h"

namespace confidel {

namespace {

using Json = nlohmann::ordered_json;

struct ConformOptions {
  std::string file, output, strategy = "lean", beta, claims;
  double max_circumradius = 0;  ///< exactly this double; 0: no bound
  GlobalRule rule;  ///< of paper and repaired
  std::string mesh, keep = "hull";
  bool exact_text = false;
  BuildOptions build;
  long max_points = 3'000'000;
  double time_limit = 0;
  std::size_t memory_limit = 0;
  int threads = 0;
  bool json = false, quiet = false;
};

struct Run {
  explicit Run(const ConformOptions& given) : options(given), meter(given.time_limit, given.memory_limit, !given.quiet) {}

  const ConformOptions& options;
  Meter meter;
  Json report;
  Json seconds = Json::object();
  double stage_start = 0;

  void finish_stage(const char* name) {
    const double now = meter.elapsed();
    seconds[name] = now - stage_start;
    stage_start = now;
  }

  // The last line belongs to the reader of the text; a JSON document stands alone on standard output.
  int finish(const std::string& verdict, int code) {
    seconds["total"] = meter.elapsed();
    report["seconds"] = seconds;
    report["peak_memory_bytes"] = peak_memory();
    report["verdict"] = verdict;
    report["exit"] = code;
    if (options.json) {
      fmt::print("{}\n", report.dump(2));
      fmt::print(stderr, "{}\n", styled_verdict(verdict, stderr));
    } else {
      fmt::print("{}\n", styled_verdict(verdict, stdout));
    }
    return code;
  }

  template <class... Arguments>
  void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (!options.json && !options.quiet) fmt::print(format, std::forward<Arguments>(arguments)...);
  }
};

// What a refuted statement says of its cell.
const char* explanation(const std::string& statement) {
  if (statement == "L5") return "the protectors of two edges cross";
  if (statement == "L18") return "no sphere through a triangle of a buffer zone is empty, whatever points are added";
  return "the smallest sphere through a triangle of a buffer zone contains a point";
}

void describe(Run& run, const Placement& placement, const CertificateSummary& summary) {
  std::map<std::string, long> kinds, cells;
  for (const PlacedPoint& point : placement.points)
    if (point.kind != PointKind::vertex) ++kinds[name_of(point.kind)];
  for (const PlacedCell& cell : placement.cells) ++cells[std::string(1, name_of(cell.kind))];
  long steiner = 0;
  std::string by_kind;
  for (const auto& [kind, count] : kinds) {
    steiner += count;
    by_kind += fmt::format("{}{} {}", by_kind.empty() ? "" : ", ", count, kind);
  }
  run.report["steiner_points"] = steiner;
  run.report["points_by_kind"] = kinds;
  run.report["cells"] = placement.cells.size();
  run.report["cells_by_kind"] = cells;
  run.report["estimated_points"] = std::llround(run.meter.estimate());
  run.report["certificate"] = {{"file", run.options.output}, {"bytes", summary.file_bytes}, {"text_bytes", summary.text_bytes}};
  run.report["complex_sha256"] = summary.complex_sha256;
  if (placement.refutation) {
    run.report["refutes"] = placement.refutation->statement;
    run.say("strategy {} is refuted on this input: {}. The certificate holds the cell, its witnesses and no more\n", run.options.strategy,
            explanation(placement.refutation->statement));
  }
  run.say("strategy {}: {} Steiner points{}{}{}, {} cells\n", run.options.strategy, steiner, by_kind.empty() ? "" : " (", by_kind,
          by_kind.empty() ? "" : ")", placement.cells.size());
  run.say("certificate: {} ({} bytes)\ncomplex: SHA-256 {}\n", run.options.output, summary.file_bytes, summary.complex_sha256);
}

/// Of all angles between segments, segments and facets, facets; null if there is none.
Json smallest_angle(const Features& features) {
  double least = std::numbers::pi;
  for (const auto* angles : {&features.segment_angle, &features.facet_angle})
    for (const auto& ends : *angles) least = std::min({least, static_cast<double>(ends[0]), static_cast<double>(ends[1])});
  for (const double angle : features.dihedral_angle) least = std::min(least, angle);
  return least < 3.14159 ? Json(least * (180 / std::numbers::pi)) : Json();
}

int undecided(Run& run, const std::string& why, long reached) {
  run.finish_stage("placement");
  run.report["points_reached"] = reached;
  if (run.meter.estimate() > 0) run.report["estimated_points"] = std::llround(run.meter.estimate());
  run.say("stopped at {} points; no certificate was written\n", reached);
  std::string verdict = fmt::format("s UNDECIDED {} reached={}", why, reached);
  if (run.meter.estimate() > 0) verdict += fmt::format(" estimate={:.0f}", run.meter.estimate());
  return run.finish(verdict, exit_undecided);
}

CertificateNotes notes_of(const ConformOptions& options) {
  CertificateNotes notes{{"strategy", options.strategy}};
  if (!options.beta.empty()) notes.emplace_back("beta", options.beta);
  if (options.max_circumradius > 0) notes.emplace_back("max-circumradius", fmt::format("{}", options.max_circumradius));
  notes.emplace_back("tool", "confidel " CONFIDEL_VERSION);
  return notes;
}

int check(Run& run, const Complex& complex) {
  const ConformOptions& options = run.options;
  // The complex as `confidel canonical` spells it: the certificate must be about this input, not about what it embeds.
  const PartialFile complex_file(options.output + ".plc");
  write_output(complex_file.name(), canonical_text(complex));
  run.meter.at("checking", 0);
  const CheckerRun checker = run_checker(options.output, complex_file.name(), options.threads, run.meter.time_left(), options.memory_limit);
  run.finish_stage("check");
  const Json report = Json::parse(checker.report, nullptr, false);
  run.report["checker"] = report.is_discarded() ? Json() : report;
  if (report.is_object() && report.contains("smallest-relative-power")) {
    const Json& power = report["smallest-relative-power"];
    run.report["smallest_relative_power"] = power.is_object() ? power["value"] : power;
    if (power.is_object())
      run.say("checked by confidel-check: smallest relative power off-plane {} (cell of line {}, point {})\n", power["value"].dump(),
              power["cell-line"].dump(), power["point"].dump());
  }
  std::string stages;
  for (const auto& [name, value] : run.seconds.items()) stages += fmt::format("{}{} {:.2f} s", stages.empty() ? "" : ", ", name, value.get<double>());
  run.say("{}; peak memory {} MB\n", stages, peak_memory() >> 20);
  if (checker.exit_code == exit_success || checker.exit_code == exit_refuted || checker.exit_code == exit_undecided || checker.exit_code == exit_interrupted)
    return run.finish(checker.verdict, checker.exit_code);
  // Our own certificate must never be rejected: that is our fault, whatever the input.
  fmt::print(stderr, "confidel: error[E-INTERNAL]: the checker does not accept the certificate that was written to {}; please report it with {}\n",
             options.output, options.file);
  return run.finish(checker.verdict, exit_internal);
}

/// Writes the mesh and judges what was written: rounded points are others than those that the certificate is about.
void write_mesh(Run& run, const Input& input, const BuiltComplex& built, const Placement& placement) {
  const ConformOptions& options = run.options;
  run.meter.at("meshing", 0);
  const ConformingMesh made = conforming_mesh(built.complex, input, placement, options.keep == "regions" ? Keep::regions : Keep::hull, options.exact_text);
  Json report{{"files", Json::array()}, {"points", made.mesh.points.size()}, {"faces", made.mesh.faces.size()}, {"tetrahedra", made.mesh.tetrahedra.size()}, {"exact", options.exact_text}};
  for (const auto& [path, text] : mesh_files(made.mesh, options.mesh)) {
    write_output(path, text);
    report["files"].push_back(path);
  }
  const Audit audit = audit_mesh(built.complex, made.mesh, default_nearness(made.mesh));
  const auto holding = [](const std::vector<AuditedPart>& parts) {
    return std::count_if(parts.begin(), parts.end(), [](const AuditedPart& part) { return part.standing == Standing::holds; });
  };
  report["rounded"] = {{"moved_points", made.moved},          {"greatest_move", made.greatest_move},          {"turned_elements", made.inverted},
                       {"conforms", audit.conforms()},        {"segments_that_hold", holding(audit.segments)}, {"facets_that_hold", holding(audit.facets)}};
  report["remarks"] = made.remarks;
  run.report["mesh"] = report;
  run.finish_stage("mesh");
  run.say("mesh: {}: {} points, {} faces, {} tetrahedra\n", options.mesh, made.mesh.points.size(), made.mesh.faces.size(), made.mesh.tetrahedra.size());
  for (const std::string& remark : made.remarks) run.say("  {}\n", remark);
  const std::string verdict = audit.conforms() ? "it still conforms, exactly"
                                               : fmt::format("exactly, {} of {} segments and {} of {} facets still conform", holding(audit.segments), audit.segments.size(),
                                                             holding(audit.facets), audit.facets.size());
  if (made.moved == 0) run.say("  all points are doubles: {}\n", verdict);
  else run.say("  {} points are no doubles and {} by up to {:.3g}; of the rounded mesh, {}{}\n", made.moved, options.exact_text ? "would move" : "moved", made.greatest_move, verdict,
               made.inverted > 0 ? fmt::format("; {} elements were turned around", made.inverted) : std::string());
}

// One place for all strategies.
Placement place(Run& run, const Complex& complex, const Features& features) {
  const ConformOptions& options = run.options;
  Limits limits;
  limits.max_points = options.max_points;
  limits.threads = options.threads;
  if (options.strategy == "graded") return place_graded(complex, features, limits, run.meter);
  if (options.strategy == "saalfeld") return place_saalfeld(complex, features, limits, run.meter);
  if (!options.rule.name.empty() && complex.dimension == 2) {
    PlanarOptions planar{options.rule, {}};
    if (options.max_circumradius > 0) planar.greatest_circumradius = mpq_class(options.max_circumradius);
    return place_planar(complex, features, planar, limits, run.meter);
  }
  if (!options.rule.name.empty()) return place_global(complex, features, options.rule, limits, run.meter);
  LeanReport lean;
  Placement placement = place_lean(complex, features, limits, run.meter, &lean);
  run.report["lean"] = {{"placed", lean.placed}, {"removed", lean.removed}, {"protected_vertices", lean.protected_vertices},
                        {"protected_segments", lean.protected_segments}, {"protected_by_graded", lean.fell_back}, {"reason", lean.reason}};
  if (lean.fell_back) run.say("lean: {}; the whole input is protected as the graded strategy does\n", lean.reason);
  return placement;
}

int run_conform(const ConformOptions& options) {
  Run run(options);
  run.report["file"] = options.file;
  run.report["strategy"] = options.strategy;
  if (!options.beta.empty()) run.report["beta"] = options.beta;
  run.report["threads"] = options.threads;
  run.meter.at("reading", 0);
  if (!options.mesh.empty()) {
    Mesh probe;  // A wrong suffix is said before the work.
    probe.exact.resize(options.exact_text ? 1 : 0);
    mesh_files(probe, options.mesh);
  }
  const Input input = read_input(options.file);
  const BuiltComplex built = build_complex(input, options.build);
  const Complex& complex = built.complex;
  run.report["dimension"] = complex.dimension;
  run.report["vertices"] = complex.vertices.size();
  run.report["segments"] = complex.segments.size();
  run.report["facets"] = complex.facets.size();
  run.say("{}: {} vertices, {} segments, {} facets\n", options.file, complex.vertices.size(), complex.segments.size(), complex.facets.size());
  run.finish_stage("read");
  if (complex.dimension == 3 && (options.strategy == "saalfeld" || options.max_circumradius > 0)) {
    fmt::print(stderr, "confidel: error[E-USAGE]: {} is for planar inputs; {} is of dimension 3\n",
               options.strategy == "saalfeld" ? "--strategy saalfeld" : "--max-circumradius", options.file);
    return exit_bad_input;
  }
  run.meter.at("measuring features", 0);
  const Features features = compute_features(complex);
  run.report["smallest_angle_degrees"] = smallest_angle(features);
  run.finish_stage("features");

  Placement placement;
  try {
    placement = place(run, complex, features);
  } catch (const LimitReached& limit) {
    return undecided(run, run.meter.reason() != nullptr ? run.meter.reason() : limit.what(), limit.points_reached);
  } catch (const StrategyFailed& failure) {
    fmt::print(stderr, "confidel: {}\n", failure.what());
    return undecided(run, "strategy-failed", 0);
  } catch (const std::range_error& range) {
    fmt::print(stderr, "confidel: {}\n", range.what());
    return undecided(run, "range", 0);
  }
  // Lean's own are what `conforms` consists of: its certificates stay within what every checker knows.
  if (!placement.refutation && (options.claims == "conforms" || (options.claims.empty() && options.strategy == "lean"))) {
    placement.claims.clear();
    placement.parameters = Parameters();
    placement.insertions.clear();
  }
  run.report["claims"] = placement.claims;
  run.finish_stage("placement");
  run.meter.at("writing", static_cast<long>(placement.points.size()));
  {
    const PartialFile partial(options.output);
    const CertificateSummary summary =
        write_certificate(options.output, partial.name(), complex, placement,
                          notes_of(options));
    run.finish_stage("write");
    describe(run, placement, summary);
  }
  if (!options.mesh.empty() && !placement.refutation) write_mesh(run, input, built, placement);
  placement = Placement();
  return check(run, complex);
}

GlobalRule rule_of(const ConformOptions& options) {
  if (options.max_circumradius > 0 && options.strategy != "paper" && options.strategy != "repaired")
    throw CLI::ValidationError("--max-circumradius", "is for --strategy repaired or paper");
  return confidel::rule_of(options.strategy, options.beta);
}

}  // namespace

GlobalRule rule_of(const std::string& strategy, const std::string& beta) {
  if (!beta.empty() && strategy != "paper") throw CLI::ValidationError("--beta", "is for --strategy paper only");
  if (strategy == "repaired") return repaired_rule();
  if (strategy != "paper") return {};
  if (beta.empty()) return paper_rule();
  mpq_class share;
  if (beta.size() > 20 || beta.find_first_not_of("0123456789/") != std::string::npos || share.set_str(beta, 10) != 0 || share.get_den() == 0)
    throw CLI::ValidationError("--beta", "a part such as 1/3 is expected");
  share.canonicalize();
  try {
    return paper_rule(share);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--beta", error.what());
  }
}

void add_conform(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<ConformOptions>();
  CLI::App* command = app.add_subcommand(
      "conform", "Place Steiner points so that the Delaunay triangulation conforms; write a certificate and have it checked");
  command->add_option("FILE", options->file, "The input: .poly, .smesh, .off, .obj, .stl, .ply, .mesh")->required();
  command->add_option("-o,--output", options->output, "The certificate: .cert, or .cert.zst (compressed)")->required();
  command->add_option("--strategy", options->strategy,
                  "lean: as few points as possible; graded: the paper's strategy made local, protects everything; "
                  "repaired: the paper's with its parameters repaired, paper: with those printed (these two end by showing where it fails); "
                  "saalfeld: edge refinement only (planar inputs)")
      ->check(CLI::IsMember(strategy_names()))->capture_default_str();
  command->add_option("--beta", options->beta, "With --strategy paper: the angle of an edge's protectors at its ends as a part of phi, such as 1/3, instead of what is printed")
      ->option_text("P/Q");
  command->add_option("--max-circumradius", options->max_circumradius, "Planar inputs with --strategy repaired or paper: no circumradius is greater (Theorem 2.1)")
      ->check(CLI::PositiveNumber);
  command->add_option("--claims", options->claims,
                      "lemmas: claim every lemma that holds for the strategy (default, but not of lean); conforms: claim conformity only, which confidel-check-verified knows too")
      ->check(CLI::IsMember({"lemmas", "conforms"}));
  command->add_option("--mesh", options->mesh, "Write the Delaunay mesh too: .vtu, .node (with .ele, .face, .edge), .mesh, .off (the facets only)");
  command->add_option("--keep", options->keep, "Of the mesh: hull: the whole convex hull; regions: without the outside and the holes of the input")
      ->check(CLI::IsMember({"hull", "regions"}))->option_text("hull|regions");
  command->add_flag("--exact-text", options->exact_text, "The mesh's coordinates as rationals, in .node and .off");
  command->add_option("--max-points", options->max_points, "UNDECIDED when more points are needed; 0: no limit")->check(CLI::NonNegativeNumber)->capture_default_str();
  command->add_option("--time-limit", options->time_limit, "UNDECIDED after this time, such as 90, 90s or 5m")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE));
  command->add_option("--memory-limit", options->memory_limit, "UNDECIDED above this resident memory, such as 512M or 4G")
      ->transform(CLI::AsSizeValue(false));
  command->add_option("-j,--threads", options->threads, "Threads; 0: as many as the machine has. The result does not depend on it")
      ->check(CLI::NonNegativeNumber)->capture_default_str();
  add_build_options(*command, options->build);
  add_json_option(*command, selection);
  command->add_flag("-q,--quiet", options->quiet, "Only the last line");
  command->footer(
      "Examples:\n  confidel conform examples/w3.smesh -o w3.cert\n  confidel conform examples/cube.off -o cube.cert.zst --time-limit 60s --json\n"
      "  confidel conform examples/cube.off -o cube.cert --mesh cube.vtu --keep regions\n\n"
      "Exit codes: 0 verified, 1 refuted (paper, repaired), 2 bad input, 3 undecided, 4 unreadable file, 70 internal error, 130 interrupted.");
  command->callback([options, &selection] {
    options->rule = rule_of(*options);
    if (options->threads == 0) options->threads = std::max(1U, std::thread::hardware_concurrency());
    options->json = selection.json;
    selection.run = [options] { return run_conform(*options); };
  });
}

}  // namespace confidel
