// SPDX-License-Identifier: MIT
// The picture of lane strips: kernels one above the other on one axis of time.
#pragma once

#include <string>
#include <vector>

#include "analysis/pictures/canvas.h"
#include "analysis/trace/lane_strip.h"

namespace lanescope {

/// The colour of a lane in a column: its stage's where it is on, dark where it is off; the mean
/// over the instructions of the column.
Colour lane_colour(const LaneStrip& strip, std::size_t column, int lane);

/// The contents of a PNG or SVG file. Requires at least one strip, and all at one scale.
std::string lane_strip_picture(const std::vector<LaneStrip>& strips, PictureFormat format);

}  // namespace lanescope
