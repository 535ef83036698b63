// SPDX-License-Identifier: MIT
#include "analysis/tables/crossing.h"

#include <cmath>

namespace lanescope {

std::optional<double> crossing_point(const std::vector<CostRatio>& ratios) {
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double above = ratios[i].ratio - 1.0;
    if (above == 0.0) return ratios[i].width;
    if (i + 1 == ratios.size()) break;
    const double next = ratios[i + 1].ratio - 1.0;
    if (above * next >= 0.0) continue;
    const double part = above / (above - next);
    return std::exp2(std::lerp(std::log2(ratios[i].width), std::log2(ratios[i + 1].width), part));
  }
  return std::nullopt;
}

}  // namespace lanescope
