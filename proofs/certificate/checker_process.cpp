// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/checker_process.h"

#include "proofs/certificate/process.h"

namespace confidel {

CheckerRun run_checker(const CheckerOptions& options) {
  std::vector<std::string> command{sibling_program("confidel-check"), options.certificate, "--json", "--threads", std::to_string(options.threads)};
  if (!options.complex_file.empty()) command.insert(command.end(), {"--complex", options.complex_file});
  if (options.time_limit > 0) command.insert(command.end(), {"--time-limit", std::to_string(options.time_limit)});
  if (options.memory_limit > 0) command.insert(command.end(), {"--memory-limit", std::to_string(options.memory_limit)});
  ProcessResult process = run_child(command, 0, options.started);
  CheckerRun run;
  run.exit_code = process.signal == 0 ? process.exit_code : 70;
  // Without a verdict, what it said is an error message.
  run.verdict = verdict_line(process.error);
  if (run.verdict.empty()) run.verdict = process.error;
  run.report = std::move(process.output);
  // A program that ends well without saying so was no checker.
  if (run.exit_code == 0 && run.verdict != "s VERIFIED") run.exit_code = 70;
  return run;
}

}  // namespace confidel
