// SPDX-License-Identifier: GPL-3.0-or-later
// confidel lemma list | check | --kernel algebraic: the paper's statements, what of them holds in a certificate, and what only square roots
// can decide. For readers: the verdict is confidel-check's.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/algebraic.h"
#include "apps/command.h"
#include "proofs/lemmas/certificate_instance.h"
#include "proofs/lemmas/lemma.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

struct LemmaOptions {
  std::string id, file, kernel = "rational";
  bool json = false;
  AlgebraicOptions algebraic;
};

int list_lemmas(const LemmaOptions& options) {
  Json list = Json::array();
  for (const Lemma& lemma : all_lemmas()) {
    if (options.json)
      list.push_back({{"id", lemma.id}, {"statement", lemma.statement}, {"section", lemma.section}, {"hypothesis", lemma.hypothesis}, {"exact_form", lemma.exact_form}});
    else
      fmt::print("{}: {}\n  paper: {}; needs: {}\n  exactly: {}\n", lemma.id, lemma.statement, lemma.section, *lemma.hypothesis != 0 ? lemma.hypothesis : "nothing", lemma.exact_form);
  }
  if (options.json) fmt::print("{}\n", list.dump(2));
  return exit_success;
}

/// One row of the table.
struct Row {
  const Lemma* lemma;
  bool claimed = false;
  std::string skipped;  ///< why it was not tested: a parameter is missing, or cells are not of their kinds
  bool wrong_count = false;
  LemmaResult result;

  bool good() const { return skipped.empty() && !wrong_count && result.failures == 0; }
  std::string verdict() const {
    if (!skipped.empty()) return "not tested: " + skipped;
    if (wrong_count) return "claimed for another number of objects";
    return result.failures == 0 ? "holds" : "FAILS";
  }
};

Row test(const Lemma& lemma, const CertificateInstance& given) {
  Row row{&lemma, false, "", false, {}};
  const auto claim = std::find_if(given.claims.begin(), given.claims.end(), [&](const ClaimedLemma& other) { return other.id == lemma.id; });
  row.claimed = claim != given.claims.end();
  try {
    row.result = evaluate(lemma, given.instance);
    row.wrong_count = row.claimed && claim->count != row.result.objects;
  } catch (const MissingParameter& missing) {
    row.skipped = fmt::format("no parameter `{}`", missing.what());
  } catch (const WrongKind& wrong) {
    row.skipped = fmt::format("cell {} is not of its kind", wrong.cell);
  }
  return row;
}

std::string place(const LemmaResult::Place& place) { return place.line > 0 ? fmt::format("{}, line {}", place.object, place.line) : place.object; }

Json json_of(const Row& row) {
  Json entry{{"id", row.lemma->id}, {"claimed", row.claimed}, {"verdict", row.verdict()}};
  if (!row.skipped.empty()) return entry;
  entry["objects"] = row.result.objects;
  entry["failures"] = row.result.failures;
  if (row.result.failure) entry["first_failure"] = {{"object", row.result.failure->object}, {"line", row.result.failure->line}};
  entry["slack"] = nullptr;
  if (const auto& slack = row.result.slack) {
    entry["slack"] = slack->rounded;
    if (slack->exact) entry["exact_slack"] = slack->exact->get_str();
    entry["object"] = slack->place.object;
    entry["line"] = slack->place.line;
  }
  return entry;
}

int check_lemmas(const LemmaOptions& options) {
  std::vector<const Lemma*> lemmas;
  for (const Lemma& lemma : all_lemmas())
    if (options.id == "all" || options.id == lemma.id) lemmas.push_back(&lemma);
  if (lemmas.empty()) {
    fmt::print(stderr, "confidel: error[E-USAGE]: there is no lemma {}; `confidel lemma list` names them, `all` means all\n", options.id);
    return exit_bad_input;
  }
  const CertificateInstance given = instance_of(read_certificate(options.file));
  // All: what is claimed must hold; the rest is for information. One by name: it must hold.
  bool good = true;
  Json list = Json::array();
  if (!options.json) fmt::print("{:8} {:7} {:>9} {:>8} {:>12}  {}\n", "lemma", "claimed", "objects", "failures", "slack", "");
  for (const Lemma* lemma : lemmas) {
    const Row row = test(*lemma, given);
    const bool counts = options.id != "all" || row.claimed || (given.claims.empty() && row.skipped.empty());
    if (counts && !row.good()) good = false;
    if (options.json) {
      list.push_back(json_of(row));
      continue;
    }
    const LemmaResult& result = row.result;
    if (!row.skipped.empty()) {
      fmt::print("{:8} {:7} {}\n", lemma->id, row.claimed ? "yes" : "no", row.verdict());
      continue;
    }
    std::string remark;
    if (row.wrong_count) remark = row.verdict();
    if (result.failure) remark = "FAILS first at " + place(*result.failure);
    if (result.slack && !result.failure) remark = "at " + place(result.slack->place);
    fmt::print("{:8} {:7} {:9} {:8} {:>12}  {}\n", lemma->id, row.claimed ? "yes" : "no", result.objects, result.failures,
               result.slack ? fmt::format("{:.4g}", result.slack->rounded) : "-", remark);
  }
  if (options.json) fmt::print("{}\n", Json{{"file", options.file}, {"good", good}, {"lemmas", list}}.dump(2));
  if (!given.refutes.empty() && !options.json) fmt::print("the certificate refutes {}: confidel-check confirms it\n", given.refutes);
  return good ? exit_success : exit_refuted;
}

}  // namespace

void add_lemma(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<LemmaOptions>();
  CLI::App* command = app.add_subcommand("lemma", "The paper's statements, and what of them holds in a certificate");
  command->require_subcommand(0, 1);
  command->add_option("FILE", options->algebraic.file, "With --kernel algebraic: an input (.smesh, .off, ...), small: the lemmas on the exact points of a global strategy");
  command->add_option("--kernel", options->kernel,
                      "algebraic: with square roots, decided exactly; without FILE the extremal statements, which are about the paper's constants")
      ->check(CLI::IsMember({"rational", "algebraic"}));
  command->add_option("--strategy", options->algebraic.strategy, "With FILE: the parameters: repaired, or the paper's own")
      ->check(CLI::IsMember({"repaired", "paper"}))->capture_default_str();
  command->add_option("--beta", options->algebraic.beta, "With --strategy paper: as for conform")->option_text("P/Q");
  command->add_option("--max-points", options->algebraic.max_points,
                      "With FILE: where the facets' insides need more, they stay empty; UNDECIDED when the buffer zones alone need more; 0: no limit")
      ->check(CLI::NonNegativeNumber)->capture_default_str();
  add_build_options(*command, options->algebraic.build);
  command->add_flag("--json", options->json, "One JSON document");
  command->footer(
      "Examples:\n  confidel lemma list\n  confidel conform examples/fan.off -o fan.cert && confidel lemma check L18 fan.cert\n"
      "  confidel lemma --kernel algebraic examples/tetrahedron.off\n\n"
      "Exit codes: 0 everything holds, 1 something does not, 2 bad input, 3 undecided, 4 unreadable file.");
  command->callback([command, options, &selection] {
    AlgebraicOptions& algebraic = options->algebraic;
    algebraic.json = options->json;
    if (options->kernel == "algebraic" && command->get_subcommands().empty() && algebraic.file.empty()) {
      selection.run = [options] { return decide_algebraically(options->json); };
    } else if (options->kernel == "algebraic" && command->get_subcommands().empty()) {
      selection.json = options->json;
      algebraic.rule = rule_of(algebraic.strategy, algebraic.beta);
      selection.run = [options] { return check_algebraically(options->algebraic); };
    } else if (options->kernel == "algebraic")
      throw CLI::ValidationError("--kernel algebraic", "takes no command: its statements are about the paper's constants and points, not about a certificate");
    else if (command->get_subcommands().empty() && !algebraic.file.empty())
      throw CLI::ValidationError("FILE", "is for --kernel algebraic; `confidel lemma check all CERTIFICATE` tests a certificate");
    else if (command->get_subcommands().empty())
      throw CLI::CallForHelp();
  });
  CLI::App* list = command->add_subcommand("list", "Every statement that can be tested: where it is in the paper, what it needs, its exact form");
  list->add_flag("--json", options->json, "A JSON array");
  list->callback([options, &selection] { selection.run = [options] { return list_lemmas(*options); }; });
  CLI::App* check = command->add_subcommand("check", "Tests one statement, or all, on every object of a certificate, exactly; says where the slack is smallest");
  check->add_option("LEMMA", options->id, "Its name, or `all`")->required();
  check->add_option("CERTIFICATE", options->file, "The certificate, also compressed")->required();
  check->add_flag("--json", options->json, "One JSON document");
  check->footer("Exit codes: 0 it holds (all: what the certificate claims; or everything that can be tested, if it claims no lemma), 1 it does not,\n2 bad input, 4 unreadable file. "
                "This is the producer's own test; confidel-check has another one and gives the verdict.");
  check->callback([options, &selection] { selection.run = [options] { return check_lemmas(*options); }; });
}

}  // namespace confidel
