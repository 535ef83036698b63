// SPDX-License-Identifier: MIT
// A picture of counts over the frame, with its scale.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lanescope {

/// Counts of pixels, and what to say of them.
struct HeatMap {
  int width_px;
  int height_px;
  std::vector<std::uint64_t> counts;  ///< [height_px * width_px], by rows from the top.
  std::uint64_t unit;                 ///< What is shown is the count divided by this.
  std::string title;                  ///< A sentence above the picture.
  std::string axis;                   ///< What is shown, beside the scale.
};

/// The value at which the scale ends: few pixels are above it, and they do not darken the others.
double scale_end(const HeatMap& map);

/// The contents of a PNG file: pixel for pixel, dark where the count is 0, with a colour bar.
std::string heat_map_png(const HeatMap& map);

}  // namespace lanescope
