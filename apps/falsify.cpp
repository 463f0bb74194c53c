// SPDX-License-Identifier: GPL-3.0-or-later
// confidel falsify LEMMA --strategy S: a guided search for an input on which a claim fails. The objective comes from the checker's report on
// conform's certificate; a violation is what the checker says, not what the search believes.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "apps/campaign.h"
#include "apps/command.h"
#include "apps/meter.h"
#include "apps/shrinking.h"
#include "campaigns/instance.h"
#include "campaigns/search.h"

namespace confidel {

namespace {

struct FalsifyOptions {
  std::string lemma, folder = "falsify";
  ConformSettings settings;
  double time_limit = 60;
  std::uint64_t seed = 1;
  int processes = 2;
  bool json = false;
};

struct Violation {
  Input input;
  ConformRun run;
  std::string behaviour;
};

/// What must not happen, whatever is searched for; empty if it did not.
std::string violated(const ConformRun& run) {
  switch (run.outcome) {
    case Outcome::refuted: return "refuted:" + run.verdict.substr(10, run.verdict.find(' ', 10) - 10);
    case Outcome::rejected: return "rejected";
    case Outcome::crash: return "crash";
    case Outcome::undecided: return run.verdict.rfind("s UNDECIDED strategy-failed", 0) == 0 ? "undecided:strategy-failed" : "";
    default: return "";
  }
}

class Falsifier {
 public:
  explicit Falsifier(const FalsifyOptions& options) : options_(options), meter_(options.time_limit, 0, true) {}

  int run() {
    std::error_code error;
    std::filesystem::create_directories(options_.folder, error);
    if (error) throw FileError(options_.folder + ": cannot be made: " + error.message());
    std::vector<std::thread> workers;
    for (int i = 0; i < options_.processes; ++i) workers.emplace_back([this, i] { work(i); });
    for (std::thread& worker : workers) worker.join();
    if (!failure_.empty()) throw FileError(failure_);
    if (found_) return report_violation();
    if (archive_.empty()) {
      fmt::print(stderr, "confidel: error[E-USAGE]: no report on strategy {} had a slack of {}; there are: {}\n", options_.settings.strategy, options_.lemma, seen_.empty() ? "none" : fmt::format("{}", fmt::join(seen_, ", ")));
      return exit_bad_input;
    }
    if (options_.json) {
      Json tightest = Json::array();
      for (const auto& [family, best] : archive_) tightest.push_back({{"family", family}, {"objective", best}});
      print_document({{"tightest", tightest}}, exit_undecided);
      return exit_undecided;
    }
    fmt::print("{} runs of conform; nothing fails. The tightest, by family (inputs are in {}):\n", evaluations_.load(), options_.folder);
    double least = INFINITY;
    for (const auto& [family, best] : archive_) {
      fmt::print("  {:<20} {:.6g}\n", family, best);
      least = std::min(least, best);
    }
    fmt::print("s UNDECIDED time-limit smallest={:.6g}\n", least);
    return exit_undecided;
  }

 private:
  void print_document(const Json& findings, int exit) const {
    Json document{{"lemma", options_.lemma}, {"strategy", options_.settings.strategy}, {"folder", options_.folder}, {"runs", evaluations_.load()}};
    document.update(findings);
    document["exit"] = exit;
    fmt::print("{}\n", document.dump(2));
  }

  void work(int worker) {
    try {
      ConformWorkspace workspace(fmt::format("{}/work-{}-{}", options_.folder, ::getpid(), worker));
      campaigns::Random random(options_.seed + 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(worker + 1));
      campaigns::Search task;
      task.objective = [&](const Input& input) { return evaluate(input, workspace); };
      task.improved = [&](const campaigns::SearchStep& step) { remember(step); };
      task.stop = [&] { return found_ || meter_.stop_requested(0) || given_up(); };
      campaigns::search(random, task);
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      failure_ = error.what();
      found_ = true;
    }
  }

  /// A claim that no report mentions is not going to be mentioned.
  bool given_up() {
    constexpr long tries = 60;
    const std::lock_guard lock(mutex_);
    return archive_.empty() && evaluations_ >= tries;
  }

  std::optional<double> evaluate(const Input& input, ConformWorkspace& workspace) {
    const ConformRun run = workspace.conform(input, options_.settings);
    ++evaluations_;
    const std::lock_guard lock(mutex_);
    meter_.at(fmt::format("{} runs, smallest {:.4g}", evaluations_.load(), least_).c_str(), 0);
    const std::string behaviour = violated(run);
    // Another lemma's refutation is no answer to the question.
    if (!behaviour.empty() && !found_ && (run.outcome != Outcome::refuted || behaviour == "refuted:" + options_.lemma)) {
      violation_ = Violation{input, run, behaviour};
      found_ = true;
    }
    const Json all = slacks(run.report);
    for (const auto& [lemma, slack] : all.items())
      if (std::find(seen_.begin(), seen_.end(), lemma) == seen_.end()) seen_.push_back(lemma);
    if (options_.lemma == "termination") return points_beyond_growth(run);
    if (options_.lemma == "estimate") return misjudgement(run);
    if (!all.contains(options_.lemma)) return std::nullopt;
    return all[options_.lemma]["slack"].get<double>();
  }

  /// Points against the growth with the inverse square of the smallest angle: the more, the smaller.
  static std::optional<double> points_beyond_growth(const ConformRun& run) {
    if (!run.report.is_object() || run.outcome != Outcome::verified || !run.report.contains("steiner_points")) return std::nullopt;
    constexpr double wide = 60;  // degrees
    const double angle = run.report["smallest_angle_degrees"].is_number() ? std::min(wide, run.report["smallest_angle_degrees"].get<double>()) : wide;
    return -std::log10(1 + run.report["steiner_points"].get<double>()) - 2 * std::log10(angle / wide);
  }

  static std::optional<double> misjudgement(const ConformRun& run) {
    if (!run.report.is_object() || run.outcome != Outcome::verified || run.report.value("estimated_points", 0L) <= 0) return std::nullopt;
    return -std::abs(std::log2(run.report["estimated_points"].get<double>() / std::max(1.0, run.report["steiner_points"].get<double>())));
  }

  /// The tightest input of each family stays in the folder.
  void remember(const campaigns::SearchStep& step) {
    const std::lock_guard lock(mutex_);
    least_ = std::min(least_, step.objective);
    const auto [entry, added] = archive_.try_emplace(step.family, step.objective);
    if (!added && entry->second <= step.objective) return;
    entry->second = step.objective;
    const std::string stem = fmt::format("{}/{}-{}-{}", options_.folder, options_.lemma, options_.settings.strategy, step.family);
    for (const char* suffix : {".smesh", ".poly", ".obj"}) ::unlink((stem + suffix).c_str());
    write_output(stem + campaigns::suffix_for(step.input), campaigns::input_text(step.input, fmt::format("{}, strategy {}: {:.17g}", options_.lemma, options_.settings.strategy, step.objective)));
  }

  int report_violation() {
    const ConformRun& run = violation_->run;
    const long evaluations = evaluations_;
    if (!options_.json) fmt::print("after {} runs of conform: {}\n", evaluations, run.verdict);
    const std::string stem = fmt::format("{}/{}-{}-violation", options_.folder, options_.lemma, options_.settings.strategy);
    const std::string suffix = campaigns::suffix_for(violation_->input);
    write_output(stem + suffix, campaigns::input_text(violation_->input, run.verdict));
    ConformWorkspace workspace(fmt::format("{}/work-{}", options_.folder, ::getpid()));
    const Input small = shrink_with_conform(violation_->input, {options_.settings, violation_->behaviour, std::max(60.0, options_.time_limit)}, workspace, run.seconds);
    const std::string path = stem + "-shrunk" + campaigns::suffix_for(small);
    write_output(path, campaigns::input_text(small, "keeps: " + violation_->behaviour));
    const ConformRun again = workspace.conform(small, options_.settings);
    if (options_.json) {
      print_document({{"violation", {{"verdict", run.verdict}, {"file", stem + suffix}, {"shrunk", path}, {"shrunk_verdict", again.verdict}, {"vertices", small.vertices.size()}, {"segments", small.segments.size()}, {"facets", small.facets.size()}}}}, exit_refuted);
      return exit_refuted;
    }
    fmt::print("{}: {} vertices, {} segments in no facet, {} facets\n{}\n", path, small.vertices.size(), small.segments.size(), small.facets.size(), again.verdict);
    return exit_refuted;
  }

  const FalsifyOptions& options_;
  Meter meter_;
  std::mutex mutex_;
  std::atomic<bool> found_{false};
  std::atomic<long> evaluations_{0};
  std::optional<Violation> violation_;
  std::map<std::string, double> archive_;
  std::vector<std::string> seen_;
  std::string failure_;
  double least_ = INFINITY;
};

}  // namespace

void add_falsify(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<FalsifyOptions>();
  CLI::App* command = app.add_subcommand("falsify", "Search for an input on which a claim fails, then shrink it");
  const auto seconds = CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE);
  command->add_option("LEMMA", options->lemma, "A lemma whose slack the checker reports, such as L10; power: the smallest relative power off-plane; termination: points beyond the expected growth; estimate: the estimate of points")->required();
  command->add_option("--strategy", options->settings.strategy, "conform's")->check(CLI::IsMember(strategy_names()))->capture_default_str();
  command->add_option("--time-limit", options->time_limit, "For the search, such as 60s; shrinking may take as long again, at least a minute")->transform(seconds)->capture_default_str();
  command->add_option("--max-points", options->settings.max_points, "conform's")->check(CLI::PositiveNumber)->capture_default_str();
  command->add_option("--run-limit", options->settings.time_limit, "conform's --time-limit")->transform(seconds)->capture_default_str();
  command->add_option("--seed", options->seed, "Where the search begins")->check(CLI::NonNegativeNumber)->capture_default_str();
  command->add_option("--out", options->folder, "Where the tightest input of each family, and a violation, are put")->capture_default_str();
  command->add_option("-j,--processes", options->processes, "How many runs of conform at a time")->check(CLI::Range(1, 64))->capture_default_str();
  add_json_option(*command, selection);
  command->footer("Examples:\n  confidel falsify power --strategy graded --time-limit 60s\n\nExit codes: 1 a violation was found, 2 bad usage, 3 none in the time given.");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return Falsifier(*options).run(); };
  });
}

}  // namespace confidel
