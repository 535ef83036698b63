// SPDX-License-Identifier: MIT
#include "analysis/pictures/image.h"

#include <gtest/gtest.h>
#include <png.h>

namespace lanescope {
namespace {

constexpr std::uint32_t kRed = 0xff0000ff;  // 0xAABBGGRR
constexpr std::uint32_t kWhite = 0xffffffff;

TEST(Image, IsTheBackgroundWhereNothingIsDrawn) {
  const Frame frame(SampleGrid(2, 1, 4, false, 1));
  const Image image = resolve(frame, {10, 20, 30});
  EXPECT_EQ(image.pixels, (std::vector<Colour>{{10, 20, 30}, {10, 20, 30}}));
}

TEST(Image, AveragesLightOverThePixel) {
  Frame frame(SampleGrid(2, 1, 4, false, 1));  // Cells: 4 x 2; the left pixel is 0, 1, 4, 5.
  for (const std::uint32_t sample : {0u, 1u, 4u, 5u}) frame.merge(sample, 0.5f, kRed);
  frame.merge(2, 0.5f, kWhite);
  const Image image = resolve(frame, {0, 0, 0});
  EXPECT_EQ(image.pixels[0], (Colour{255, 0, 0}));
  EXPECT_EQ(image.pixels[1], (Colour{128, 128, 128}));  // sqrt(255^2 / 4) = 127.5
}

TEST(Image, PngHoldsThePixels) {
  const Image image{2, 2, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}}};
  const std::string bytes = png(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  header.format = PNG_FORMAT_RGB;
  EXPECT_EQ(header.width, 2u);
  EXPECT_EQ(header.height, 2u);
  std::vector<Colour> pixels(4);
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, image.pixels);
}

}  // namespace
}  // namespace lanescope
