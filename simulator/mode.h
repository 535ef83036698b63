// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace lanescope {

/// How a machine runs a program; one kernel source serves all of them. The fast modes are compiled
/// for each number of lanes (Machine), the slow ones once (SlowMachine).
enum class Mode {
  kCounting,   ///< Fast: counts instructions and lanes.
  kChecked,    ///< Slow: counts, tracks dead lanes, and checks every memory access.
  kTracing,    ///< Slow: shows every instruction to an Observer, whose it is to count.
  kUncounted,  ///< Fast: counts nothing: the program at native speed.
};

constexpr bool is_slow(Mode mode) { return mode == Mode::kChecked || mode == Mode::kTracing; }

constexpr std::string_view to_string(Mode mode) {
  switch (mode) {
    case Mode::kCounting:
      return "counting";
    case Mode::kChecked:
      return "checked";
    case Mode::kTracing:
      return "tracing";
    case Mode::kUncounted:
      return "uncounted";
  }
  return {};
}

}  // namespace lanescope
