// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/interrupt.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "apps/command.h"

namespace confidel {

namespace {

/// Only async-signal-safe things happen in the handler: it reads these, unlinks, kills and leaves.
std::array<std::atomic<const char*>, 4> partial_names{};
std::atomic<pid_t> child_process{0};
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

extern "C" void leave(int) {
  for (const auto& partial : partial_names)
    if (const char* name = partial.load()) unlink(name);
  if (const pid_t child = child_process.load(); child > 0) kill(child, SIGTERM);
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
  for (auto& partial : partial_names) {
    const char* none = nullptr;
    if (partial.compare_exchange_strong(none, name_.c_str())) return;
  }
}

PartialFile::~PartialFile() {
  unlink(name_.c_str());
  for (auto& partial : partial_names) {
    const char* name = name_.c_str();
    partial.compare_exchange_strong(name, nullptr);
  }
}

ChildProcess::ChildProcess(pid_t child) { child_process = child; }
ChildProcess::~ChildProcess() { child_process = 0; }

}  // namespace confidel
