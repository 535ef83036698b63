// SPDX-License-Identifier: MIT
// A catalogue of small kernels, each with one mistake. The line that is at fault ends in `//
// wrong`.
#pragma once

#include <span>
#include <string_view>

#include "simulator/instruction_set.h"

namespace lanescope::test {

/// A kernel with a mistake that a checked machine of 8 lanes finds.
struct BrokenKernel {
  std::string_view name;     ///< Of the function.
  std::string_view mistake;  ///< In words.
  Check check;               ///< The only one that finds it.
  std::string_view message;  ///< What it says, behind file and line.
  int width;
  void (*run)(SlowMachine<8>& vm);
};

std::span<const BrokenKernel> broken_kernels();

/// A kernel whose results depend on the width, which no single run can show.
struct WidthDependence {
  std::string_view name;
  std::string_view mistake;
  std::string_view message;                      ///< What comparing runs finds.
  std::int32_t (*run)(SlowMachine<8>& vm);       ///< Returns its result.
  std::int32_t (*repaired)(SlowMachine<8>& vm);  ///< The same without the mistake.
};

const WidthDependence& width_dependence();

}  // namespace lanescope::test
