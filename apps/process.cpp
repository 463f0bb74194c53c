// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/process.h"

#include <chrono>
#include <thread>

#include "apps/command.h"
#include "apps/interrupt.h"

namespace confidel {

std::shared_ptr<void> end_when_interrupted(pid_t child) { return std::make_shared<ChildProcess>(child); }

void settle_interruption(int exit_code) {
  if (exit_code == exit_interrupted) std::this_thread::sleep_for(std::chrono::milliseconds(300));
  wait_if_interrupted();
}

ProcessResult run_process(const std::vector<std::string>& command, double time_limit) {
  ProcessResult result = run_child(command, time_limit, end_when_interrupted);
  settle_interruption(result.exit_code);
  return result;
}

}  // namespace confidel
