// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/algebraic.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "apps/command.h"
#include "apps/meter.h"
#include "apps/style.h"
#include "core/io/read.h"
#include "proofs/lemmas/algebraic.h"
#include "proofs/lemmas/algebraic_instance.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

std::string slack_text(const LemmaResult& result) { return result.slack ? fmt::format("{:.6g}", result.slack->rounded) : "-"; }

Json json_of(const LemmaResult& result) {
  Json entry{{"objects", result.objects}, {"failures", result.failures}, {"slack", nullptr}};
  if (result.failure) entry["first_failure"] = result.failure->object;
  if (result.slack) {
    entry["slack"] = result.slack->rounded;
    entry["object"] = result.slack->place.object;
  }
  return entry;
}

Json json_of(const AlgebraicReport& report, const AlgebraicOptions& options) {
  Json parameters = Json::object(), lemmas = Json::array(), equalities = Json::array();
  for (const auto& [name, value] : report.parameters) parameters[name] = value;
  for (const AlgebraicRow& row : report.lemmas) {
    Json entry{{"id", row.id}, {"verdict", !row.skipped.empty() ? "not tested" : row.exact.failures == 0 ? "holds" : "FAILS"}};
    if (!row.skipped.empty()) {
      entry["reason"] = row.skipped;
    } else {
      entry.update(json_of(row.exact));
      entry["equalities"] = row.equalities;
      entry["rational"] = row.rational ? json_of(*row.rational) : Json();
    }
    lemmas.push_back(entry);
  }
  for (const AlgebraicEquality& equality : report.equalities)
    equalities.push_back({{"statement", equality.statement}, {"objects", equality.objects}, {"exact", equality.exact}, {"everywhere", equality.everywhere}, {"rational_deviation", equality.rational}});
  return {{"file", options.file}, {"strategy", options.strategy}, {"beta", options.beta}, {"good", report.holds()}, {"refutes", report.refutes}, {"points", report.points},
          {"cells", report.cells}, {"filled", report.filled}, {"exact_signs", report.exact_signs}, {"parameters", parameters}, {"lemmas", lemmas}, {"equalities", equalities}};
}

void print(const AlgebraicReport& report, const AlgebraicOptions& options) {
  fmt::print("{}, {}{}: {} points, {} cells{}\n", options.file, options.strategy, options.beta.empty() ? "" : ", beta = " + options.beta + " phi", report.points, report.cells,
             !report.refutes.empty() ? ", those that refute " + report.refutes : report.filled ? "" : ", the buffer zones alone");
  for (const auto& [name, value] : report.parameters) fmt::print("  {:3} = {}\n", name, value);
  fmt::print("{:8} {:>8} {:>9} {:>11} {:>12} {:>12}\n", "lemma", "objects", "failures", "equalities", "slack", "rational");
  for (const AlgebraicRow& row : report.lemmas)
    if (!row.skipped.empty())
      fmt::print("{:8} not tested: {}\n", row.id, row.skipped);
    else
      fmt::print("{:8} {:8} {:9} {:11} {:>12} {:>12}{}\n", row.id, row.exact.objects, row.exact.failures, row.equalities, slack_text(row.exact), row.rational ? slack_text(*row.rational) : "-",
                 row.exact.failure ? "  FAILS first at " + row.exact.failure->object : "");
  fmt::print("{:67} {:>8} {:>8} {:>10}\n", "with \"=\" in the paper", "objects", "exactly", "rational");
  for (const AlgebraicEquality& equality : report.equalities)
    fmt::print("{:67} {:8} {:8} {:10.2g}\n", equality.statement, equality.objects, equality.exact, equality.rational);
}

int undecided(const AlgebraicOptions& options, const std::string& why, const std::string& said) {
  const std::string verdict = "s UNDECIDED " + why;
  if (!said.empty()) fmt::print(stderr, "confidel: {}\n", said);
  if (options.json) fmt::print("{}\n", Json{{"file", options.file}, {"verdict", verdict}, {"exit", static_cast<int>(exit_undecided)}}.dump(2));
  fmt::print(options.json ? stderr : stdout, "{}\n", styled_verdict(verdict, options.json ? stderr : stdout));
  return exit_undecided;
}

}  // namespace

int decide_algebraically(bool json) {
  bool good = true;
  Json list = Json::array();
  for (const AlgebraicResult& result : decide_extremal_statements()) {
    good = good && result.holds;
    if (json)
      list.push_back({{"id", result.id}, {"statement", result.statement}, {"settles", result.settles}, {"comparisons", result.comparisons}, {"holds", result.holds}});
    else
      fmt::print("{}: {} ({} exact comparisons)\n  {}\n  settles {}\n", result.id, result.holds ? "holds" : "FAILS", result.comparisons, result.statement, result.settles);
  }
  const AlgebraicCorner corner = tetrahedron_corner();
  const std::pair<const char*, bool> facts[] = {{"H-ball with |p-v| = r", corner.on_sphere}, {"L1 with b = h", corner.spacing_is_h}, {"right angles at m", corner.right_angles},
                                                {"L9", corner.end_cells_empty}, {"L10", corner.spokes_miss_caps}, {"L11", corner.spokes_empty}};
  Json of_corner{{"points", corner.points}, {"T", corner.end_cells}, {"S", corner.spoke_cells}};
  std::string text;
  for (const auto& [name, holds] : facts) {
    good = good && holds;
    of_corner[name] = holds;
    text += fmt::format("  {}: {}\n", name, holds ? "holds" : "FAILS");
  }
  of_corner["slack"] = {{"L9", corner.end_cell_slack}, {"L10", corner.cap_slack}, {"L11", corner.spoke_slack}};
  if (json)
    fmt::print("{}\n", Json{{"good", good}, {"statements", list}, {"tetrahedron_corner", of_corner}}.dump(2));
  else
    fmt::print("A vertex of the regular tetrahedron, arc points exactly on the sphere ({} points, {} cells T, {} cells S):\n{}  smallest P/R^2: L9 {:.6g}, L10 {:.6g}, L11 {:.6g}\n",
               corner.points, corner.end_cells, corner.spoke_cells, text, corner.end_cell_slack, corner.cap_slack, corner.spoke_slack);
  return good ? exit_success : exit_refuted;
}

int check_algebraically(const AlgebraicOptions& options) {
  const Complex complex = build_complex(read_input(options.file), options.build).complex;
  if (complex.dimension == 2) {
    fmt::print(stderr, "confidel: error[E-USAGE]: --kernel algebraic is for inputs of dimension 3; {} is planar, and there the rational points lie exactly on their circles\n", options.file);
    return exit_bad_input;
  }
  std::optional<Meter> meter(std::in_place, 0, 0, true);
  try {
    const AlgebraicReport report = check_algebraically(complex, options.rule, {options.max_points, 1}, *meter);
    meter.reset();  // the line of progress, if there is one, goes
    if (options.json)
      fmt::print("{}\n", json_of(report, options).dump(2));
    else
      print(report, options);
    return report.holds() ? exit_success : exit_refuted;
  } catch (const LimitReached& limit) {
    std::string why = fmt::format("{} reached={}", limit.what(), limit.points_reached);
    if (meter->estimate() > 0) why += fmt::format(" estimate={:.0f}", meter->estimate());
    return undecided(options, why, "");
  } catch (const StrategyFailed& failure) {
    return undecided(options, "strategy-failed", failure.what());
  } catch (const AlgebraicLimit& limit) {
    return undecided(options, "algebraic-degree", limit.what());
  }
}

}  // namespace confidel
