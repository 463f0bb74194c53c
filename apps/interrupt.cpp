// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

#include "apps/command.h"

namespace confidel {

namespace {

/// Only async-signal-safe things happen in the handler: it reads this pointer, unlinks and leaves.
std::atomic<const char*> partial_name{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free);

extern "C" void leave(int) {
  if (const char* name = partial_name.load()) unlink(name);
  _exit(exit_interrupted);
}

}  // namespace

void handle_interrupts() {
  struct sigaction action = {};
  action.sa_handler = leave;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A closed pipe is an error when writing, not a death without a word.
  std::signal(SIGPIPE, SIG_IGN);
}

PartialFile::PartialFile(const std::string& final_path) : name_(final_path + ".partial-" + std::to_string(getpid())) {
  partial_name = name_.c_str();
}

PartialFile::~PartialFile() {
  partial_name = nullptr;
  unlink(name_.c_str());
}

}  // namespace confidel
