// SPDX-License-Identifier: MIT
// Where two kernels cost the same.
#pragma once

#include <optional>
#include <vector>

namespace lanescope {

/// The cost of one kernel over that of another at a width.
struct CostRatio {
  int width = 0;
  double ratio = 0.0;
};

/// The width, in general no integer, at which the ratio is 1, if it is interpolated linearly over
/// log2 W; the least of several. None if it stays on one side. Requires ascending widths.
std::optional<double> crossing_point(const std::vector<CostRatio>& ratios);

}  // namespace lanescope
