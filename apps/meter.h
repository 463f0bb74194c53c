// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of time and memory, and a line of progress on a terminal (none in a pipe).
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

#include "core/placement/placement.h"

namespace confidel {

/// Peak resident memory of this process in bytes.
std::size_t peak_memory();

class Meter : public Progress {
 public:
  /// Limits of 0 are none. Shows progress only if show is set and standard error is a terminal.
  Meter(double time_limit, std::size_t memory_limit, bool show);
  ~Meter() override;

  void at(const char* stage, long points) override;
  bool stop_requested(long points) override;
  void estimated(double points) override { estimate_ = points; }

  double estimate() const { return estimate_; }
  /// "time-limit" or "memory-limit" once stop_requested has answered true.
  const char* reason() const { return reason_; }
  double elapsed() const;
  /// What is left of the time limit, at least a millisecond; 0 if there is no limit.
  double time_left() const;

 private:
  void clear_line();

  std::chrono::steady_clock::time_point start_;
  double time_limit_;
  std::size_t memory_limit_;
  bool show_;
  bool shown_ = false;
  double estimate_ = 0;
  std::atomic<const char*> reason_{nullptr};
  std::atomic<double> next_memory_test_{0};
  double next_line_ = 0;
};

}  // namespace confidel
