// SPDX-License-Identifier: GPL-3.0-or-later
// The checker as a child that an interruption ends too.
#pragma once

#include "apps/interrupt.h"
#include "proofs/certificate/checker_process.h"

namespace confidel {

/// Runs confidel-check with --json and further arguments. Throws FileError if it cannot be started.
inline CheckerRun run_checker(const std::string& certificate, const std::string& complex_file, int threads, double time_limit, std::size_t memory_limit) {
  return run_checker({certificate, complex_file, threads, time_limit, memory_limit, [](pid_t child) { return std::make_shared<ChildProcess>(child); }});
}

}  // namespace confidel
