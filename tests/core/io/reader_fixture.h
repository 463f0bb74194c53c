// SPDX-License-Identifier: GPL-3.0-or-later
// Files from literals, and tables of malformed ones.
#pragma once

#include <string>
#include <vector>

#include "core/complex/input.h"

namespace confidel::test {

/// A folder of its own that vanishes at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Writes the file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
};

/// Reads a file of this suffix with this text, through read_input.
Input read_text(const std::string& suffix, const std::string& text);

/// A text that must be refused, and the first problem that must be reported.
struct Malformed {
  std::string why;
  std::string text;
  std::string code;
  int line;
  int column;
};
void check_malformed(const std::string& suffix, const std::vector<Malformed>& table);

/// The problems of a text that must be refused; none if it is accepted.
std::vector<Problem> problems_of(const std::string& suffix, const std::string& text);

/// Replaces the only occurrence of a part: one error per malformed text, made from a good one.
std::string with(std::string text, const std::string& part, const std::string& replacement);

}  // namespace confidel::test
