// SPDX-License-Identifier: MIT
#include "analysis/pictures/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <set>

#include "analysis/pictures/heat_map.h"
#include "analysis/pictures/palette.h"
#include "analysis/pictures/picture_title.h"
#include "kernels/micropolygons/frame.h"

namespace lanescope {
namespace {

constexpr std::uint32_t kRed = 0xff0000ff;  // 0xAABBGGRR
constexpr std::uint32_t kWhite = 0xffffffff;

TEST(Image, IsTheBackgroundWhereNothingIsDrawn) {
  const Frame frame(SampleGrid(2, 1, 4, false, 1), {10, 20, 30});
  const Image image = *frame.picture();
  EXPECT_EQ(image.pixels, (std::vector<Colour>{{10, 20, 30}, {10, 20, 30}}));
}

TEST(Image, AveragesLightOverThePixel) {
  Frame frame(SampleGrid(2, 1, 4, false, 1));  // Cells: 4 x 2; the left pixel is 0, 1, 4, 5.
  for (const std::uint32_t sample : {0u, 1u, 4u, 5u}) frame.merge(sample, 0.5f, kRed);
  frame.merge(2, 0.5f, kWhite);
  const Image image = *frame.picture();
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

TEST(Image, ARasterIsWrittenAsColoursOrAsAHeatMap) {
  Raster raster;
  raster.width_px = 2;
  raster.height_px = 1;
  raster.pixels = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(raster_png(raster, "title"), png(raster));
  raster.pixels.clear();
  raster.counts = {0, 3};
  EXPECT_EQ(raster_png(raster, "title"), heat_map_png(raster, "title"));
}

Configuration configuration(const std::string& scene) {
  Arguments given;
  given.set("scene", scene);
  given.set("kernel", std::string("lockstep"));
  return resolved(given);
}

TEST(PictureTitle, SaysWhatIsNotAsByDefault) {
  Configuration c = configuration("teapot");
  EXPECT_EQ(picture_title(c), "teapot, micropolygon = triangle, frame = 4");
  set_value(c, "micropolygon", std::string("quad"));
  set_value(c, "height_px", std::uint64_t{300});
  set_value(c, "edges", std::string("precomputed"));  // Of the kernel: pictures show it in no way.
  EXPECT_EQ(picture_title(c), "teapot, micropolygon = quad, resolution = 1728x300, frame = 4");
  EXPECT_EQ(picture_command(c, "x.png"),
            "lanescope render --scene teapot --micropolygon quad --resolution 1728x300 --frame 4 "
            "-o x.png");
}

TEST(PictureTitle, OfAKernelThatTheProgramDoesNotHave) {
  Configuration c;
  c.kernel = "unheard-of";
  c.scene = "elsewhere";
  EXPECT_EQ(picture_title(c), "elsewhere");
}

TEST(PictureName, IsOfTheSceneOrOfItsFile) {
  EXPECT_EQ(picture_name(configuration("teapot")), "frame-teapot.png");
  EXPECT_EQ(picture_name(configuration("models/bunny.obj")), "frame-bunny.png");
}

TEST(Palette, StagesHaveColoursOfTheirOwn) {
  EXPECT_EQ(stage_colour("Setup"), (Colour{0x8c, 0x8c, 0x8c}));
  EXPECT_EQ(stage_colour("Bound"), (Colour{0x00, 0x72, 0xb2}));
  EXPECT_EQ(stage_colour("Test Stream-load"), (Colour{0xcc, 0x79, 0xa7}));
  EXPECT_EQ(stage_colour("Test"), (Colour{0x00, 0x9e, 0x73}));
  EXPECT_EQ(stage_colour("Process"), (Colour{0xd5, 0x5e, 0x00}));
}

TEST(Palette, UnknownStagesShareOthers) {
  const std::set<Colour> own{stage_colour("Setup"), stage_colour("Bound"), stage_colour("Test"),
                             stage_colour("Test Stream-load"), stage_colour("Process")};
  for (const char* name : {"", "Unheard-of", "setup", "Another"})
    EXPECT_FALSE(own.contains(stage_colour(name))) << name;
  EXPECT_EQ(stage_colour("Unheard-of"), stage_colour("Unheard-of"));
}

TEST(Palette, StagesAreShownInAnOrderThatAgreesWithEachKernel) {
  const auto& known = known_stages();
  const auto place = [&](std::string_view stage) {
    return std::find(known.begin(), known.end(), stage) - known.begin();
  };
  for (const Kernel* kernel : kernels())
    for (std::size_t i = 1; i < kernel->stages.size(); ++i)
      EXPECT_LT(place(kernel->stages[i - 1]), place(kernel->stages[i])) << kernel->name;
  EXPECT_LT(place("Test Stream-load"), place("Test"));
  EXPECT_EQ(place("Test Stream-load"), place("Bound") + 1);
}

}  // namespace
}  // namespace lanescope
