// SPDX-License-Identifier: MIT
#include "analysis/pictures/heat_map.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <vector>

#include "analysis/pictures/palette.h"

namespace lanescope {
namespace {

Raster counts_of(int width_px, int height_px, std::uint64_t each, std::uint64_t unit) {
  Raster raster;
  raster.width_px = width_px;
  raster.height_px = height_px;
  raster.counts.assign(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
                       each);
  raster.count_unit = unit;
  raster.counted = "axis";
  return raster;
}

TEST(HeatMap, EndsItsScaleBelowTheFewLargestCounts) {
  Raster raster = counts_of(1001, 1, 8, 4);
  raster.counts[0] = 0;
  raster.counts[1] = 800;
  EXPECT_EQ(scale_end(raster), 2.0);
  raster.counts.assign(1001, 0);
  EXPECT_EQ(scale_end(raster), 1.0);
}

TEST(HeatMap, IsAPngWithAPixelForEachCount) {
  Raster raster = counts_of(300, 200, 0, 1);
  for (std::size_t i = 0; i < 1000; ++i) raster.counts[i] = 6;
  const std::string bytes = heat_map_png(raster, "title");
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  header.format = PNG_FORMAT_RGB;
  std::vector<Colour> pixels(std::size_t{header.width} * header.height);
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(std::count(pixels.begin(), pixels.end(), kNothing), 300 * 200 - 1000);
  EXPECT_EQ(std::count(pixels.begin(), pixels.end(), heat_colour(1.0)), 1000);
}

TEST(Palette, HeatGrowsLighter) {
  const auto light = [](Colour c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(light(heat_colour(i / 100.0)), light(heat_colour((i + 1) / 100.0)) + 1.0) << i;
  EXPECT_EQ(heat_colour(-1.0), heat_colour(0.0));
  EXPECT_EQ(heat_colour(2.0), heat_colour(1.0));
}

}  // namespace
}  // namespace lanescope
