// SPDX-License-Identifier: GPL-3.0-or-later
// confidel paper: every statement of the paper, with a verdict that is computed now, on inputs that the program carries with it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "apps/bundled_inputs.h"
#include "apps/checker_process.h"
#include "apps/command.h"
#include "apps/interrupt.h"
#include "apps/meter.h"
#include "apps/paper_statements.h"
#include "core/complex/build.h"
#include "core/features/features.h"
#include "core/io/read.h"
#include "core/placement/global.h"
#include "core/placement/pencil.h"
#include "core/placement/planar.h"
#include "core/tetrahedra/delaunay.h"
#include "proofs/certificate/writer.h"
#include "proofs/lemmas/lemma.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

struct PaperOptions {
  std::string folder;
  bool json = false;
};

// Everything that is repaired and checked. The planar one also with a bound of circumradii.
const char* const repaired_inputs[] = {"tetrahedron.off", "cube.off", "fan.off", "fan-skew.off", "flagpole.obj", "corner-45.poly"};
constexpr double bound_in_the_plane = 0.5;
constexpr long most_points = 100'000;

struct Run {
  Counterexample what;
  std::string strategy, verdict;
  std::size_t points = 0, cells = 0;
  int exit_code = exit_internal;
};

// A lemma over all repaired runs.
struct Total {
  long objects = 0, failures = 0;
  std::optional<double> slack;
  std::string where;
};

class Audit {
 public:
  explicit Audit(const PaperOptions& options) : options_(options), meter_(0, 0, true) {}

  int report() {
    for (const char* name : repaired_inputs) repaired(name);
    for (const PaperStatement& statement : paper_statements())
      for (const Counterexample& example : statement.against)
        if (find(example) == nullptr) runs_.push_back(run(example, "paper", example.beta.empty() ? paper_rule() : paper_rule(mpq_class(example.beta))));
    Json table = Json::array();
    for (const PaperStatement& statement : paper_statements()) table.push_back(judge(statement));
    Json list = Json::array();
    bool sound = true;
    for (const Run& r : runs_) {
      list.push_back({{"input", r.what.input}, {"strategy", r.strategy}, {"beta", r.what.beta}, {"points", r.points}, {"cells", r.cells}, {"checker", r.verdict}});
      sound = sound && (r.exit_code == exit_success || r.exit_code == exit_refuted);
    }
    if (options_.json)
      fmt::print("{}\n", Json{{"statements", table}, {"runs", list}}.dump(2));
    else
      print(table, list);
    return sound ? exit_success : exit_internal;
  }

 private:
  void repaired(const std::string& name) {
    const Run result = run({name, ""}, "repaired", repaired_rule());
    runs_.push_back(result);
    for (const std::string& id : last_.claims) {
      const LemmaResult found = evaluate(find_lemma(id), last_instance_);
      Total& total = totals_[id];
      total.objects += found.objects;
      total.failures += found.failures;
      if (!found.slack || (total.slack && *total.slack <= found.slack->rounded)) continue;
      total.slack = found.slack->rounded;
      total.where = name;
    }
    const Parameters& p = last_.parameters;
    ratio_ = std::min(ratio_, mpq_class(*p.radius / *p.spacing).get_d());
    for (const EndCell& cell : last_instance_.end_cells) {
      const RationalVector &m = last_instance_.positions[cell.m], &a = last_instance_.positions[cell.a];
      mpq_class square = 0;
      for (int axis = 0; axis < 3; ++axis) square += (a[axis] - m[axis]) * (a[axis] - m[axis]);
      offset_ = std::min(offset_, std::sqrt(mpq_class(square / (*p.spacing * *p.spacing)).get_d()));
    }
  }

  // Places, writes, and has it checked by the checker program.
  Run run(const Counterexample& what, const std::string& strategy, const GlobalRule& rule) {
    meter_.at(what.input.c_str(), 0);
    const Complex complex = build_complex(read_input_text(what.input, bundled_input(what.input)), {}).complex;
    const Features features = compute_features(complex);
    const Limits limits{most_points, 1};
    if (complex.dimension == 2) {
      PlanarOptions planar{rule, {}};
      if (strategy == "repaired") planar.greatest_circumradius = mpq_class(bound_in_the_plane);
      last_ = place_planar(complex, features, planar, limits, meter_);
    } else {
      last_ = place_global(complex, features, rule, limits, meter_);
    }
    last_instance_ = instance_of(complex, last_, true);
    std::string name = what.input.substr(0, what.input.find('.')) + '-' + strategy;
    if (!what.beta.empty()) name += '-' + what.beta;
    std::replace(name.begin(), name.end(), '/', '-');
    const std::filesystem::path folder = options_.folder.empty() ? std::filesystem::temp_directory_path() : std::filesystem::path(options_.folder);
    const std::string kept = (folder / (name + ".cert")).string();
    const PartialFile unkept(kept + ".unkept"), partial(kept), complex_file(kept + ".plc");
    const std::string path = options_.folder.empty() ? unkept.name() : kept;
    write_certificate(path, partial.name(), complex, last_, {{"strategy", strategy}, {"tool", "confidel " CONFIDEL_VERSION}});
    write_output(complex_file.name(), canonical_text(complex));
    const CheckerRun checked = run_checker(path, complex_file.name(), 1, 0, 0);
    return {what, strategy, checked.verdict, last_.points.size(), last_.cells.size(), checked.exit_code};
  }

  const Run* find(const Counterexample& example) const {
    for (const Run& r : runs_)
      if (r.strategy == "paper" && r.what == example) return &r;
    return nullptr;
  }

  Json judge(const PaperStatement& statement) const {
    std::vector<std::string> evidence;
    bool holds = true, refuted = false, tested = false;
    for (const Counterexample& example : statement.against) {
      const Run* r = find(example);
      if (r == nullptr || r->exit_code != exit_refuted) continue;
      refuted = true;
      evidence.push_back(fmt::format("{}{}: {}", example.input, example.beta.empty() ? " as printed" : ", beta = " + example.beta + " phi", r->verdict.substr(2)));
    }
    for (const std::string& id : statement.lemmas) {
      const auto place = totals_.find(id);
      if (place == totals_.end()) continue;
      const Total& total = place->second;
      tested = tested || total.objects > 0;
      holds = holds && total.failures == 0;
      evidence.push_back(fmt::format("{}{} {} on {} objects{}", statement.against.empty() ? "" : "repaired: ", id, total.failures == 0 ? "holds" : "fails",
                                     total.objects, total.slack ? fmt::format(", slack {:.3g} ({})", *total.slack, total.where) : ""));
    }
    if (statement.experiment != Experiment::none) {
      tested = true;
      std::string text;
      const bool good = experiment(statement.experiment, text);
      if (statement.experiment == Experiment::ties) refuted = !good;
      holds = holds && good;
      evidence.push_back(text);
    }
    std::string verdict = refuted ? (tested && !statement.lemmas.empty() && holds ? "refuted; holds repaired" : "refuted") : !tested ? "not tested" : holds ? "holds" : "fails";
    if (!statement.against.empty() && !refuted) verdict = "not refuted";
    return {{"section", statement.section}, {"statement", statement.text}, {"verdict", verdict}, {"evidence", evidence}, {"remark", statement.remark}};
  }

  bool experiment(Experiment which, std::string& text) const {
    if (which == Experiment::radius) {
      text = fmt::format("r/h >= {:.4g} on all repaired runs", ratio_);
      return ratio_ >= 2;
    }
    if (which == Experiment::offset) {
      text = fmt::format("d/h >= {:.4g} on all repaired runs", offset_);
      return offset_ >= 1;
    }
    if (which == Experiment::verdicts) {
      const auto good = std::count_if(runs_.begin(), runs_.end(), [](const Run& r) { return r.strategy == "repaired" && r.exit_code == exit_success; });
      text = fmt::format("{} of {} repaired runs are VERIFIED by confidel-check", good, std::size(repaired_inputs));
      return good == static_cast<long>(std::size(repaired_inputs));
    }
    return which == Experiment::ties ? octahedron(text) : random_points(text);
  }

  static Difference normal_of(const Point& a, const Point& b, const Point& c) {
    const Difference u = difference(b, a), w = difference(c, a);
    return {cross(u.vector, w.vector), u.exponent + w.exponent};
  }

  // The pencil's interval against the exact tetrahedralization, on all triangles of random points.
  static bool random_points(std::string& text) {
    std::mt19937_64 engine(20261122);
    long triangles = 0, faces = 0, disagreements = 0;
    for (int round = 0; round < 100; ++round) {
      std::vector<Point> points;
      for (int i = 0; i < 9; ++i) {
        const auto coordinate = [&] { return static_cast<double>(engine() >> 44) * 0x1p-20; };
        const double x = coordinate(), y = coordinate();
        points.push_back(Point::from_doubles(x, y, coordinate()));
      }
      DelaunayTetrahedralization delaunay;
      for (int i = 0; i < 9; ++i) delaunay.insert(i, points[i]);
      for (int a = 0; a < 9; ++a)
        for (int b = a + 1; b < 9; ++b)
          for (int c = b + 1; c < 9; ++c) {
            const Difference normal = normal_of(points[a], points[b], points[c]);
            std::optional<mpq_class> lower, upper;
            for (int x = 0; x < 9; ++x) {
              const int side = x == a || x == b || x == c ? 0 : orientation(points[a], points[b], points[c], points[x]);
              if (side == 0) continue;
              const mpq_class t = pencil_parameter(points[a], points[b], points[c], points[x], normal);
              if (side < 0 && (!lower || t > *lower)) lower = t;
              if (side > 0 && (!upper || t < *upper)) upper = t;
            }
            const bool empty = !lower || !upper || *lower < *upper, face = delaunay.face(a, b, c).exists;
            ++triangles;
            faces += face;
            disagreements += empty != face;
          }
    }
    text = fmt::format("{} triangles of random points, {} of them faces: {} disagreements with the exact tetrahedralization", triangles, faces, disagreements);
    return disagreements == 0;
  }

  // Triangles through the middle of an octahedron: all other corners lie on their smallest spheres.
  static bool octahedron(std::string& text) {
    std::vector<Point> points;
    for (int axis = 0; axis < 3; ++axis)
      for (double sign : {1.0, -1.0}) points.push_back(Point::from_doubles(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0));
    DelaunayTetrahedralization delaunay;
    for (int i = 0; i < 6; ++i) delaunay.insert(i, points[i]);
    int empty = 0, faces = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (int other = 0; other < 6; ++other) {
        if (other / 2 == axis) continue;
        const int a = 2 * axis, b = 2 * axis + 1;
        bool inside = false;
        for (int x = 0; x < 6; ++x) inside = inside || (x != a && x != b && x != other && diametral_power(points[a], points[b], points[other], points[x]) < 0);
        empty += !inside;
        faces += delaunay.face(a, b, other).exists;
      }
    text = fmt::format("octahedron: {} triangles through its middle have spheres with nothing inside, {} are faces of its tetrahedralization", empty, faces);
    return empty == faces;
  }

  static void print(const Json& table, const Json& list) {
    fmt::print("| section | statement | verdict | evidence |\n|---|---|---|---|\n");
    for (const Json& row : table) {
      std::string evidence;
      for (const Json& item : row["evidence"]) evidence += (evidence.empty() ? "" : "; ") + item.get<std::string>();
      const std::string remark = row["remark"];
      if (!remark.empty()) evidence += ". " + remark;
      fmt::print("| {} | {} | {} | {} |\n", row["section"].get<std::string>(), row["statement"].get<std::string>(), row["verdict"].get<std::string>(), evidence);
    }
    fmt::print("\n| input | parameters | points | cells | confidel-check |\n|---|---|---|---|---|\n");
    for (const Json& r : list) {
      const std::string beta = r["beta"];
      fmt::print("| {} | {}{} | {} | {} | {} |\n", r["input"].get<std::string>(), r["strategy"].get<std::string>(), beta.empty() ? "" : ", beta = " + beta + " phi", r["points"].get<std::size_t>(),
                 r["cells"].get<std::size_t>(), r["checker"].get<std::string>());
    }
  }

  const PaperOptions& options_;
  Meter meter_;
  std::vector<Run> runs_;
  std::map<std::string, Total> totals_;
  Placement last_;
  Instance last_instance_;
  double ratio_ = 1e300, offset_ = 1e300;
};

}  // namespace

void add_paper(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<PaperOptions>();
  CLI::App* command = app.add_subcommand("paper", "Every statement of the paper with its verdict, computed now on inputs that the program carries with it");
  command->add_option("-o,--output", options->folder, "A folder that exists: the certificates are kept there")->check(CLI::ExistingDirectory);
  command->add_flag("--json", options->json, "One JSON document instead of two Markdown tables");
  command->footer("Examples:\n  confidel paper\n\ndocs/paper-audit.md explains the statements. Exit codes: 0 the tables are complete, 4 a file cannot be written, 70 the checker does not accept a certificate.");
  command->callback([options, &selection] { selection.run = [options] { return Audit(*options).report(); }; });
}

}  // namespace confidel
