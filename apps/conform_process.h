// SPDX-License-Identifier: GPL-3.0-or-later
// `confidel conform` as another process: what it does to an input, seen from outside. A crash there is an observation here.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/interrupt.h"
#include "core/complex/input.h"

namespace CLI {
class App;
}

namespace confidel {

struct ConformSettings {
  std::string strategy = "lean";
  long max_points = 20'000;
  double time_limit = 60;  ///< seconds; 0: none
  std::size_t memory_limit = std::size_t{2} << 30;

  /// The command without input and output.
  std::vector<std::string> options() const;
};

/// --max-points, --time-limit, --memory-limit.
void add_conform_limits(CLI::App& command, ConformSettings& settings);

enum class Outcome { verified, refuted, undecided, rejected, invalid, crash };
const char* name_of(Outcome outcome);

struct ConformRun {
  Outcome outcome = Outcome::crash;
  std::string verdict;  ///< the last line, or the first line of the error message
  int exit_code = -1;
  int signal = 0;
  double seconds = 0;
  nlohmann::ordered_json report;  ///< null if there is none
};

/// Runs conform on a file. The certificate, if one was written, is in `certificate`.
ConformRun conform_file(const std::string& file, const std::string& certificate, const ConformSettings& settings);

/// Names for an input and its certificate; both are removed on destruction and on interruption.
class ConformWorkspace {
 public:
  /// Files beginning with `prefix`; two workspaces must not share one.
  explicit ConformWorkspace(const std::string& prefix);

  /// Writes the input, in the format that it needs, and runs conform on it.
  ConformRun conform(const Input& input, const ConformSettings& settings);

  /// Of the last run.
  const std::string& input_text() const { return text_; }
  const std::string& suffix() const { return suffix_; }
  /// Its bytes; empty if there is none.
  std::string certificate() const;

 private:
  TemporaryFile smesh_, poly_, obj_, certificate_;
  std::string text_, suffix_;
};

/// What is to be kept while shrinking: verified, undecided, refuted, rejected, crash (each perhaps with `:` and the verdict's next word, as in
/// refuted:L10), or the beginning of the verdict's line. False for a word that is none of these and does not begin with `s `.
bool is_behaviour(const std::string& behaviour);
bool shows(const ConformRun& run, const std::string& behaviour);

}  // namespace confidel
