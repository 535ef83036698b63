// SPDX-License-Identifier: MIT
#include "analysis/cli/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "analysis/base/temporary_file.h"

namespace lanescope {
namespace {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU};

/// Where the handler can read them.
std::array<char, 256> interruption{};
bool is_terminal = false;
bool closed_pipe_ends = false;

/// Calls only what a signal handler may call.
void write_error(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // Nobody to tell.
}

extern "C" void end_by(int signal) {
  remove_temporary_files();
  if (is_terminal) write_error("\n");  // After the progress, and what the terminal echoes.
  write_error(interruption.data());
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  ::sigaction(signal, &action, nullptr);
  ::raise(signal);  // Is delivered when the handler returns.
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  for (const int other : kEndingSignals) ::sigaddset(&action.sa_mask, other);
  ::sigaction(signal, &action, nullptr);
}

/// A descriptor that can be neither read nor written, as closed ones cannot.
void occupy(int stream) {
  if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) return;
  const int opened = ::open("/", O_PATH);  // Gets the lowest free number.
  if (opened < 0 || opened == stream) return;
  ::dup2(opened, stream);
  ::close(opened);
}

}  // namespace

void set_up_process() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) occupy(stream);
  is_terminal = ::isatty(STDERR_FILENO) == 1;
  closed_pipe_ends = !is_ignored(SIGPIPE);
  say_when_interrupted("lanescope");
  for (const int signal : kEndingSignals)
    if (!is_ignored(signal)) handle(signal, end_by);
  for (const int signal : {SIGPIPE, SIGXFSZ}) handle(signal, SIG_IGN);
}

void say_when_interrupted(std::string_view command, std::string_view consequence) {
  const auto end = fmt::format_to_n(interruption.data(), interruption.size() - 2,
                                    "lanescope: {}: interrupted{}{}", command,
                                    consequence.empty() ? "" : "; ", consequence);
  std::copy_n("\n", 2, end.out);
}

void end_by_closed_pipe() {
  if (!closed_pipe_ends) return;
  handle(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
}

}  // namespace lanescope
