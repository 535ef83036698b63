// SPDX-License-Identifier: MIT
#include "analysis/cli/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <utility>

namespace lanescope {
namespace {

constexpr double kTerminalPeriod_s = 0.2;
/// Lines elsewhere come at 1, 2, 4, 8 ... seconds.
constexpr double kBackOff = 2.0;
/// Less work than this tells nothing about the rest.
constexpr double kTelling = 0.02;

/// Whether lines can be drawn over on standard error.
bool can_redraw() {
  const char* const kind = std::getenv("TERM");
  const std::string_view word = kind ? kind : "";
  return ::isatty(STDERR_FILENO) == 1 && !word.empty() && word != "dumb";
}

/// The characters that a line on standard error can have before it is broken.
std::size_t line_length() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return std::numeric_limits<std::size_t>::max();
  return size.ws_col - std::size_t{1};  // Some terminals break a line when it is full.
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

Progress::Progress(std::string title)
    : title_(std::move(title)), terminal_(can_redraw()), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (drawn_ && terminal_) std::fputs("\r\033[K", stderr);
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::update(double fraction, std::string_view detail) {
  const double elapsed = elapsed_s();
  if (elapsed < next_s_) return;
  next_s_ = terminal_ ? elapsed + kTerminalPeriod_s : elapsed * kBackOff;
  drawn_ = true;
  std::string text =
      fmt::format("{}: {:.0f}%, {}", title_, 100.0 * fraction, duration_text(elapsed));
  if (!detail.empty()) text += fmt::format(", {}", detail);
  if (fraction >= kTelling)
    text += fmt::format(", about {} left", duration_text(elapsed * (1.0 / fraction - 1.0)));
  text.resize(std::min(text.size(), line_length()));
  text = terminal_ ? fmt::format("\r{}\033[K", text) : text + '\n';
  std::fputs(text.c_str(), stderr);
}

}  // namespace lanescope
