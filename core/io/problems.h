// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader found wrong, in the order of the file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/complex/input.h"

namespace confidel::io {

class Problems {
 public:
  /// A file with more problems than this is not worth listing further, and the list must stay bounded.
  static constexpr std::size_t limit = 1000;

  /// Records a problem after which reading can go on; throws InputError when the list is full.
  void add(const std::string& code, const Place& place, const std::string& message);
  /// Records a problem after which the rest of the file has no meaning, and throws InputError.
  [[noreturn]] void stop(const std::string& code, const Place& place, const std::string& message);
  /// For readers that go over a file twice: problems in the order of its lines.
  void sort_by_line();
  /// Throws InputError if anything was recorded.
  void throw_if_any() const;

 private:
  std::vector<Problem> list_;
};

}  // namespace confidel::io
