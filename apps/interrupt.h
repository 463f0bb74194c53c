// SPDX-License-Identifier: GPL-3.0-or-later
// Interruption: exit code 130, and nothing half-written stays behind, nor any process at work.
#pragma once

#include <sys/types.h>

#include <string>

namespace confidel {

/// SIGINT and SIGTERM end the program with 130, remove the partial files, if there are any, and end the child processes.
void handle_interrupts();

/// Returns only if no interruption has begun: what other threads see of processes that it has ended is no observation.
void wait_if_interrupted();

/// A file's name; the file, if there is one by then, is removed on destruction and on interruption. At most 256 at a time.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string name);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_; }
  /// To be called when the file has just been created, in programs of several threads: an interruption that did not see it yet does not leave it.
  void created() const;

 private:
  std::string name_;
};

/// A file's name while it is being written: renamed at the end, or removed.
class PartialFile : public TemporaryFile {
 public:
  explicit PartialFile(const std::string& final_path);
};

/// A process that interruption ends too, as long as this lives. At most 256 at a time.
class ChildProcess {
 public:
  explicit ChildProcess(pid_t child);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

 private:
  pid_t child_;
};

}  // namespace confidel
