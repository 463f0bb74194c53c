// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs, run to their end: what they said and how they ended.
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace confidel {

struct ProcessResult {
  int exit_code = -1;  ///< -1 if a signal ended it
  int signal = 0;      ///< 0 if it ended by itself
  std::string output, error;
};

/// Called with the process as soon as it runs; what it returns lives until the process has ended.
using ProcessStarted = std::function<std::shared_ptr<void>(pid_t)>;

/// Runs a program (a path, or a name on PATH) and waits for it. Ended with SIGTERM after time_limit seconds, if that is not 0, and with
/// SIGKILL two seconds later. Safe to call from several threads. Throws FileError if it cannot be started.
ProcessResult run_child(const std::vector<std::string>& command, double time_limit = 0, const ProcessStarted& started = {});

/// The path of a program of ours: beside this one, else as it is, to be found on PATH.
std::string sibling_program(const std::string& name);

/// The path of this program.
std::string own_program();

/// The last line that begins with `s `; empty if there is none.
std::string verdict_line(const std::string& text);

}  // namespace confidel
