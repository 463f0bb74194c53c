// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/complex/input.h"

#include <utility>

namespace confidel {

namespace {

std::string summary(const std::vector<Problem>& problems) {
  if (problems.empty()) return "bad input";
  return problems.front().code + ": " + problems.front().message;
}

}  // namespace

InputError::InputError(std::vector<Problem> problems_found)
    : std::runtime_error(summary(problems_found)), problems(std::move(problems_found)) {}

}  // namespace confidel
