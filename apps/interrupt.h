// SPDX-License-Identifier: GPL-3.0-or-later
// Interruption: exit code 130, and nothing half-written stays behind.
#pragma once

#include <string>

namespace confidel {

/// SIGINT and SIGTERM end the program with 130 and remove the partial file, if there is one.
void handle_interrupts();

/// A file's name while it is being written; removed on destruction unless it has been renamed, and on interruption.
/// One at a time.
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

}  // namespace confidel
