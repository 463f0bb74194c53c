// SPDX-License-Identifier: GPL-3.0-or-later
// Interruption: exit code 130, and nothing half-written stays behind, nor any process at work.
#pragma once

#include <sys/types.h>

#include <string>

namespace confidel {

/// SIGINT and SIGTERM end the program with 130, remove the partial files, if there are any, and end the child process.
void handle_interrupts();

/// A file's name while it is being written; removed on destruction unless it has been renamed, and on interruption.
/// At most four at a time.
class PartialFile {
 public:
  explicit PartialFile(const std::string& final_path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// A process that interruption ends too, as long as this lives. One at a time.
class ChildProcess {
 public:
  explicit ChildProcess(pid_t child);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
};

}  // namespace confidel
