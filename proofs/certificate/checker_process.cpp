// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/checker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "core/complex/input.h"

extern char** environ;

namespace confidel {
namespace {

std::string checker_path() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto beside = self.parent_path() / "confidel-check";
    if (std::filesystem::exists(beside, error)) return beside.string();
  }
  return "confidel-check";
}

// Reads both pipes to their ends without letting either block the other.
void drain(const std::array<int, 2>& pipes, std::array<std::string, 2>& texts) {
  std::array<pollfd, 2> watched{pollfd{pipes[0], POLLIN, 0}, pollfd{pipes[1], POLLIN, 0}};
  int open = 2;
  while (open > 0) {
    if (::poll(watched.data(), watched.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    for (int i = 0; i < 2; ++i) {
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
}

}  // namespace

CheckerRun run_checker(const CheckerOptions& options) {
  const std::string program = checker_path();
  std::vector<std::string> arguments{program, options.certificate, "--json", "--threads", std::to_string(options.threads)};
  if (!options.complex_file.empty()) {
    arguments.push_back("--complex");
    arguments.push_back(options.complex_file);
  }
  if (options.time_limit > 0) {
    arguments.push_back("--time-limit");
    arguments.push_back(std::to_string(options.time_limit));
  }
  if (options.memory_limit > 0) {
    arguments.push_back("--memory-limit");
    arguments.push_back(std::to_string(options.memory_limit));
  }
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);

  std::array<int, 2> output{}, error{};
  if (::pipe2(output.data(), O_CLOEXEC) != 0 || ::pipe2(error.data(), O_CLOEXEC) != 0) throw FileError("cannot open a pipe to the checker");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error[1], STDERR_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  ::close(error[1]);
  if (failure != 0) {
    ::close(output[0]);
    ::close(error[0]);
    throw FileError(program + ": the checker cannot be started: " + std::strerror(failure) + "; it is expected beside confidel or on PATH");
  }
  const std::shared_ptr<void> interrupted_too = options.started ? options.started(child) : nullptr;
  std::array<std::string, 2> texts;
  drain({output[0], error[0]}, texts);
  ::close(output[0]);
  ::close(error[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  CheckerRun run;
  run.report = texts[0];
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 70;
  // The verdict is the line that begins with `s `; without one, what it said is an error message.
  const std::string lines = '\n' + texts[1];
  const std::size_t begin = lines.rfind("\ns ");
  run.verdict = begin == std::string::npos ? texts[1] : lines.substr(begin + 1, lines.find('\n', begin + 1) - begin - 1);
  // A program that ends well without saying so was no checker.
  if (run.exit_code == 0 && run.verdict != "s VERIFIED") run.exit_code = 70;
  return run;
}

}  // namespace confidel
