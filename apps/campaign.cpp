// SPDX-License-Identifier: GPL-3.0-or-later
// confidel campaign run|cover: many random inputs, each certificate checked by the checker program.
#include "apps/campaign.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "apps/command.h"
#include "apps/meter.h"
#include "campaigns/families.h"
#include "campaigns/instance.h"

namespace confidel {

namespace {

struct CampaignOptions {
  Plan plan;
  std::string folder, seeds, shard = "0/1", strategies = "lean";
  int processes = 2;
  double shrink_time = 60;
  int replay = 0;
  bool quiet = false, json = false;
};

int usage(const std::string& message) {
  fmt::print(stderr, "confidel: error[E-USAGE]: {}\nRun `confidel campaign --help`.\n", message);
  return exit_bad_input;
}

/// Decimal digits only, below 2^64.
bool parse_number(const std::string& text, std::uint64_t& value) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) return false;
  errno = 0;
  value = std::strtoull(text.c_str(), nullptr, 10);
  return errno == 0;
}

bool parse_seeds(const std::string& text, Seeds& seeds) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return parse_number(text, seeds.first) && parse_number(text, seeds.last);
  return parse_number(text.substr(0, dots), seeds.first) && parse_number(text.substr(dots + 2), seeds.last) && seeds.first <= seeds.last;
}

bool parse_shard(const std::string& text, std::uint64_t& shard, std::uint64_t& count) {
  const std::size_t slash = text.find('/');
  return slash != std::string::npos && parse_number(text.substr(0, slash), shard) && parse_number(text.substr(slash + 1), count) && shard < count;
}

/// The folder has this plan afterwards; false if it has another one.
bool settle_plan(const Plan& plan, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder + ": cannot be made: " + error.message());
  const std::string path = folder + "/campaign.json";
  if (!std::filesystem::exists(path)) {
    // Of several shards that begin at the same time one makes it; link does not replace what is there.
    const PartialFile partial(path);
    std::ofstream(partial.name()) << plan.json().dump(2) << "\n";
    if (::link(partial.name().c_str(), path.c_str()) != 0 && errno != EEXIST) throw FileError(path + ": cannot be written: " + std::strerror(errno));
  }
  return read_plan(folder).json() == plan.json();
}

class Runner {
 public:
  Runner(const CampaignOptions& options, std::uint64_t shard, std::uint64_t shards) : options_(options), plan_(options.plan), meter_(0, 0, !options.quiet) {
    for (std::uint64_t number = shard; number < plan_.block_count(); number += shards) waiting_.push_back(number);
  }

  int run() {
    std::vector<std::thread> workers;
    for (int i = 0; i < options_.processes; ++i) workers.emplace_back([this, i] { work(i); });
    for (std::thread& worker : workers) worker.join();
    if (!failure_.empty()) throw FileError(failure_);
    if (options_.json)
      fmt::print("{}\n", Json{{"folder", options_.folder}, {"runs", runs_.load()}, {"there_already", skipped_.load()}, {"unexpected", unexpected_.load()}}.dump(2));
    else
      fmt::print("{} runs, {} in blocks that were there already, {} unexpected\n", runs_.load(), skipped_.load(), unexpected_.load());
    return unexpected_ == 0 ? exit_success : exit_refuted;
  }

 private:
  void work(int worker) {
    try {
      ConformWorkspace workspace(fmt::format("{}/work-{}-{}", options_.folder, ::getpid(), worker));
      while (failure_empty()) {
        const std::size_t next = next_++;
        if (next >= waiting_.size()) return;
        run_block(waiting_[next], workspace);
      }
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex_);
      failure_ = error.what();
    }
  }

  void run_block(std::uint64_t number, ConformWorkspace& workspace) {
    const std::string path = options_.folder + "/" + plan_.block_name(number);
    const Block there = read_block(plan_, number, path);
    if (there.fault.empty()) {
      skipped_ += static_cast<long>(there.records.size());
      for (const Json& record : there.records)
        if (record["expected"] != true) ++unexpected_;
      return;
    }
    std::vector<Json> records;
    const Seeds range = plan_.block_seeds(number);
    for (std::uint64_t seed = range.first;; ++seed) {
      for (const std::string& strategy : plan_.strategies) {
        records.push_back(run_seed(plan_, seed, strategy, workspace, options_.folder + "/failures", options_.shrink_time));
        ++runs_;
        if (records.back()["expected"] != true) report(records.back());
        show_progress();
      }
      if (seed == range.last) break;
    }
    write_output(path, block_text(plan_, number, records));
  }

  void report(const Json& record) {
    ++unexpected_;
    const std::lock_guard lock(mutex_);
    std::FILE* const out = options_.json ? stderr : stdout;
    fmt::print(out, "UNEXPECTED {} seed {} {}: {}{}\n", record["family"].get<std::string>(), record["seed"].dump(), record["strategy"].get<std::string>(),
               record["verdict"].get<std::string>(), record.contains("contradiction") ? "; " + record["contradiction"].get<std::string>() : "");
    std::fflush(out);
  }

  void show_progress() {
    const std::lock_guard lock(mutex_);
    const double total = static_cast<double>(waiting_.size() * plan_.block * plan_.strategies.size());
    meter_.at(fmt::format("{} runs of about {:.0f}, {} unexpected", runs_.load() + skipped_.load(), total, unexpected_.load()).c_str(), 0);
  }

  bool failure_empty() {
    const std::lock_guard lock(mutex_);
    return failure_.empty();
  }

  const CampaignOptions& options_;
  const Plan& plan_;
  Meter meter_;
  std::vector<std::uint64_t> waiting_;
  std::atomic<std::size_t> next_{0};
  std::atomic<long> runs_{0}, skipped_{0}, unexpected_{0};
  std::mutex mutex_;
  std::string failure_;
};

int run_campaign(CampaignOptions& options) {
  if (options.plan.family != "all" && campaigns::find_family(options.plan.family) == nullptr)
    return usage("no family is called `" + options.plan.family + "`; `confidel generate --list` names them");
  if (!parse_seeds(options.seeds, options.plan.seeds)) return usage("--seeds " + options.seeds + ": FIRST..LAST is needed, such as 0..999");
  std::uint64_t shard = 0, shards = 1;
  if (!parse_shard(options.shard, shard, shards)) return usage("--shard " + options.shard + ": I/N is needed, from 0/N to N-1/N");
  options.plan.strategies = CLI::detail::split(options.strategies, ',');
  for (const std::string& strategy : options.plan.strategies)
    if (std::find(strategy_names().begin(), strategy_names().end(), strategy) == strategy_names().end()) return usage("no strategy is called `" + strategy + "`");
  set_programs(options.plan);
  if (!settle_plan(options.plan, options.folder))
    return usage(options.folder + " holds a campaign of other seeds, options or programs: see its campaign.json; use another folder");
  return Runner(options, shard, shards).run();
}

/// Runs some seeds again: whoever wrote the records must have run them.
std::string replay(const Plan& plan, const std::vector<Json>& records, int count) {
  Plan programs = plan;
  set_programs(programs);
  if (programs.producer != plan.producer || programs.checker != plan.checker) return "the programs here are not those of the campaign: they cannot replay it";
  ConformWorkspace workspace((std::filesystem::temp_directory_path() / fmt::format("confidel-cover-{}", ::getpid())).string());
  for (int i = 0; i < count; ++i) {
    // Evenly, so that no stretch of seeds is left out.
    const Json& record = records[static_cast<std::size_t>(i) * records.size() / static_cast<std::size_t>(count)];
    const Json again = run_seed(plan, record["seed"], record["strategy"], workspace, "", 0);
    if (lasting(again) != lasting(record)) return fmt::format("seed {}, strategy {} gives another result when it is run again: {} instead of {}", record["seed"].dump(), record["strategy"].dump(), lasting(again).dump(), lasting(record).dump());
  }
  return "";
}

int refuse(const std::string& message) {
  fmt::print(stderr, "confidel: error[E-COVER]: {}\n", message);
  return exit_rejected;
}

int run_cover(const CampaignOptions& options) {
  const Plan plan = read_plan(options.folder);
  if (plan.family != "all" && campaigns::find_family(plan.family) == nullptr) return refuse("campaign.json names a family that does not exist");
  std::vector<Json> records;
  std::set<std::string> names;
  std::vector<std::string> missing;
  for (std::uint64_t number = 0; number < plan.block_count(); ++number) {
    const std::string name = plan.block_name(number);
    names.insert(name);
    Block block = read_block(plan, number, options.folder + "/" + name);
    if (block.fault == "missing") missing.push_back(name);
    else if (!block.fault.empty()) return refuse(options.folder + "/" + name + ": " + block.fault);
    records.insert(records.end(), block.records.begin(), block.records.end());
  }
  for (const auto& entry : std::filesystem::directory_iterator(options.folder)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("block-", 0) == 0 && name.find(".partial-") == std::string::npos && names.count(name) == 0)
      return refuse(options.folder + "/" + name + ": overlaps others: it is none of the plan's blocks");
  }
  if (!missing.empty()) return refuse(fmt::format("{} of {} blocks are missing, the first is {}", missing.size(), plan.block_count(), missing.front()));
  for (const Json& record : records) {
    const campaigns::Family& family = campaigns::family_for(plan.family, record["seed"]);
    if (record["family"] != family.name || record["input"] != sha256(campaigns::input_text(campaigns::generate(family, record["seed"]))))
      return refuse(fmt::format("seed {}: the record is about another input than this program generates", record["seed"].dump()));
  }
  if (options.replay > 0)
    if (const std::string fault = replay(plan, records, options.replay); !fault.empty()) return refuse(fault);
  return print_summary(plan, records, options.json);
}

}  // namespace

void add_campaign(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<CampaignOptions>();
  CLI::App* campaign = app.add_subcommand("campaign", "Many random inputs, each certificate checked by the checker program");
  campaign->require_subcommand(1);
  campaign->footer("Examples:\n  confidel campaign run --seeds 0..3 --out runs\n  confidel campaign run --seeds 0..3 --out runs && confidel campaign cover runs");
  CLI::App* run = campaign->add_subcommand("run", "Generate, conform, check, record; what is there already is not run again");
  run->add_option("--family", options->plan.family, "A family's name, or all: the seed chooses")->capture_default_str();
  run->add_option("--seeds", options->seeds, "FIRST..LAST, both included")->required();
  run->add_option("--out", options->folder, "The campaign's folder")->required();
  run->add_option("--strategy", options->strategies, "One or several, separated by commas: " + fmt::format("{}", fmt::join(strategy_names(), ", ")))->capture_default_str();
  run->add_option("--shard", options->shard, "I/N, from 0/N to N-1/N: every N-th block only")->capture_default_str();
  run->add_option("-j,--processes", options->processes, "How many runs at a time")->check(CLI::Range(1, 64))->capture_default_str();
  run->add_option("--block", options->plan.block, "Seeds per file of results: what an interruption loses")->check(CLI::Range(1, 100000))->capture_default_str();
  run->add_flag("--metamorphic", options->plan.metamorphic, "Each input also permuted, with other axes, rotated, scaled and twice: the verdict must stay");
  run->add_option("--oracle", options->plan.oracle, "Certificates with up to so many points are also judged by the producer's own exact evaluation of their claims, L18, L18b, L19 and L22, which shares nothing with the checker; 0: none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  run->add_option("--shrink-time", options->shrink_time, "For shrinking an unexpected outcome's input, such as 60s; 0: none")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE))
      ->capture_default_str();
  add_conform_limits(*run, options->plan.settings);
  run->add_flag("-q,--quiet", options->quiet, "No progress");
  run->footer("Example: confidel campaign run --seeds 0..999 --strategy lean,graded --out runs\nExit codes: 0 as expected, 1 unexpected outcomes (in OUT/failures), 2 bad usage, 4 a file cannot be read or written, 130 interrupted.");
  add_json_option(*run, selection);
  run->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_campaign(*options); };
  });
  CLI::App* cover = campaign->add_subcommand("cover", "Is every seed there exactly once, unchanged, from one program? Then the summary");
  cover->add_option("FOLDER", options->folder, "The campaign's folder")->required();
  cover->add_option("--replay", options->replay, "Run so many of the records again and compare")->check(CLI::NonNegativeNumber)->capture_default_str();
  cover->footer("Exit codes: 0 complete and as expected, 1 unexpected outcomes, 4 no campaign, 5 refused: missing, changed or overlapping blocks.");
  add_json_option(*cover, selection);
  cover->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_cover(*options); };
  });
  add_cover_cells(*campaign, selection);
}

}  // namespace confidel
