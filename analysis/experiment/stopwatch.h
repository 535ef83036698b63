// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace lanescope {

/// Tells the time since it was made or last told.
class Stopwatch {
 public:
  double ms() {
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return passed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace lanescope
