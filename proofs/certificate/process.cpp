// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "core/complex/input.h"

extern char** environ;

namespace confidel {
namespace {

using Clock = std::chrono::steady_clock;

// Reads both pipes to their ends without letting either block the other; false when time is up.
bool drain(const std::array<int, 2>& pipes, std::array<std::string, 2>& texts, double time_limit) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_limit));
  std::array<pollfd, 2> watched{pollfd{pipes[0], POLLIN, 0}, pollfd{pipes[1], POLLIN, 0}};
  int open = 2;
  while (open > 0) {
    int wait = -1;
    if (time_limit > 0) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      if (left <= 0) return false;
      wait = static_cast<int>(std::min<long long>(left + 1, 1'000'000));
    }
    if (::poll(watched.data(), watched.size(), wait) < 0) {
      if (errno == EINTR) continue;
      return true;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (watched[i].fd < 0 || watched[i].revents == 0) continue;
      char buffer[4096];
      const ssize_t count = ::read(watched[i].fd, buffer, sizeof buffer);
      if (count > 0) {
        texts[i].append(buffer, static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        watched[i].fd = -1;
        --open;
      }
    }
  }
  return true;
}

}  // namespace

std::string own_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

std::string sibling_program(const std::string& name) {
  std::error_code error;
  const auto beside = std::filesystem::path(own_program()).parent_path() / name;
  return std::filesystem::exists(beside, error) ? beside.string() : name;
}

std::string verdict_line(const std::string& text) {
  const std::string lines = '\n' + text;
  const std::size_t begin = lines.rfind("\ns ");
  return begin == std::string::npos ? std::string() : lines.substr(begin + 1, lines.find('\n', begin + 1) - begin - 1);
}

ProcessResult run_child(const std::vector<std::string>& command, double time_limit, const ProcessStarted& started) {
  std::vector<std::string> arguments = command;
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);

  std::array<int, 2> output{}, error{};
  if (::pipe2(output.data(), O_CLOEXEC) != 0) throw FileError(command[0] + ": cannot open a pipe to it");
  if (::pipe2(error.data(), O_CLOEXEC) != 0) {
    ::close(output[0]), ::close(output[1]);
    throw FileError(command[0] + ": cannot open a pipe to it");
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error[1], STDERR_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, command[0].c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  ::close(error[1]);
  if (failure != 0) {
    ::close(output[0]);
    ::close(error[0]);
    throw FileError(command[0] + ": cannot be started: " + std::strerror(failure) + "; it is expected beside confidel or on PATH");
  }
  const std::shared_ptr<void> kept = started ? started(child) : nullptr;
  std::array<std::string, 2> texts;
  if (!drain({output[0], error[0]}, texts, time_limit)) {
    // It may have children of its own to end.
    constexpr double grace = 2;
    ::kill(child, SIGTERM);
    if (!drain({output[0], error[0]}, texts, grace)) ::kill(child, SIGKILL);
  }
  ::close(output[0]);
  ::close(error[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ProcessResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  else if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.output = std::move(texts[0]);
  result.error = std::move(texts[1]);
  return result;
}

}  // namespace confidel
