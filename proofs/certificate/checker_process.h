// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the checker as what it is: another program, on the bytes that were written.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace confidel {

struct CheckerOptions {
  std::string certificate;
  std::string complex_file;  ///< the canonical complex that it must be about; empty: not compared
  int threads = 1;
  double time_limit = 0;         ///< seconds; 0: none
  std::size_t memory_limit = 0;  ///< bytes; 0: none
  /// Called with the process as soon as it runs; what it returns lives until the process has ended.
  std::function<std::shared_ptr<void>(pid_t)> started;
};

struct CheckerRun {
  int exit_code = 70;   ///< docs/certificate-format.md, section 6
  std::string report;   ///< its JSON document
  std::string verdict;  ///< its last line, `s ...`
};

/// Runs confidel-check (beside this program, or on PATH). Throws FileError if it cannot be started.
CheckerRun run_checker(const CheckerOptions& options);

}  // namespace confidel
