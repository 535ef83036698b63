// SPDX-License-Identifier: MIT
// Pictures of frames.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/frame.h"

namespace lanescope {

/// Red, green and blue as displayed, 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// The colour of channels in [0, 1], as displayed; clamped.
Colour to_colour(float red, float green, float blue);

struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<Colour> pixels;  ///< [height_px * width_px], by rows from the top.
};

/// Averages the samples of each pixel (a box filter). Colours are averaged as light, which is the
/// square of the displayed value; samples that nothing covers are `background`.
Image resolve(const Frame& frame, Colour background);

/// The bytes of a PNG file. Requires at least one pixel.
std::string png(const Image& image);

}  // namespace lanescope
