// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the checker as what it is: another program, on the bytes that were written.
#pragma once

#include <string>

namespace confidel {

struct CheckerRun {
  int exit_code = 70;
  std::string report;   ///< its JSON document
  std::string verdict;  ///< its last line, `s ...`
};

/// Runs confidel-check (beside this program, or on PATH) with --json and further arguments, without --complex if complex_file is empty. Throws FileError if it cannot be started.
CheckerRun run_checker(const std::string& certificate, const std::string& complex_file, int threads, double time_limit,
                       std::size_t memory_limit);

}  // namespace confidel
