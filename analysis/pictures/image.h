// SPDX-License-Identifier: MIT
// Pictures of frames.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "kernels/micropolygons/frame.h"

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

/// The picture of a PNG file, without transparency. `where` names it in messages. Throws InputError
/// if the bytes are none.
Image read_png(std::string_view bytes, const std::string& where);

/// The same picture at most so wide, by a box filter that averages light as resolve() does.
Image narrowed(const Image& image, int width_px);

/// The file, within a directory of pictures, that shows the scene of a configuration; the path of a
/// mesh is not a name.
std::string picture_name(const Configuration& configuration);

}  // namespace lanescope
