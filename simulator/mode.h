// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace lanescope {

/// How a machine runs a program; one kernel source serves all of them.
enum class Mode {
  kCounting,   ///< Counts instructions and lanes.
  kChecked,    ///< Counts, tracks dead lanes, and checks every memory access.
  kTracing,    ///< Counts, and shows every instruction to an Observer.
  kUncounted,  ///< Counts nothing: the program at native speed.
};

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
