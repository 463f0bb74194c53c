// SPDX-License-Identifier: GPL-3.0-or-later
// confidel shrink FILE --keep WHAT -o SMALL: the smallest input on which conform still does what it does.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/command.h"
#include "apps/meter.h"
#include "apps/shrinking.h"
#include "campaigns/instance.h"
#include "campaigns/shrink.h"
#include "core/io/read.h"

namespace confidel {

Input shrink_with_conform(const Input& input, const ShrinkRequest& request, ConformWorkspace& workspace, double original_seconds) {
  Meter meter(request.time_limit, 0, true);
  ConformSettings settings = request.settings;
  const bool keeps_time_limit = request.behaviour.find("time-limit") != std::string::npos || request.behaviour == "undecided";
  if (!keeps_time_limit) {
    const double allowance = std::max(1.0, 3 * original_seconds);
    settings.time_limit = settings.time_limit > 0 ? std::min(settings.time_limit, allowance) : allowance;
  }
  long trials = 0;
  campaigns::Shrinking shrinking;
  shrinking.keeps = [&](const Input& candidate) {
    meter.at(fmt::format("shrinking: {} trials; {} facets, {} segments, {} vertices", ++trials, candidate.facets.size(), candidate.segments.size(), candidate.vertices.size()).c_str(), 0);
    return shows(workspace.conform(candidate, settings), request.behaviour);
  };
  shrinking.stop = [&] { return meter.stop_requested(0); };
  try {
    return campaigns::shrink(input, shrinking);
  } catch (const std::invalid_argument&) {
    return input;  // it does not do it any more: that is a finding too, and its smallest example is itself
  }
}

namespace {

struct ShrinkOptions {
  std::string file, output;
  ShrinkRequest request;
  bool json = false;
};

int run_shrink(const ShrinkOptions& options) {
  if (!is_behaviour(options.request.behaviour)) {
    fmt::print(stderr, "confidel: error[E-USAGE]: --keep {}: verified, refuted, undecided, rejected or crash, perhaps with `:` and the verdict's next word, or the beginning of the verdict's line (s ...)\n",
               options.request.behaviour);
    return exit_bad_input;
  }
  const Input input = campaigns::without_unused_vertices(read_input(options.file));
  build_complex(input);  // what is wrong with it is said with its lines
  ConformWorkspace workspace(fmt::format("{}.work-{}", options.output, ::getpid()));
  const ConformRun original = workspace.conform(input, options.request.settings);
  if (!shows(original, options.request.behaviour)) {
    fmt::print(stderr, "confidel: error[E-USAGE]: {}: does not show `{}`; conform says: {}\n", options.file, options.request.behaviour,
               original.verdict.empty() ? "nothing" : original.verdict);
    return exit_bad_input;
  }
  const Input small = shrink_with_conform(input, options.request, workspace, original.seconds);
  const std::string suffix = campaigns::suffix_for(small);
  std::string path = options.output;
  if (path.size() < suffix.size() || path.compare(path.size() - suffix.size(), suffix.size(), suffix) != 0) path += suffix;
  write_output(path, campaigns::input_text(small, "keeps: " + options.request.behaviour));
  if (options.json) {
    const auto counts = [](const std::string& name, const Input& what) {
      return nlohmann::ordered_json{{"file", name}, {"vertices", what.vertices.size()}, {"segments", what.segments.size()}, {"facets", what.facets.size()}};
    };
    fmt::print("{}\n", nlohmann::ordered_json{{"keeps", options.request.behaviour}, {"original", counts(options.file, input)}, {"shrunk", counts(path, small)}}.dump(2));
    return exit_success;
  }
  fmt::print("{}: {} vertices, {} segments, {} facets\n{}: {} vertices, {} segments, {} facets\n", options.file, input.vertices.size(), input.segments.size(),
             input.facets.size(), path, small.vertices.size(), small.segments.size(), small.facets.size());
  return exit_success;
}

}  // namespace

void add_shrink(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<ShrinkOptions>();
  CLI::App* command = app.add_subcommand("shrink", "The smallest valid input on which conform still does what it does with this one");
  command->add_option("FILE", options->file, "The input")->required();
  command->add_option("--keep", options->request.behaviour, "verified, refuted, undecided, rejected or crash, perhaps with the verdict's next word (refuted:L10), or the beginning of its last line")->required();
  command->add_option("-o,--output", options->output, "The small input; without a suffix it gets the one of the format that it needs")->required();
  command->add_option("--strategy", options->request.settings.strategy, "conform's")->check(CLI::IsMember(strategy_names()))->capture_default_str();
  add_conform_limits(*command, options->request.settings);
  command->add_option("--shrink-time", options->request.time_limit, "For all of it, such as 5m; the best so far is written then; 0: no limit")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE))
      ->capture_default_str();
  add_json_option(*command, selection);
  command->footer("Examples:\n  confidel shrink bad.smesh --keep undecided:max-points --max-points 1000 -o small");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_shrink(*options); };
  });
}

}  // namespace confidel
