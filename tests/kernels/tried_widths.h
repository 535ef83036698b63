// SPDX-License-Identifier: MIT
// The widths at which the tests of every kind of work try its kernels.
#pragma once

#include <vector>

#include "kernels/kernel.h"

namespace lanescope::test {

/// Powers of two, their neighbours, and some that are neither.
inline constexpr int kTriedWidths[] = {1, 3, 4, 7, 8, 15, 16, 17, 31, 32, 33, 47, 63, 64};

/// Those of kTriedWidths that the kernel can be started with.
inline std::vector<int> tried_widths(const Kernel& kernel) {
  std::vector<int> widths;
  for (const int width : kTriedWidths)
    if (width <= kernel.most_width) widths.push_back(width);
  return widths;
}

}  // namespace lanescope::test
