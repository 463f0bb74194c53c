// SPDX-License-Identifier: GPL-3.0-or-later
// The checker, ended when this program is interrupted.
#pragma once

#include "apps/process.h"
#include "proofs/certificate/checker_process.h"

namespace confidel {

/// run_checker of proofs/certificate/checker_process.h; an interruption ends the checker too.
inline CheckerRun run_checker(const std::string& certificate, const std::string& complex_file, int threads, double time_limit, std::size_t memory_limit) {
  CheckerRun run = run_checker({certificate, complex_file, threads, time_limit, memory_limit, end_when_interrupted});
  settle_interruption(run.exit_code);
  return run;
}

}  // namespace confidel
