// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/meter.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace confidel {
namespace {

constexpr double seconds_between_lines = 0.2;
constexpr double seconds_between_memory_tests = 0.05;

std::size_t resident_memory() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  long total = 0, resident = 0;
  const int fields = std::fscanf(file, "%ld %ld", &total, &resident);
  std::fclose(file);
  return fields == 2 ? static_cast<std::size_t>(resident) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace

std::size_t peak_memory() {
  // Not getrusage: its ru_maxrss begins with that of the process that called exec, which may have been larger.
  std::FILE* file = std::fopen("/proc/self/status", "r");
  if (file == nullptr) return 0;
  char line[256];
  unsigned long kilobytes = 0;
  while (std::fgets(line, sizeof line, file) != nullptr)
    if (std::sscanf(line, "VmHWM: %lu kB", &kilobytes) == 1) break;
  std::fclose(file);
  return kilobytes * 1024;
}

Meter::Meter(double time_limit, std::size_t memory_limit, bool show)
    : start_(std::chrono::steady_clock::now()), time_limit_(time_limit), memory_limit_(memory_limit), show_(show && ::isatty(STDERR_FILENO)) {}

Meter::~Meter() { clear_line(); }

void Meter::clear_line() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
  shown_ = false;
}

double Meter::elapsed() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

double Meter::time_left() const { return time_limit_ > 0 ? std::max(0.001, time_limit_ - elapsed()) : 0; }

void Meter::at(const char* stage, long points) {
  if (!show_ || elapsed() < next_line_) return;
  next_line_ = elapsed() + seconds_between_lines;
  std::string line = fmt::format("{:.0f} s  {}", elapsed(), stage);
  if (points > 0) line += fmt::format(": {} points", points);
  if (estimate_ > static_cast<double>(points)) line += fmt::format(", about {:.2g} expected", estimate_);
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 && line.size() >= size.ws_col) line.resize(size.ws_col - 1);
  fmt::print(stderr, "\r{}\x1b[K", line);
  std::fflush(stderr);
  shown_ = true;
}

bool Meter::stop_requested(long) {
  if (reason_.load() != nullptr) return true;
  if (time_limit_ > 0 && elapsed() > time_limit_) {
    reason_ = "time-limit";
    return true;
  }
  if (memory_limit_ > 0) {
    const double now = elapsed();
    if (now >= next_memory_test_.load()) {
      next_memory_test_ = now + seconds_between_memory_tests;
      if (resident_memory() > memory_limit_) {
        reason_ = "memory-limit";
        return true;
      }
    }
  }
  return false;
}

}  // namespace confidel
