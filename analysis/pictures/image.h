// SPDX-License-Identifier: MIT
// Pictures as pixels, and as PNG files.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernels/output.h"

namespace lanescope {

/// A picture as colours.
struct Image {
  Image() = default;
  Image(int width, int height, std::vector<Colour> colours)
      : width_px(width), height_px(height), pixels(std::move(colours)) {}
  /// The colours of a raster that has some.
  Image(const Raster& raster) : Image(raster.width_px, raster.height_px, raster.pixels) {}

  int width_px = 0;
  int height_px = 0;
  std::vector<Colour> pixels;  ///< [height_px * width_px], by rows from the top.
};

/// The bytes of a PNG file. Requires at least one pixel.
std::string png(const Image& image);

/// The picture of a PNG file, without transparency. `where` names it in messages. Throws InputError
/// if the bytes are none.
Image read_png(std::string_view bytes, const std::string& where);

/// The same picture at most so wide, by a box filter. Colours are averaged as light,
/// which is the square of the displayed value.
Image narrowed(const Image& image, int width_px);

}  // namespace lanescope
