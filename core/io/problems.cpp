// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/problems.h"

namespace confidel::io {

void Problems::add(const std::string& code, const Place& place, const std::string& message) {
  list_.push_back({code, place, message});
  if (list_.size() >= limit) throw InputError(list_);
}

void Problems::stop(const std::string& code, const Place& place, const std::string& message) {
  list_.push_back({code, place, message});
  throw InputError(list_);
}

void Problems::throw_if_any() const {
  if (!list_.empty()) throw InputError(list_);
}

}  // namespace confidel::io
