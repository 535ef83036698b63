// SPDX-License-Identifier: MIT
#include "analysis/pictures/image.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/error.h"

namespace lanescope {

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

}  // namespace lanescope
