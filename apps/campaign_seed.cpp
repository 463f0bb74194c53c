// SPDX-License-Identifier: GPL-3.0-or-later
// One seed of a campaign: generate, conform, judge; store and shrink what is unexpected.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "apps/campaign.h"
#include "apps/command.h"
#include "apps/shrinking.h"
#include "campaigns/families.h"
#include "campaigns/instance.h"
#include "campaigns/mutators.h"
#include "proofs/certificate/reader.h"
#include "proofs/lemmas/certificate_instance.h"

namespace confidel {

namespace {

using campaigns::Family;

/// An answer that says nothing about the input but its size, or the range of its distances.
bool is_size_limit(const ConformRun& run) {
  return run.outcome == Outcome::undecided && (run.verdict.rfind("s UNDECIDED max-points", 0) == 0 || run.verdict.rfind("s UNDECIDED range", 0) == 0);
}

bool is_expected(const ConformRun& run, const Family& family, const std::string& strategy) {
  if (!family.valid) return run.outcome == Outcome::invalid;
  if (strategy == "saalfeld" && run.outcome == Outcome::invalid) return run.verdict.find("is for planar inputs") != std::string::npos;
  // The paper's own strategy may be refuted, or fail where no lemma speaks: that is what it is there for.
  const bool fails = run.outcome == Outcome::refuted || run.verdict.rfind("s UNDECIDED strategy-failed", 0) == 0;
  return run.outcome == Outcome::verified || is_size_limit(run) || (strategy == "paper" && fails);
}

/// Why two runs of what is the same problem contradict each other; empty if they do not.
std::string contradiction(const ConformRun& one, const ConformRun& other, bool same_points) {
  if (is_size_limit(one) || is_size_limit(other)) return "";
  if (one.outcome != other.outcome) return fmt::format("{} instead of {}", name_of(other.outcome), name_of(one.outcome));
  if (same_points && one.outcome == Outcome::verified && one.report["steiner_points"] != other.report["steiner_points"])
    return fmt::format("{} points instead of {}", other.report["steiner_points"].dump(), one.report["steiner_points"].dump());
  return "";
}

/// The same problem in other words: what each says, and what is wrong.
Json compare_variants(const Input& input, std::uint64_t seed, const ConformRun& original, const ConformSettings& settings,
                      ConformWorkspace& workspace, std::string& fault) {
  campaigns::Random random(seed);
  std::vector<std::pair<const char*, std::optional<Input>>> variants;
  variants.emplace_back("permuted", campaigns::permuted(input, random));
  variants.emplace_back("axes", campaigns::with_permuted_axes(input, random));
  variants.emplace_back("rotated", campaigns::rotated(input, random));
  variants.emplace_back("scaled", campaigns::scaled(input, random.integer(-30, 30)));
  variants.emplace_back("doubled", campaigns::far_union(input, input, random));
  Json result = Json::object();
  for (const auto& [name, variant] : variants) {
    if (!variant) continue;
    const ConformRun run = workspace.conform(*variant, settings);
    result[name] = name_of(run.outcome);
    const std::string difference = contradiction(original, run, std::string_view(name) == "scaled");
    if (!difference.empty() && fault.empty()) fault = fmt::format("{}: {}", name, difference);
  }
  return result;
}

void copy_numbers(const Json& report, Json& record) {
  for (const char* key : {"vertices", "segments", "facets", "steiner_points", "cells", "estimated_points", "points_reached"})
    if (report.contains(key)) record[key] = report[key];
  if (report.contains("smallest_angle_degrees")) record["smallest_angle"] = report["smallest_angle_degrees"];
  if (report.contains("lean") && report["lean"].value("protected_by_graded", false)) record["protected_by_graded"] = true;
  const Json tightest = slacks(report);
  if (!tightest.empty()) record["slacks"] = tightest;
}

/// Everything that somebody needs to see it happen again; complete or not there.
void store_failure(const std::string& store, const Json& record, const std::string& text, const std::string& suffix, const std::string& certificate,
                   const ConformSettings& settings, const Input& input, const ConformRun& run, double shrink_time, ConformWorkspace& workspace) {
  const std::string name = fmt::format("{}-{}-{}", record["family"].get<std::string>(), record["seed"].dump(), record["strategy"].get<std::string>());
  const std::filesystem::path folder = std::filesystem::path(store) / name;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be made: " + error.message());
  std::string command = "confidel conform input" + suffix + " -o input.cert";
  for (const std::string& option : settings.options()) command += " " + option;
  write_output((folder / ("input" + suffix)).string(), text);
  write_output((folder / "command.txt").string(), command + "\n");
  if (!certificate.empty()) write_output((folder / "input.cert").string(), certificate);
  const std::string behaviour = name_of(run.outcome);
  if (shrink_time > 0 && is_behaviour(behaviour) && run.outcome != Outcome::verified) {
    ShrinkRequest request{settings, behaviour, shrink_time};
    const Input small = shrink_with_conform(input, request, workspace, run.seconds);
    write_output((folder / ("shrunk" + campaigns::suffix_for(small))).string(), campaigns::input_text(small, "shrunk from " + name + ", keeps: " + behaviour));
  }
  write_output((folder / "record.json").string(), record.dump(2) + "\n");
}

}  // namespace

Json run_seed(const Plan& plan, std::uint64_t seed, const std::string& strategy, ConformWorkspace& workspace, const std::string& store, double shrink_time) {
  const Family& family = campaigns::family_for(plan.family, seed);
  const Input input = campaigns::generate(family, seed);
  ConformSettings settings = plan.settings;
  settings.strategy = strategy;
  const ConformRun run = workspace.conform(input, settings);
  const std::string text = workspace.input_text(), suffix = workspace.suffix(), certificate = workspace.certificate();
  Json record{{"seed", seed}, {"family", family.name}, {"strategy", strategy}, {"input", sha256(text)}, {"outcome", name_of(run.outcome)}, {"verdict", run.verdict}};
  if (run.outcome == Outcome::crash) record["exit"] = run.exit_code, record["signal"] = run.signal;
  // Error messages name the file, whose name differs from run to run; how far an interrupted run has come does too.
  if (run.outcome == Outcome::invalid) {
    const std::size_t code = run.verdict.find("error[");
    record["verdict"] = code == std::string::npos ? "" : run.verdict.substr(code, run.verdict.find(']', code) + 1 - code);
  }
  if (run.report.is_object()) copy_numbers(run.report, record);
  if (!certificate.empty()) record["certificate"] = sha256(certificate);
  bool expected = is_expected(run, family, strategy);
  if (plan.metamorphic && expected && run.outcome != Outcome::invalid) {
    std::string fault;
    record["variants"] = compare_variants(input, seed, run, settings, workspace, fault);
    if (!fault.empty()) record["contradiction"] = fault, expected = false;
  }
  if (plan.oracle > 0 && run.outcome == Outcome::verified && run.report.value("vertices", 0L) + run.report.value("steiner_points", 0L) <= plan.oracle) {
    const std::string fault = objection_to(instance_of(parse_certificate("certificate", certificate)));
    if (!fault.empty()) record["contradiction"] = "the oracle finds that " + fault, expected = false;
  }
  record["expected"] = expected;
  if (!expected && !store.empty()) store_failure(store, record, text, suffix, certificate, settings, input, run, record.contains("contradiction") ? 0 : shrink_time, workspace);
  record["seconds"] = run.seconds;
  return record;
}

}  // namespace confidel
