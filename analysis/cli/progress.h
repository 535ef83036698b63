// SPDX-License-Identifier: MIT
// Progress on standard error for work that takes longer than a second.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace lanescope {

/// Shows a title, the finished share, the time taken and the time left: in place on a terminal, cut
/// to its width, and as a line now and then, ever more rarely, elsewhere and on a terminal that
/// cannot do that (`TERM=dumb`). Work of under a second shows nothing.
/// Everything happens on the thread that calls it.
class Progress {
 public:
  explicit Progress(std::string title);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Clears the line on a terminal.
  ~Progress();

  /// `fraction` of the work is done, from 0 to 1. `detail` says more about it.
  void update(double fraction, std::string_view detail = {});
  double elapsed_s() const;

 private:
  std::string title_;
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_;
  double next_s_ = 1.0;  ///< When to show it again.
};

/// `7 s`, `3 min 20 s`.
std::string duration_text(double seconds);

}  // namespace lanescope
