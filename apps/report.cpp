// SPDX-License-Identifier: GPL-3.0-or-later
// confidel report RUNS -o report.html: a campaign's records as one page to read, without scripts and without the network.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/command.h"

namespace confidel {
namespace {

using Json = nlohmann::ordered_json;

struct ReportOptions {
  std::string folder, output;
  bool json = false;
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '&') result += "&amp;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string() + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Campaign {
  Json plan;
  std::vector<Json> records;
  std::vector<std::string> blocks;
};

/// Records are lines with a seed and an outcome; other lines (a block's digest) are not for reading.
Campaign read_campaign(const std::string& folder) {
  const std::filesystem::path root(folder);
  Campaign campaign;
  if (!std::filesystem::is_directory(root)) throw FileError(folder + ": is no folder");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(root))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw FileError(folder + ": holds no records (*.jsonl): is it a campaign's folder?");
  if (std::filesystem::exists(root / "campaign.json")) campaign.plan = Json::parse(contents(root / "campaign.json"), nullptr, false);
  for (const auto& file : files) {
    campaign.blocks.push_back(file.filename().string());
    std::istringstream lines(contents(file));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      const Json record = Json::parse(line, nullptr, false);
      if (!record.is_object()) throw InputError({{"E-SYNTAX", {file.string(), number, 0}, "this line is no JSON object: was the file cut?"}});
      if (record.contains("seed") && record.contains("outcome")) campaign.records.push_back(record);
    }
  }
  return campaign;
}

std::string text_of(const Json& record, const char* key) {
  if (!record.contains(key)) return "";
  return record[key].is_string() ? record[key].get<std::string>() : record[key].dump();
}
double number_of(const Json& record, const char* key) { return record.contains(key) && record[key].is_number() ? record[key].get<double>() : NAN; }
bool is_unexpected(const Json& record) { return record.contains("expected") && record["expected"] != true; }
std::string name_of(const Json& record) { return text_of(record, "family") + " " + text_of(record, "seed"); }

struct Group {
  long runs = 0, unexpected = 0;
  std::map<std::string, long> outcomes;
  std::vector<double> points, seconds;

  void add(const Json& record) {
    ++runs;
    unexpected += is_unexpected(record);
    ++outcomes[text_of(record, "outcome")];
    if (const double value = number_of(record, "steiner_points"); !std::isnan(value)) points.push_back(value);
    if (const double value = number_of(record, "seconds"); !std::isnan(value)) seconds.push_back(value);
  }
};

std::string quantile(std::vector<double> values, double part) {
  if (values.empty()) return "";
  std::sort(values.begin(), values.end());
  return fmt::format("{:.4g}", values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))]);
}

std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<table><thead><tr>";
  for (const std::string& cell : head) text += "<th>" + escaped(cell) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    text += "<tr>";
    for (const std::string& cell : row) text += "<td>" + escaped(cell) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string outcome_table(const std::vector<Json>& records) {
  std::map<std::pair<std::string, std::string>, Group> groups;
  std::map<std::string, long> outcomes;
  for (const Json& record : records) {
    groups[{text_of(record, "family"), text_of(record, "strategy")}].add(record);
    groups[{"all", text_of(record, "strategy")}].add(record);
    ++outcomes[text_of(record, "outcome")];
  }
  std::vector<std::string> head{"family", "strategy", "runs"};
  for (const auto& [outcome, count] : outcomes) head.push_back(outcome);
  for (const char* name : {"unexpected", "points: median", "most", "seconds: median", "longest"}) head.emplace_back(name);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, group] : groups) {
    std::vector<std::string> row{key.first, key.second, std::to_string(group.runs)};
    for (const auto& [outcome, count] : outcomes) row.push_back(group.outcomes.count(outcome) != 0 ? std::to_string(group.outcomes.at(outcome)) : "");
    row.push_back(std::to_string(group.unexpected));
    for (const auto* values : {&group.points, &group.seconds})
      for (const double part : {0.5, 1.0}) row.push_back(quantile(*values, part));
    rows.push_back(std::move(row));
  }
  return table(head, rows);
}

/// Points against the smallest angle, both on logarithmic scales. Shapes tell strategies apart as well as colours do.
std::string scatter(const std::vector<Json>& records) {
  constexpr double width = 760, height = 380, left = 60, bottom = 40;
  constexpr std::size_t most = 4000;
  struct Dot {
    double angle, points;
    std::string strategy, name;
  };
  std::vector<Dot> dots;
  for (const Json& record : records) {
    const double angle = number_of(record, "smallest_angle"), points = number_of(record, "steiner_points");
    if (angle > 0 && points >= 0) dots.push_back({std::log10(angle), std::log10(points + 1), text_of(record, "strategy"), name_of(record)});
  }
  if (dots.size() < 2) return "<p>No run says both its smallest angle and its points.</p>\n";
  const auto by_angle = std::minmax_element(dots.begin(), dots.end(), [](const Dot& a, const Dot& b) { return a.angle < b.angle; });
  const double low = std::floor(by_angle.first->angle), high = std::max(low + 1, std::ceil(by_angle.second->angle));
  double top = 1;
  for (const Dot& dot : dots) top = std::max(top, std::ceil(dot.points));
  const auto x = [&](double angle) { return left + (angle - low) / (high - low) * (width - left - 10); };
  const auto y = [&](double points) { return height - bottom - points / top * (height - bottom - 10); };
  std::string text = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Steiner points against the smallest angle\">\n", width, height);
  for (int power = static_cast<int>(low); power <= static_cast<int>(high); ++power)
    text += fmt::format("<path class=\"grid\" d=\"M{0:.1f} 10V{1}\"/><text x=\"{0:.1f}\" y=\"{2}\" text-anchor=\"middle\">{3:g}</text>\n", x(power), height - bottom, height - bottom + 16, std::pow(10, power));
  for (int power = 0; power <= static_cast<int>(top); ++power)
    text += fmt::format("<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n", left, y(power), width - 10, left - 6, y(power) + 4, std::pow(10, power));
  text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">smallest angle, degrees</text><text x=\"12\" y=\"{}\" transform=\"rotate(-90 12 {})\" text-anchor=\"middle\">Steiner points + 1</text>\n",
                      (left + width) / 2, height - 6, height / 2, height / 2);
  std::map<std::string, int> shapes;
  for (const Dot& dot : dots) shapes.emplace(dot.strategy, 0);
  int next = 0;
  for (auto& [strategy, shape] : shapes) shape = next++ % 4;
  const std::size_t stride = (dots.size() + most - 1) / most;
  constexpr const char* paths[] = {"m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0", "m-3-3h6v6h-6z", "m0-4l4 7h-8z", "m-3-3l6 6m0-6l-6 6"};
  for (std::size_t i = 0; i < dots.size(); i += stride) {
    const int shape = shapes[dots[i].strategy];
    text += fmt::format("<path class=\"s{}\" d=\"M{:.1f} {:.1f}{}\"><title>{}, {}: {:.3g} degrees, {:.0f} points</title></path>\n", shape, x(dots[i].angle), y(dots[i].points), paths[shape],
                        escaped(dots[i].name), escaped(dots[i].strategy), std::pow(10, dots[i].angle), std::pow(10, dots[i].points) - 1);
  }
  text += "</svg>\n<p class=\"key\">";
  for (const auto& [strategy, shape] : shapes) text += fmt::format("<svg viewBox=\"-6 -6 12 12\" width=\"12\"><path class=\"s{}\" d=\"M0 0{}\"/></svg> {} &nbsp; ", shape, paths[shape], escaped(strategy));
  if (stride > 1) text += fmt::format("every {}th run of {} is drawn", stride, dots.size());
  return text + "</p>\n";
}

std::string slack_table(const std::vector<Json>& records) {
  struct Tightest {
    double slack = INFINITY;
    std::string input, object;
  };
  std::map<std::pair<std::string, std::string>, Tightest> tightest;
  for (const Json& record : records) {
    if (!record.contains("slacks")) continue;
    for (const auto& [name, value] : record["slacks"].items()) {
      const double slack = number_of(value, "slack");
      Tightest& entry = tightest[{name, text_of(record, "strategy")}];
      if (slack < entry.slack) entry = {slack, name_of(record), text_of(value, "object")};
    }
  }
  if (tightest.empty()) return "<p>No record has slacks.</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, entry] : tightest) rows.push_back({key.first, key.second, fmt::format("{:.4g}", entry.slack), entry.input, entry.object});
  return table({"lemma", "strategy", "smallest slack", "input", "object"}, rows);
}

std::string unexpected_table(const std::vector<Json>& records) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& record : records)
    if (is_unexpected(record)) rows.push_back({name_of(record), text_of(record, "strategy"), text_of(record, "outcome"), text_of(record, "verdict"), text_of(record, "contradiction")});
  if (rows.empty()) return "<p>None.</p>\n";
  return table({"input", "strategy", "outcome", "what it said", "contradiction"}, rows);
}

constexpr const char* style = R"(
:root { --paper: #fff; --ink: #1b1b1b; --soft: #667; --line: #d5d8de; --s0: #0072b2; --s1: #d55e00; --s2: #009e73; --s3: #cc79a7; }
@media (prefers-color-scheme: dark) { :root { --paper: #16181c; --ink: #e6e6e6; --soft: #9aa; --line: #3a3f47; --s0: #56b4e9; --s1: #e69f00; --s2: #2fd0a5; --s3: #e8a8cc; } }
body { font: 15px/1.5 system-ui, sans-serif; background: var(--paper); color: var(--ink); max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; } code { font-size: .9em; overflow-wrap: anywhere; }
table { border-collapse: collapse; display: block; overflow-x: auto; } th, td { border-bottom: 1px solid var(--line); padding: .2rem .6rem; text-align: left; font-variant-numeric: tabular-nums; }
svg text { font-size: 12px; fill: var(--soft); } .grid { stroke: var(--line); fill: none; } .key { color: var(--soft); }
.s0 { fill: var(--s0); } .s1 { fill: var(--s1); } .s2 { fill: var(--s2); } .s3 { stroke: var(--s3); fill: none; stroke-width: 1.6; }
)";

std::string page(const std::string& folder, const Campaign& campaign) {
  const auto& records = campaign.records;
  const long unexpected = std::count_if(records.begin(), records.end(), is_unexpected);
  std::string plan;
  if (campaign.plan.is_object()) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : campaign.plan.items()) rows.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
    plan = "<h2>Plan</h2>\n" + table({"", ""}, rows);
  }
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>Confidel campaign {0}</title><style>{1}</style></head><body>\n"
      "<h1>Campaign {0}</h1>\n<p>{2} runs in {3} blocks, <strong>{4} unexpected</strong>. This page shows the records as they are; <code>confidel campaign cover</code> says whether they are complete and unchanged.</p>\n"
      "<h2>Unexpected</h2>\n{5}<h2>Outcomes</h2>\n{6}<h2>Points and angles</h2>\n{7}<h2>Tightest slacks</h2>\n{8}{9}</body></html>\n",
      escaped(folder), style, records.size(), campaign.blocks.size(), unexpected, unexpected_table(records), outcome_table(records), scatter(records), slack_table(records), plan);
}

int run_report(const ReportOptions& options) {
  const Campaign campaign = read_campaign(options.folder);
  const std::string text = page(options.folder, campaign);
  write_output(options.output, text);
  const long unexpected = std::count_if(campaign.records.begin(), campaign.records.end(), is_unexpected);
  if (options.json) fmt::print("{}\n", Json{{"folder", options.folder}, {"output", options.output}, {"runs", campaign.records.size()}, {"blocks", campaign.blocks.size()}, {"unexpected", unexpected}}.dump(2));
  else fmt::print("{}: {} runs in {} blocks, {} unexpected\n", options.output, campaign.records.size(), campaign.blocks.size(), unexpected);
  return exit_success;
}

}  // namespace

void add_report(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Make one HTML page of a campaign's records");
  command->add_option("RUNS", options->folder, "The campaign's folder: block-*.jsonl, campaign.json")->required();
  command->add_option("-o,--output", options->output, "The page: .html")->required();
  add_json_option(*command, selection);
  command->footer("Examples:\n  confidel report examples/campaign -o report.html");
  command->callback([options, &selection] {
    options->json = selection.json;
    selection.run = [options] { return run_report(*options); };
  });
}

}  // namespace confidel
