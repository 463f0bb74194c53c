// SPDX-License-Identifier: GPL-3.0-or-later
// confidel explain NAME: what an error code, a rule, a reason or a lemma means, and what to do about it.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "apps/explanations.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainOptions {
  std::string name;
  bool json = false;
};

Json json(const Explanation& explanation) {
  return {{"name", explanation.name}, {"kind", explanation.kind}, {"meaning", explanation.meaning}, {"advice", explanation.advice}};
}

/// Fills lines of at most 100 columns.
std::string wrapped(std::string_view text, const std::string& indent) {
  constexpr std::size_t width = 100;
  std::string result, line = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (line.size() + 1 + end > width && line.size() > indent.size()) {
      result += line + "\n";
      line = indent;
    }
    if (line.size() > indent.size()) line += ' ';
    line += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result + line + "\n";
}

std::string heading(const Explanation& explanation) {
  if (explanation.kind == "error") return fmt::format("{}\n", explanation.name);
  if (explanation.kind == "rule") return fmt::format("{}: a rule of the checker (docs/certificate-format.md, section 5)\n", explanation.name);
  if (explanation.kind == "reason") return fmt::format("{}: why a run is UNDECIDED\n", explanation.name);
  if (explanation.kind == "claim") return fmt::format("{}: a claim about parameters (docs/lemma-claims.md)\n", explanation.name);
  return fmt::format("{}: a lemma (docs/lemmas.md)\n", explanation.name);
}

/// The first clause; of a lemma, all of it.
std::string_view beginning(const Explanation& explanation) {
  std::string_view text = explanation.meaning;
  if (explanation.kind == "lemma") return text;
  for (const char* end : {". ", ": ", "; "}) text = text.substr(0, text.find(end));
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

int list_all(bool as_json) {
  Json document{{"explanations", Json::array()}};
  std::string text;
  for (const Explanation& explanation : explanations()) {
    document["explanations"].push_back(json(explanation));
    text += fmt::format("{:<20}{:<8}{}\n", explanation.name, explanation.kind, beginning(explanation));
  }
  write_output("", as_json ? document.dump(2) + "\n" : text);
  return exit_success;
}

int run_explain(const ExplainOptions& options) {
  if (options.name.empty()) return list_all(options.json);
  const Explanation* const explanation = find_explanation(options.name);
  if (explanation == nullptr) {
    throw InputError({{"E-USAGE", {"explain", 0, 0}, fmt::format("nothing is named '{}': `confidel explain` lists all names", options.name)}});
  }
  if (options.json) {
    write_output("", json(*explanation).dump(2) + "\n");
    return exit_success;
  }
  std::string text = heading(*explanation) + wrapped(explanation->meaning, "  ");
  if (!explanation->advice.empty()) text += wrapped(explanation->advice, "  ");
  write_output("", text);
  return exit_success;
}

}  // namespace

void add_explain(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = app.add_subcommand("explain", "Say what an error code, a rule of the checker, a reason of UNDECIDED or a lemma means");
  command->add_option("NAME", options->name, "Such as E-NONCOPLANAR, emptiness, max-points, L12; without it: a list of all");
  add_json_option(*command, selection);
  command->footer("Examples:\n  confidel explain E-NONCOPLANAR\n  confidel explain L12\n  confidel explain");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_explain(*options); };
  });
}

}  // namespace confidel
