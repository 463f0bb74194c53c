// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/interrupt.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "apps/command.h"

namespace confidel {

namespace {

/// Only async-signal-safe things happen in the handler: it reads these, unlinks, kills and leaves.
std::array<std::atomic<const char*>, 256> temporary_names{};
std::array<std::atomic<pid_t>, 256> child_processes{};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

extern "C" void leave(int) {
  interrupted = true;
  for (const auto& process : child_processes)
    if (const pid_t child = process.load(); child > 0) kill(child, SIGTERM);
  // What they were about to write has to be there before it can be removed.
  for (const auto& process : child_processes)
    if (const pid_t child = process.load(); child > 0) waitpid(child, nullptr, 0);
  // Twice: another thread may be renaming one of these to another.
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& temporary : temporary_names)
      if (const char* name = temporary.load()) unlink(name);
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

void wait_if_interrupted() {
  while (interrupted) pause();
}

void TemporaryFile::created() const {
  if (interrupted) unlink(name_.c_str());
  wait_if_interrupted();
}

PartialFile::PartialFile(const std::string& final_path) : TemporaryFile(final_path + ".partial-" + std::to_string(getpid())) {}

TemporaryFile::TemporaryFile(std::string name) : name_(std::move(name)) {
  for (auto& temporary : temporary_names) {
    const char* none = nullptr;
    if (temporary.compare_exchange_strong(none, name_.c_str())) return;
  }
}

TemporaryFile::~TemporaryFile() {
  unlink(name_.c_str());
  for (auto& temporary : temporary_names) {
    const char* name = name_.c_str();
    temporary.compare_exchange_strong(name, nullptr);
  }
}

ChildProcess::ChildProcess(pid_t child) : child_(child) {
  for (auto& process : child_processes) {
    pid_t none = 0;
    if (process.compare_exchange_strong(none, child)) return;
  }
}

ChildProcess::~ChildProcess() {
  for (auto& process : child_processes) {
    pid_t child = child_;
    if (process.compare_exchange_strong(child, 0)) return;
  }
}

}  // namespace confidel
