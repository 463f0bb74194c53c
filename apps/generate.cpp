// SPDX-License-Identifier: GPL-3.0-or-later
// confidel generate FAMILY --seed N -o FILE: a random input of a family.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "campaigns/families.h"
#include "campaigns/instance.h"

namespace confidel {

namespace {

struct GenerateOptions {
  std::string family, output;
  std::uint64_t seed = 0;
  bool list = false, json = false;
};

using Json = nlohmann::ordered_json;

int list_families(bool json) {
  Json list = Json::array();
  for (const campaigns::Family& family : campaigns::families())
    list.push_back({{"family", family.name}, {"dimension", family.dimension}, {"about", family.about}, {"valid", family.valid}});
  if (json) {
    fmt::print("{}\n", Json{{"families", list}}.dump(2));
    return exit_success;
  }
  for (const campaigns::Family& family : campaigns::families())
    fmt::print("{:<20} {}D  {}{}\n", family.name, family.dimension, family.about, family.valid ? "" : " (invalid inputs)");
  return exit_success;
}

int run_generate(const GenerateOptions& options) {
  if (options.list) return list_families(options.json);
  if (options.family != "all" && campaigns::find_family(options.family) == nullptr) {
    fmt::print(stderr, "confidel: error[E-USAGE]: {}no family is called `{}`; `confidel generate --list` names them\n",
               options.family.empty() ? "name a family: " : "", options.family);
    return exit_bad_input;
  }
  const campaigns::Family& family = campaigns::family_for(options.family, options.seed);
  const Input input = campaigns::generate(family, options.seed);
  const std::string text = campaigns::input_text(input, fmt::format("confidel generate {} --seed {}", family.name, options.seed));
  // FILE. or FILE without a suffix gets the one of the format.
  const std::string suffix = campaigns::suffix_for(input);
  std::string path = options.output;
  const auto ends_with = [&](const std::string& end) { return path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0; };
  const std::size_t slash = path.rfind('/') == std::string::npos ? 0 : path.rfind('/') + 1;
  if (!path.empty() && path.find('.', slash) == std::string::npos) path += suffix;
  if (!path.empty() && !ends_with(suffix)) {
    fmt::print(stderr, "confidel: error[E-USAGE]: {}: this input is written as {}: give it that suffix, or none\n", options.output, suffix);
    return exit_bad_input;
  }
  if (options.json && path.empty()) {
    fmt::print(stderr, "confidel: error[E-USAGE]: --json needs -o: standard output holds one thing only\n");
    return exit_bad_input;
  }
  write_output(path, text);
  if (options.json)
    fmt::print("{}\n", Json{{"family", family.name}, {"seed", options.seed}, {"output", path}, {"dimension", input.dimension}, {"vertices", input.vertices.size()}, {"segments", input.segments.size()}, {"facets", input.facets.size()}}.dump(2));
  return exit_success;
}

}  // namespace

void add_generate(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "A random input of a family, the same for the same seed");
  command->add_option("FAMILY", options->family, "A family's name, or all: the seed chooses");
  command->add_option("--seed", options->seed, "A number below 2^64")->check(CLI::NonNegativeNumber)->capture_default_str();
  command->add_option("-o,--output", options->output, "The file: .smesh, .poly or .obj, as the input needs; without a suffix it gets the right one; default: standard output");
  command->add_flag("--list", options->list, "The families");
  add_json_option(*command, selection);
  command->footer("Examples:\n  confidel generate wedge --seed 7 -o wedge.smesh");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_generate(*options); };
  });
}

}  // namespace confidel
