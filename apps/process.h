// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs, ended when this one is interrupted.
#pragma once

#include "proofs/certificate/process.h"

namespace confidel {

/// For run_child: interruption of this program ends the child too.
std::shared_ptr<void> end_when_interrupted(pid_t child);

/// A terminal interrupts everybody at once, and a child may be the first to know: does not return if this program is being interrupted.
void settle_interruption(int exit_code);

/// run_child with both.
ProcessResult run_process(const std::vector<std::string>& command, double time_limit = 0);

}  // namespace confidel
