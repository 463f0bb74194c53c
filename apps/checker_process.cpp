// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/checker_process.h"

#include "apps/process.h"

namespace confidel {

CheckerRun run_checker(const std::string& certificate, const std::string& complex_file, int threads, double time_limit,
                       std::size_t memory_limit) {
  std::vector<std::string> command{sibling_program("confidel-check"), certificate, "--json", "--threads", std::to_string(threads)};
  if (!complex_file.empty()) command.insert(command.end(), {"--complex", complex_file});
  if (time_limit > 0) command.insert(command.end(), {"--time-limit", std::to_string(time_limit)});
  if (memory_limit > 0) command.insert(command.end(), {"--memory-limit", std::to_string(memory_limit)});
  ProcessResult process = run_process(command);
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
