// SPDX-License-Identifier: GPL-3.0-or-later
// What a campaign's records say, as Markdown tables.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "apps/campaign.h"
#include "apps/command.h"

namespace confidel {

namespace {

std::string seed_of(const Json& record) { return fmt::format("{} {}", record["family"].get<std::string>(), record["seed"].dump()); }

struct Group {
  long runs = 0, verified = 0, refuted = 0, undecided = 0, invalid = 0, unexpected = 0, fell_back = 0;
  std::vector<long> points;
  double smallest_angle = std::numeric_limits<double>::infinity();
  double smallest_power = std::numeric_limits<double>::infinity();

  void add(const Json& record) {
    ++runs;
    const std::string outcome = record["outcome"];
    if (outcome == "verified") ++verified;
    else if (outcome == "undecided") ++undecided;
    else if (outcome == "refuted") ++refuted;
    else if (outcome == "invalid") ++invalid;
    if (record["expected"] != true) ++unexpected;
    if (record.contains("protected_by_graded")) ++fell_back;
    if (outcome == "verified") points.push_back(record.value("steiner_points", 0L));
    if (record.contains("smallest_angle") && record["smallest_angle"].is_number()) smallest_angle = std::min(smallest_angle, record["smallest_angle"].get<double>());
    if (record.contains("slacks") && record["slacks"].contains("power")) smallest_power = std::min(smallest_power, record["slacks"]["power"]["slack"].get<double>());
  }

  Json json() {
    std::sort(points.begin(), points.end());
    const auto quantile = [&](double q) { return points.empty() ? Json() : Json(points[static_cast<std::size_t>(q * static_cast<double>(points.size() - 1))]); };
    const auto number = [](double value) { return value == std::numeric_limits<double>::infinity() ? Json() : Json(value); };
    return {{"runs", runs}, {"verified", verified}, {"refuted", refuted}, {"undecided", undecided}, {"refused", invalid}, {"unexpected", unexpected}, {"as_graded", fell_back},
            {"points_median", quantile(0.5)}, {"points_90_percent", quantile(0.9)}, {"points_most", quantile(1)}, {"smallest_angle", number(smallest_angle)}, {"smallest_power", number(smallest_power)}};
  }

  /// The same numbers in the same order, as the cells of a row.
  std::string cells() {
    const Json numbers = json();
    std::string row;
    for (const Json& value : numbers)
      row += value.is_null() ? "- | " : value.is_number_float() ? fmt::format("{:.3g} | ", value.get<double>()) : value.dump() + " | ";
    row.pop_back();
    return row;
  }
};

const char* const columns = "runs | verified | refuted | undecided | refused | unexpected | as graded | points: median | 90 % | most | smallest angle | smallest power |";
const char* const rule = "---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|";

void print_groups(const std::string& title, std::map<std::pair<std::string, std::string>, Group>& groups) {
  fmt::print("\n| {} | strategy | {}\n|---|---|{}\n", title, columns, rule);
  for (auto& [key, group] : groups) fmt::print("| {} | {} | {}\n", key.first, key.second, group.cells());
}

/// The intervals' names sort in their order.
std::string angle_interval(const Json& record) {
  if (!record.contains("smallest_angle") || !record["smallest_angle"].is_number()) return "no angle";
  const double angle = record["smallest_angle"];
  double low = 0;
  for (const double high : {1., 3., 10., 30., 60., 181.}) {
    if (angle < high) return high > 180 ? fmt::format("{:02.0f} and more", low) : fmt::format("{:02.0f} to {:02.0f}", low, high);
    low = high;
  }
  return "no angle";
}

}  // namespace

int print_summary(const Plan& plan, const std::vector<Json>& records, bool json) {
  using Key = std::pair<std::string, std::string>;
  std::map<Key, Group> by_family, by_angle, all;
  struct Tightest {
    double slack = std::numeric_limits<double>::infinity();
    std::string where, object;
  };
  std::map<Key, Tightest> tightest;
  std::vector<const Json*> unexpected;
  for (const Json& record : records) {
    const std::string strategy = record["strategy"];
    by_family[{record["family"], strategy}].add(record);
    all[{"all", strategy}].add(record);
    if (record["outcome"] != "invalid") by_angle[{angle_interval(record), strategy}].add(record);
    if (record["expected"] != true) unexpected.push_back(&record);
    if (!record.contains("slacks")) continue;
    for (const auto& [lemma, value] : record["slacks"].items()) {
      Tightest& entry = tightest[{lemma, strategy}];
      const double slack = value["slack"];
      if (slack < entry.slack) entry = {slack, seed_of(record), value["object"]};
    }
  }
  if (json) {
    Json document{{"plan", plan.json()}, {"records", records.size()}, {"families", Json::array()}, {"angles", Json::array()}, {"lemmas", Json::array()}, {"unexpected", Json::array()}};
    const auto add = [&](const char* name, const char* key, std::map<Key, Group>& groups) {
      for (auto& [of, group] : groups) {
        Json entry{{key, of.first}, {"strategy", of.second}};
        entry.update(group.json());
        document[name].push_back(entry);
      }
    };
    by_family.merge(all);
    add("families", "family", by_family);
    add("angles", "angle", by_angle);
    for (const auto& [of, entry] : tightest)
      document["lemmas"].push_back({{"lemma", of.first}, {"strategy", of.second}, {"slack", entry.slack}, {"input", entry.where}, {"object", entry.object}});
    for (const Json* record : unexpected) document["unexpected"].push_back(*record);
    fmt::print("{}\n", document.dump(2));
    return unexpected.empty() ? exit_success : exit_refuted;
  }
  fmt::print("Family `{}`, seeds {} to {}, strategies {}; at most {} points. Programs: confidel {:.12}, confidel-check {:.12}.\n", plan.family, plan.seeds.first, plan.seeds.last,
             fmt::join(plan.strategies, ", "), plan.settings.max_points, plan.producer, plan.checker);
  by_family.merge(all);
  print_groups("family", by_family);
  print_groups("smallest angle (degrees)", by_angle);
  fmt::print("\n| lemma | strategy | smallest slack | input | object |\n|---|---|---:|---|---|\n");
  for (const auto& [key, entry] : tightest) fmt::print("| {} | {} | {:.4g} | {} | {} |\n", key.first, key.second, entry.slack, entry.where, entry.object);
  fmt::print("\n");
  for (const Json* record : unexpected)
    fmt::print("UNEXPECTED {} {}: {}{}\n", seed_of(*record), (*record)["strategy"].get<std::string>(), (*record)["verdict"].get<std::string>(),
               record->contains("contradiction") ? "; " + (*record)["contradiction"].get<std::string>() : "");
  fmt::print("{} records of {} seeds, {} unexpected\n", records.size(), plan.seeds.last - plan.seeds.first + 1, unexpected.size());
  return unexpected.empty() ? exit_success : exit_refuted;
}

}  // namespace confidel
