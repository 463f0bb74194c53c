// SPDX-License-Identifier: GPL-3.0-or-later
// What the subcommands share. A subcommand is one file with one function add_...; it declares its options and says, by
// setting Selection::run, what is to be done once the command line has been accepted.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/complex/build.h"
#include "core/complex/input.h"
#include "core/placement/global.h"

namespace confidel {

/// Exit codes of every program of the project: docs/certificate-format.md, section 6.
enum ExitCode : int {
  exit_success = 0,
  exit_refuted = 1,
  exit_bad_input = 2,
  exit_undecided = 3,
  exit_unreadable = 4,
  exit_rejected = 5,
  exit_internal = 70,
  exit_interrupted = 130,
};

struct Selection {
  std::function<int()> run;
  bool json = false;  ///< --json was given: problems are reported as a document, too
};

void add_info(CLI::App& app, Selection& selection);
void add_canonical(CLI::App& app, Selection& selection);
void add_conform(CLI::App& app, Selection& selection);
void add_draw(CLI::App& app, Selection& selection);
void add_lemma(CLI::App& app, Selection& selection);
void add_paper(CLI::App& app, Selection& selection);
void add_generate(CLI::App& app, Selection& selection);
void add_campaign(CLI::App& app, Selection& selection);
void add_shrink(CLI::App& app, Selection& selection);
void add_falsify(CLI::App& app, Selection& selection);

/// The strategies that conform knows.
const std::vector<std::string>& strategy_names();
/// The rule of the global strategies; none for the others. Throws CLI::ParseError where --beta makes no sense.
GlobalRule rule_of(const std::string& strategy, const std::string& beta);
void add_convert(CLI::App& app, Selection& selection);
void add_audit(CLI::App& app, Selection& selection);
void add_explain(CLI::App& app, Selection& selection);
void add_manual(CLI::App& app, Selection& selection);
void add_report(CLI::App& app, Selection& selection);

/// --json: one document on standard output (docs/json.md), the same for every subcommand.
void add_json_option(CLI::App& command, Selection& selection);

/// The options that decide what complex an input is: the same for every subcommand that reads one.
void add_build_options(CLI::App& command, BuildOptions& options);

/// The problems of a bad input on standard error: the first 20, then how many there are of each code. With json also, all of them, as
/// a document on standard output.
void print_problems(const InputError& error, bool json);

/// Writes all bytes, to standard output if path is empty. A file appears complete or not at all, also when the program
/// is interrupted. Throws FileError.
void write_output(const std::string& path, const std::string& bytes);

}  // namespace confidel
