// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "apps/campaign.h"
#include "apps/process.h"
#include "core/complex/complex.h"

namespace confidel {

namespace {

bool read_file(const std::string& path, std::string& text) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  std::ostringstream all;
  all << file.rdbuf();
  text = all.str();
  return !file.bad();
}

std::string digest_of(const std::vector<Json>& records) {
  std::string text;
  for (const Json& record : records) text += lasting(record).dump() + "\n";
  return sha256(text);
}

std::string program_digest(const std::string& path) {
  std::string bytes;
  if (!read_file(path, bytes)) throw FileError(path + ": cannot be read");
  return sha256(bytes);
}

}  // namespace

Json Plan::json() const {
  return {{"campaign", 1}, {"family", family}, {"seeds", {seeds.first, seeds.last}}, {"block", block}, {"strategies", strategies},
          {"metamorphic", metamorphic}, {"oracle", oracle}, {"max_points", settings.max_points}, {"time_limit", settings.time_limit},
          {"memory_limit", settings.memory_limit}, {"confidel", producer}, {"confidel_check", checker}};
}

Plan Plan::from_json(const Json& document) {
  Plan plan;
  plan.family = document.at("family");
  plan.seeds = {document.at("seeds").at(0), document.at("seeds").at(1)};
  plan.block = document.at("block");
  plan.strategies = document.at("strategies").get<std::vector<std::string>>();
  plan.metamorphic = document.at("metamorphic");
  plan.oracle = document.value("oracle", 0L);  // older campaigns had none
  plan.settings.max_points = document.at("max_points");
  plan.settings.time_limit = document.at("time_limit");
  plan.settings.memory_limit = document.at("memory_limit");
  plan.producer = document.at("confidel");
  plan.checker = document.at("confidel_check");
  if (plan.seeds.last < plan.seeds.first || plan.block == 0) throw std::out_of_range("no seeds");
  return plan;
}

Seeds Plan::block_seeds(std::uint64_t number) const {
  const std::uint64_t first = seeds.first + number * block;
  return {first, seeds.last - first < block ? seeds.last : first + block - 1};
}

std::string Plan::block_name(std::uint64_t number) const {
  const Seeds range = block_seeds(number);
  return fmt::format("block-{:08}-{:08}.jsonl", range.first, range.last);
}

void set_programs(Plan& plan) {
  plan.producer = program_digest(own_program());
  plan.checker = program_digest(sibling_program("confidel-check"));
}

Plan read_plan(const std::string& folder) {
  std::string text;
  const std::string path = folder + "/campaign.json";
  if (!read_file(path, text)) throw FileError(path + ": cannot be read: is this a campaign's folder?");
  try {
    return Plan::from_json(Json::parse(text));
  } catch (const std::exception& error) {
    throw FileError(fmt::format("{}: is no plan of a campaign: {}", path, error.what()));
  }
}

Json lasting(Json record) {
  record.erase("seconds");
  return record;
}

std::string block_text(const Plan& plan, std::uint64_t number, const std::vector<Json>& records) {
  std::string text;
  for (const Json& record : records) text += record.dump() + "\n";
  const Seeds range = plan.block_seeds(number);
  const Json last{{"block", {range.first, range.last}}, {"records", records.size()}, {"confidel", plan.producer}, {"confidel_check", plan.checker}, {"sha256", digest_of(records)}};
  return text + last.dump() + "\n";
}

Block read_block(const Plan& plan, std::uint64_t number, const std::string& path) {
  Block block;
  std::string text;
  if (!read_file(path, text)) {
    block.fault = "missing";
    return block;
  }
  std::istringstream lines(text);
  try {
    for (std::string line; std::getline(lines, line);) block.records.push_back(Json::parse(line));
    if (block.records.empty()) throw std::out_of_range("no records");
    const Json last = block.records.back();
    block.records.pop_back();
    const Seeds range = plan.block_seeds(number);
    std::size_t next = 0;
    for (std::uint64_t seed = range.first;; ++seed) {
      for (const std::string& strategy : plan.strategies) {
        if (next == block.records.size()) throw std::out_of_range("records are missing");
        const Json& record = block.records[next++];
        if (record.at("seed") != seed || record.at("strategy") != strategy) throw std::out_of_range(fmt::format("record {} is not of seed {}, strategy {}", next, seed, strategy));
      }
      if (seed == range.last) break;
    }
    if (next != block.records.size() || last.at("records") != next) throw std::out_of_range("there are more records than seeds");
    if (last.at("sha256") != digest_of(block.records)) throw std::out_of_range("the digest is wrong: records were changed");
    if (last.at("confidel") != plan.producer || last.at("confidel_check") != plan.checker) throw std::out_of_range("it is from other programs");
  } catch (const std::exception& error) {
    block.fault = error.what();
  }
  return block;
}

Json slacks(const Json& report) {
  Json result = Json::object();
  if (!report.is_object() || !report.contains("checker") || !report["checker"].is_object()) return result;
  const Json& checker = report["checker"];
  if (checker.contains("smallest-relative-power") && checker["smallest-relative-power"].is_object()) {
    const Json& power = checker["smallest-relative-power"];
    result["power"] = {{"slack", power["value"]}, {"object", fmt::format("cell of line {}, point {}", power["cell-line"].dump(), power["point"].dump())}};
  }
  if (!checker.contains("claims") || !checker["claims"].is_array()) return result;
  for (const Json& claim : checker["claims"])
    if (claim["slack"].is_number()) result[claim["id"].get<std::string>()] = {{"slack", claim["slack"]}, {"object", claim["object"]}};
  return result;
}

}  // namespace confidel
