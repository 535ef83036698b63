// SPDX-License-Identifier: MIT
#include "analysis/image.h"

#include <png.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Displayed colour of a sample.
Colour sample_colour(std::uint64_t sample, Colour background) {
  if (sample == Frame::kEmpty) return background;
  return {static_cast<std::uint8_t>(sample), static_cast<std::uint8_t>(sample >> 8),
          static_cast<std::uint8_t>(sample >> 16)};
}

}  // namespace

Colour to_colour(float red, float green, float blue) {
  const auto channel = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  return {channel(red), channel(green), channel(blue)};
}

Image resolve(const Frame& frame, Colour background) {
  const SampleGrid& grid = frame.grid();
  const int axis = grid.samples_per_axis();
  Image image{grid.width_px(), grid.height_px(), {}};
  const auto width = static_cast<std::size_t>(image.width_px);
  const auto height = static_cast<std::size_t>(image.height_px);
  std::vector<std::array<std::uint32_t, 3>> light(width);  // Of one row of pixels.
  std::size_t sample = 0;
  for (std::size_t y = 0; y < height; ++y) {
    std::fill(light.begin(), light.end(), std::array<std::uint32_t, 3>{});
    for (int line = 0; line < axis; ++line)
      for (std::size_t cell = 0; cell < width * static_cast<std::size_t>(axis); ++cell) {
        const Colour colour = sample_colour(frame.samples()[sample++], background);
        auto& pixel = light[cell / static_cast<std::size_t>(axis)];
        for (std::size_t c = 0; c < 3; ++c) pixel[c] += std::uint32_t{colour[c]} * colour[c];
      }
    for (const auto& pixel : light) {
      Colour& mean = image.pixels.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>(
            std::lround(std::sqrt(static_cast<double>(pixel[c]) / (axis * axis))));
    }
  }
  return image;
}

std::string png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width_px);
  header.height = static_cast<png_uint_32>(image.height_px);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  const int written =
      png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr);
  LANESCOPE_CHECK(written != 0, "libpng: {}", header.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace lanescope
