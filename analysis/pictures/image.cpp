// SPDX-License-Identifier: MIT
#include "analysis/pictures/image.h"

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

Image read_png(std::string_view bytes, const std::string& where) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
    throw InputError(where, "is not a PNG file: {}", header.message);
  header.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.pixels.resize(std::size_t{header.width} * header.height);
  const png_color background{};
  if (!png_image_finish_read(&header, &background, image.pixels.data(), 0, nullptr))
    throw InputError(where, "is not a whole PNG file: {}", header.message);
  return image;
}

Image narrowed(const Image& image, int width_px) {
  if (image.width_px <= width_px) return image;
  const double step = static_cast<double>(image.width_px) / width_px;
  Image small{width_px, std::max(1, static_cast<int>(std::lround(image.height_px / step))), {}};
  // The first pixel of a box; boxes differ by a pixel in size where the widths do not divide.
  const auto edge = [](int place, int from, int to) {
    return static_cast<int>(std::int64_t{place} * from / to);
  };
  for (int y = 0; y < small.height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      std::array<double, 3> light{};
      int count = 0;
      for (int v = edge(y, image.height_px, small.height_px);
           v < edge(y + 1, image.height_px, small.height_px); ++v)
        for (int u = edge(x, image.width_px, width_px); u < edge(x + 1, image.width_px, width_px);
             ++u, ++count) {
          const Colour& pixel = image.pixels[static_cast<std::size_t>(v) * image.width_px + u];
          for (std::size_t c = 0; c < 3; ++c) light[c] += pixel[c] * pixel[c];
        }
      Colour& mean = small.pixels.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>(std::lround(std::sqrt(light[c] / count)));
    }
  return small;
}

std::string picture_name(const Configuration& configuration) {
  if (configuration.is_mesh()) return "frame-mesh.png";
  return "frame-" + configuration.scene + ".png";
}

}  // namespace lanescope
