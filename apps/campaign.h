// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign is a folder:
//   campaign.json                        what is run, by which programs: the plan
//   block-FIRST-LAST.jsonl               the records of some seeds, one line for each seed and strategy, and a line with their digest
//   failures/FAMILY-SEED-STRATEGY/       input, certificate, command, record, shrunk input of every unexpected outcome
// Blocks tile the seeds. Each is written under a temporary name and renamed, so a block is complete or it is not there; whatever runs again
// skips those that are there. A shard runs every n-th block.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/command.h"
#include "apps/conform_process.h"

namespace confidel {

using Json = nlohmann::ordered_json;

struct Seeds {
  std::uint64_t first = 0, last = 0;  ///< both included
};

struct Plan {
  std::string family = "all";
  Seeds seeds;
  std::uint64_t block = 20;  ///< seeds per block
  std::vector<std::string> strategies{"lean"};
  bool metamorphic = false;
  long oracle = 0;  ///< certificates with up to so many points are also judged by the producer's own evaluation of the statements
  ConformSettings settings;
  /// SHA-256 of the programs confidel and confidel-check.
  std::string producer, checker;

  Json json() const;
  static Plan from_json(const Json& document);

  std::uint64_t block_count() const { return (seeds.last - seeds.first) / block + 1; }
  Seeds block_seeds(std::uint64_t number) const;
  std::string block_name(std::uint64_t number) const;
};

/// Digests of the programs that would run now.
void set_programs(Plan& plan);

/// Throws FileError if the folder has no plan, or none that can be read.
Plan read_plan(const std::string& folder);

struct Block {
  std::vector<Json> records;
  std::string fault;  ///< empty: all records there, of the plan's seeds and strategies in order, digest right, programs the plan's
};

/// A record without what differs from run to run (the time).
Json lasting(Json record);
std::string block_text(const Plan& plan, std::uint64_t number, const std::vector<Json>& records);
Block read_block(const Plan& plan, std::uint64_t number, const std::string& path);

/// Runs one seed with one strategy. `store` is where an unexpected outcome's files go, empty: nowhere.
Json run_seed(const Plan& plan, std::uint64_t seed, const std::string& strategy, ConformWorkspace& workspace, const std::string& store, double shrink_time);

/// The last line of a summary, and exit_success or exit_refuted (unexpected outcomes).
int print_summary(const Plan& plan, const std::vector<Json>& records, bool json);

/// `campaign cover-cells`.
void add_cover_cells(CLI::App& campaign, Selection& selection);

/// The smallest slack of each lemma in a conform report, with the object: {"power": {"slack": .., "object": ..}, ...}. "power" is the smallest
/// relative power off-plane, the slack of emptiness; a checker that tests lemmas adds theirs.
Json slacks(const Json& report);

}  // namespace confidel
