// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/problems.h"

#include <algorithm>

namespace confidel::io {

void Problems::add(const std::string& code, const Place& place, const std::string& message) {
  list_.push_back({code, place, message});
  if (list_.size() >= limit) throw InputError(list_);
}

void Problems::stop(const std::string& code, const Place& place, const std::string& message) {
  list_.push_back({code, place, message});
  throw InputError(list_);
}

void Problems::sort_by_line() {
  std::stable_sort(list_.begin(), list_.end(),
                   [](const Problem& a, const Problem& b) { return a.place.line < b.place.line; });
}

void Problems::throw_if_any() const {
  if (!list_.empty()) throw InputError(list_);
}

}  // namespace confidel::io
