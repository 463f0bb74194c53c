// SPDX-License-Identifier: GPL-3.0-or-later
// confidel campaign cover-cells: do reports of `confidel-check --cells` together check a whole certificate?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <memory>
#include <set>

#include "apps/campaign.h"
#include "apps/command.h"
#include "apps/process.h"

namespace confidel {

namespace {

struct CoverOptions {
  std::string certificate;
  std::vector<std::string> reports;
  int replay = 0;
};

struct Refused {
  std::string message;
};

struct Part {
  std::string path;
  Json report;
  std::uint64_t first = 0, last = 0;
};

/// The checker's report on some cells, from the checker itself.
Json checked_here(const std::string& certificate, std::uint64_t first, std::uint64_t last) {
  const ProcessResult result = run_process({sibling_program("confidel-check"), certificate, "--json", "--cells", fmt::format("{}-{}", first, last)});
  settle_interruption(result.exit_code);
  if (result.exit_code == exit_unreadable) throw FileError(certificate + ": cannot be read");
  try {
    return Json::parse(result.output);
  } catch (const Json::exception&) {
    throw Refused{fmt::format("{}: the checker ends with {} and no report", certificate, result.exit_code)};
  }
}

Part read_part(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path + ": cannot be read");
  try {
    Part part{path, Json::parse(file)};
    if (part.report.contains("cells-checked")) {
      part.first = part.report["cells-checked"].at(0);
      part.last = part.report["cells-checked"].at(1);
    }
    return part;
  } catch (const Json::exception&) {
    throw Refused{path + ": is no report of confidel-check --json"};
  }
}

/// What has to be the same in all reports, whatever cells they are about.
Json common(const Json& report) {
  Json result;
  for (const char* key : {"digest", "complex", "dimension", "records", "coplanar"})
    if (report.contains(key)) result[key] = report[key];
  result["complex"].erase("compared");
  for (const auto& [rule, count] : report.at("rules").items())
    if (rule != "emptiness" && rule != "tie") result["rules"][rule] = count;
  return result;
}

/// Without what differs from run to run.
Json settled(Json report) {
  for (const char* key : {"certificate", "seconds", "threads"}) report.erase(key);
  if (report.contains("complex")) report["complex"].erase("compared");
  return report;
}

void expect_accepted(const Part& part, const Json& own) {
  const Json& report = part.report;
  const auto refuse = [&](const std::string& why) { throw Refused{part.path + ": " + why}; };
  if (!report.contains("verdict") || !report.contains("exit") || !report.contains("rules") || !report.contains("records")) refuse("is no complete report: " + report.value("why", "the checker did not come to an end"));
  if (report["verdict"] != "UNDECIDED" && report["verdict"] != "VERIFIED") refuse("not accepted: " + report["verdict"].dump());
  if (report.value("digest", "") != own["digest"]) refuse("is about another certificate: the digests differ");
  if (!report.contains("cells-checked")) refuse("checks no cell");
  const std::uint64_t points = own["records"]["vertices"].get<std::uint64_t>() + own["records"]["points"].get<std::uint64_t>();
  const std::uint64_t cells = own["records"]["cells"];
  if (part.first > part.last || part.last >= cells) refuse("the certificate has no such cells");
  if (report["verdict"] == "VERIFIED" ? report["exit"] != exit_success || part.first != 0 || part.last + 1 != cells : report["exit"] != exit_undecided) refuse("contradicts itself");
  if (report["verdict"] == "UNDECIDED") {
    const std::string why = report.value("why", "");
    // What was asked for may go beyond the last cell.
    const std::string begin = fmt::format("cells-{}-", part.first);
    if (why.rfind("cells-", 0) != 0) refuse("not accepted: UNDECIDED " + why);
    if (part.last + 1 == cells ? why.rfind(begin, 0) != 0 : why != begin + std::to_string(part.last)) refuse("contradicts itself: " + why);
  }
  if (report["rules"].value("emptiness", std::uint64_t{0}) != (part.last - part.first + 1) * points) refuse("was changed: so many cells have another number of pairs with points");
  if (common(report) != common(own)) refuse("was changed: what is the same for all cells is not as the checker here finds it");
}

int cover(const CoverOptions& options) {
  // Everything that does not range over cells is checked here again; it also says what certificate this is.
  const Json own = checked_here(options.certificate, 0, 0);
  if (own.value("exit", -1) != exit_undecided || own.value("why", "") != "cells-0-0" || !own.contains("digest")) throw Refused{fmt::format("{}: the checker does not accept it: {}", options.certificate, own.value("verdict", ""))};
  std::vector<Part> parts;
  for (const std::string& path : options.reports) parts.push_back(read_part(path));
  for (const Part& part : parts) expect_accepted(part, own);
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return std::pair(a.first, a.path) < std::pair(b.first, b.path); });
  std::uint64_t next = 0;
  for (const Part& part : parts) {
    if (part.first > next) throw Refused{fmt::format("cells {} to {} are in no report", next, part.first - 1)};
    if (part.first < next) throw Refused{fmt::format("{}: overlaps: cell {} is in another report too", part.path, part.first)};
    next = part.last + 1;
  }
  const std::uint64_t cells = own["records"]["cells"];
  if (next != cells) throw Refused{fmt::format("cells {} to {} are in no report", next, cells - 1)};
  const int again = std::min(options.replay, static_cast<int>(parts.size()));
  for (int i = 0; i < again; ++i) {
    const Part& part = parts[static_cast<std::size_t>(i) * parts.size() / static_cast<std::size_t>(again)];
    Json here = settled(checked_here(options.certificate, part.first, part.last)), there = settled(part.report);
    for (const char* key : {"why", "exit", "verdict"}) {  // how many cells were asked for, when there are no more
      here.erase(key);
      there.erase(key);
    }
    if (here != there) throw Refused{part.path + ": the checker here finds something else"};
  }
  fmt::print("{}: {} cells in {} reports, each exactly once; {} checked again\ncertificate {}\ncomplex {}\ns VERIFIED\n", options.certificate, cells, parts.size(), again,
             own["digest"].get<std::string>(), own["complex"]["sha256"].get<std::string>());
  return exit_success;
}

int run_cover_cells(const CoverOptions& options) {
  try {
    return cover(options);
  } catch (const Refused& refused) {
    fmt::print(stderr, "confidel: error[E-COVER]: {}\n", refused.message);
  } catch (const Json::exception&) {
    fmt::print(stderr, "confidel: error[E-COVER]: a report has another form than confidel-check writes\n");
  }
  return exit_rejected;
}

}  // namespace

void add_cover_cells(CLI::App& campaign, Selection& selection) {
  auto options = std::make_shared<CoverOptions>();
  CLI::App* command = campaign.add_subcommand("cover-cells", "Do reports of `confidel-check --json --cells I-J` together check all cells of one certificate?");
  command->add_option("CERT", options->certificate, "The certificate")->required();
  command->add_option("REPORT", options->reports, "What confidel-check --json wrote to standard output, one file for each interval")->required();
  command->add_option("--replay", options->replay, "Check so many of the intervals again and compare")->check(CLI::NonNegativeNumber)->capture_default_str();
  command->footer("Example: confidel-check big.cert --json --cells 0-4999 > part-0.json; confidel campaign cover-cells big.cert part-*.json\n"
                  "Exit codes: 0 all cells exactly once, all accepted, of this certificate; 4 a file cannot be read; 5 refused: gaps, overlaps, another certificate, changed or failed reports.");
  command->callback([options, &selection] { selection.run = [options] { return run_cover_cells(*options); }; });
}

}  // namespace confidel
