// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/conform_process.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>

#include "apps/command.h"
#include "apps/process.h"
#include "campaigns/instance.h"

namespace confidel {

namespace {

Outcome outcome_of(const ProcessResult& process, const std::string& verdict) {
  if (process.signal != 0) return Outcome::crash;
  if (process.exit_code == exit_success && verdict == "s VERIFIED") return Outcome::verified;
  if (process.exit_code == exit_refuted && verdict.rfind("s REFUTED", 0) == 0) return Outcome::refuted;
  if (process.exit_code == exit_undecided && verdict.rfind("s UNDECIDED", 0) == 0) return Outcome::undecided;
  // conform ends with 70 when its own certificate is rejected.
  if (verdict.rfind("s REJECTED", 0) == 0) return Outcome::rejected;
  if (process.exit_code == exit_bad_input && verdict.empty()) return Outcome::invalid;
  return Outcome::crash;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

const std::vector<std::string>& behaviours() {
  static const std::vector<std::string> all{"verified", "refuted", "undecided", "rejected", "crash"};
  return all;
}

}  // namespace

std::vector<std::string> ConformSettings::options() const {
  std::vector<std::string> result{"--strategy", strategy, "--threads", "1", "--max-points", std::to_string(max_points)};
  if (time_limit > 0) result.insert(result.end(), {"--time-limit", fmt::format("{}", time_limit)});
  if (memory_limit > 0) result.insert(result.end(), {"--memory-limit", std::to_string(memory_limit)});
  return result;
}

void add_conform_limits(CLI::App& command, ConformSettings& settings) {
  command.add_option("--max-points", settings.max_points, "conform's: the announced size of a run; needing more is no failure")->check(CLI::PositiveNumber)->capture_default_str();
  command.add_option("--time-limit", settings.time_limit, "conform's, such as 60s; running out of it is a failure")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE))
      ->capture_default_str();
  command.add_option("--memory-limit", settings.memory_limit, "conform's, such as 2G")->transform(CLI::AsSizeValue(false))->capture_default_str();
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::verified: return "verified";
    case Outcome::refuted: return "refuted";
    case Outcome::undecided: return "undecided";
    case Outcome::rejected: return "rejected";
    case Outcome::invalid: return "invalid";
    case Outcome::crash: break;
  }
  return "crash";
}

ConformRun conform_file(const std::string& file, const std::string& certificate, const ConformSettings& settings) {
  std::vector<std::string> command{own_program(), "conform", file, "-o", certificate, "--json"};
  const auto options = settings.options();
  command.insert(command.end(), options.begin(), options.end());
  // conform keeps its limit itself, the checker's included; this is for when it does not.
  const double patience = settings.time_limit > 0 ? 3 * settings.time_limit + 30 : 0;
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult process = run_process(command, patience);
  ConformRun run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.verdict = verdict_line(process.error);
  run.outcome = outcome_of(process, run.verdict);
  if (run.verdict.empty()) run.verdict = first_line(process.error);
  run.exit_code = process.exit_code;
  run.signal = process.signal;
  run.report = nlohmann::ordered_json::parse(process.output, nullptr, false);
  if (run.report.is_discarded()) run.report = nullptr;
  return run;
}

ConformWorkspace::ConformWorkspace(const std::string& prefix)
    : smesh_(prefix + ".smesh"), poly_(prefix + ".poly"), obj_(prefix + ".obj"), certificate_(prefix + ".cert") {}

ConformRun ConformWorkspace::conform(const Input& input, const ConformSettings& settings) {
  text_ = campaigns::input_text(input);
  suffix_ = campaigns::suffix_for(input);
  const TemporaryFile& file = suffix_ == ".smesh" ? smesh_ : suffix_ == ".poly" ? poly_ : obj_;
  write_output(file.name(), text_);
  ::unlink(certificate_.name().c_str());
  return conform_file(file.name(), certificate_.name(), settings);
}

std::string ConformWorkspace::certificate() const {
  std::ifstream file(certificate_.name(), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_behaviour(const std::string& behaviour) {
  const auto& all = behaviours();
  return behaviour.rfind("s ", 0) == 0 || std::find(all.begin(), all.end(), behaviour.substr(0, behaviour.find(':'))) != all.end();
}

bool shows(const ConformRun& run, const std::string& behaviour) {
  if (behaviour.rfind("s ", 0) == 0) return run.verdict.rfind(behaviour, 0) == 0;
  const std::size_t colon = behaviour.find(':');
  const std::string kind = behaviour.substr(0, colon);
  if (kind != name_of(run.outcome)) return false;
  if (colon == std::string::npos) return true;
  return (run.verdict + " ").rfind("s " + upper(kind) + " " + behaviour.substr(colon + 1) + " ", 0) == 0;
}

}  // namespace confidel
