// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/interrupt.h"
#include "apps/style.h"

namespace confidel {

namespace {

constexpr std::size_t shown_problems = 20;

/// A problem of a whole line points at its first column; one of the whole file has no line.
std::string place_text(const Place& place) {
  if (place.line <= 0) return place.file;
  return fmt::format("{}:{}:{}", place.file, place.line, place.column > 0 ? place.column : 1);
}

void write_all(std::FILE* stream, const std::string& name, const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream) != bytes.size() || std::fflush(stream) != 0)
    throw FileError(fmt::format("{}: cannot be written: {}", name, std::strerror(errno)));
}

}  // namespace

const std::vector<std::string>& strategy_names() {
  static const std::vector<std::string> names{"lean", "graded", "repaired", "paper", "saalfeld"};
  return names;
}

void add_build_options(CLI::App& command, BuildOptions& options) {
  using Merging = BuildOptions::Merging;
  command.add_flag("--merge-identical", options.merge_identical_vertices, "Vertices with the same position are one vertex, not an error");
  command
      .add_option("--merge-coplanar", options.merge_coplanar,
                  "Exactly coplanar neighbours (with equal markers) are one facet: on, off, or auto (on for triangle soups: .off, .obj, .stl, .ply, .mesh)")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Merging>{{"auto", Merging::automatic}, {"on", Merging::on}, {"off", Merging::off}}, CLI::ignore_case))
      ->option_text("auto|on|off");
}

void add_json_option(CLI::App& command, Selection& selection) {
  command.add_flag("--json", selection.json, "One JSON document on standard output (docs/json.md); verdicts and messages go to standard error");
}

void print_problems(const InputError& error, bool json) {
  if (json) {
    nlohmann::ordered_json document{{"exit", static_cast<int>(exit_bad_input)}, {"problems", nlohmann::ordered_json::array()}};
    for (const Problem& problem : error.problems)
      document["problems"].push_back({{"code", problem.code},
                                      {"file", problem.place.file},
                                      {"line", problem.place.line},
                                      {"column", problem.place.column},
                                      {"message", problem.message}});
    fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }
  const std::size_t shown = std::min(shown_problems, error.problems.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Problem& problem = error.problems[i];
    fmt::print(stderr, "{}: {}: {}\n", place_text(problem.place), styled(Style::error, fmt::format("error[{}]", problem.code), stderr), problem.message);
  }
  if (error.problems.size() <= shown) return;
  std::map<std::string, std::size_t> counts;
  for (const Problem& problem : error.problems) ++counts[problem.code];
  std::string text;
  for (const auto& [code, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, code);
  fmt::print(stderr, "{}: {} errors in all ({} shown): {}\n", error.problems.front().place.file, error.problems.size(),
             shown, text);
}

void write_output(const std::string& path, const std::string& bytes) {
  if (path.empty()) return write_all(stdout, "standard output", bytes);
  struct Closer {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  const PartialFile partial(path);
  {
    const std::unique_ptr<std::FILE, Closer> stream(std::fopen(partial.name().c_str(), "wb"));
    if (!stream) throw FileError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
    partial.created();
    write_all(stream.get(), path, bytes);
  }
  if (std::rename(partial.name().c_str(), path.c_str()) != 0) {
    wait_if_interrupted();
    throw FileError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  }
}

}  // namespace confidel
