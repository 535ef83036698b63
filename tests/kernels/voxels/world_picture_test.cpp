// SPDX-License-Identifier: MIT
// Pictures of small worlds, with harmonics that are made up: what is where, and how dark.
#include "kernels/voxels/world_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include "simulator/base/error.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr Colour kHalf{180, 180, 180};  ///< Displays 0.5.

/// The sky above a plain.
Harmonics half_open() { return {std::sqrt(kPi), 0.0f, std::sqrt(0.75f * kPi), 0.0f}; }

/// A world with the harmonics of its probes: what `harmonics` gives for each corner.
struct Lit {
  template <class HarmonicsAt>
  Lit(World w, const HarmonicsAt& harmonics_at)
      : world(std::make_shared<const World>(std::move(w))),
        source(world),
        field(world, source.probe_count()) {
    source.for_each_probe(
        [&](Cube corner, std::uint64_t number) { field.write(number, harmonics_at(corner)); });
  }

  Raster draw(Shown shown) const { return draw_world(*world, field, shown); }

  std::shared_ptr<const World> world;
  VoxelSource source;
  ProbeField field;
};

Lit half_open(World world) {
  return Lit(std::move(world), [](Cube) { return half_open(); });
}

World empty_world(Cube size) {
  World world(size);
  world.palette[1] = {200, 120, 40};
  return world;
}

World plain(int size) {
  World world = empty_world({size, 4, size});
  for (int z = 0; z < size; ++z)
    for (int x = 0; x < size; ++x) world.fill({x, 0, z}, 1);
  return world;
}

const Raster& sky_alone() {
  static const Raster sky = half_open(empty_world({1, 1, 1})).draw(Shown::kFinal);
  return sky;
}

/// Indices of the pixels in which something is drawn before the sky, with all their neighbours.
std::vector<std::size_t> inner_pixels(const Raster& raster) {
  const Raster& sky = sky_alone();
  const auto width = static_cast<std::size_t>(raster.width_px);
  const auto drawn = [&](std::size_t i) { return raster.pixels[i] != sky.pixels[i]; };
  std::vector<std::size_t> inner;
  for (std::size_t i = width + 1; i + width + 1 < raster.pixels.size(); ++i)
    if (drawn(i) && drawn(i - 1) && drawn(i + 1) && drawn(i - width) && drawn(i + width))
      inner.push_back(i);
  return inner;
}

int brightness(const Colour& colour) { return colour[0] + colour[1] + colour[2]; }

int darkest(const Raster& raster) {
  int least = 3 * 255;
  for (const std::size_t i : inner_pixels(raster))
    least = std::min(least, brightness(raster.pixels[i]));
  return least;
}

constexpr Shown kAll[] = {Shown::kCubes, Shown::kOcclusion, Shown::kAmbient, Shown::kLighting,
                          Shown::kFinal};

TEST(WorldPicture, OfNothingIsTheSky) {
  const Lit lit = half_open(empty_world({3, 4, 5}));
  EXPECT_EQ(lit.source.probe_count(), 0u);
  const Raster& sky = sky_alone();
  for (const Shown shown : kAll) EXPECT_EQ(lit.draw(shown).pixels, sky.pixels);
  for (int y = 0; y < sky.height_px; ++y) {
    const auto row = sky.pixels.begin() + std::ptrdiff_t{y} * sky.width_px;
    EXPECT_TRUE(std::all_of(row, row + sky.width_px, [&](Colour c) { return c == *row; }));
  }
}

TEST(WorldPicture, FramesACubeOfAnEmptyWorld) {
  World world = empty_world({9, 7, 8});
  world.fill({2, 5, 1}, 1);
  const Lit lit = half_open(std::move(world));
  for (const Shown shown : kAll) {
    const Raster raster = lit.draw(shown);
    EXPECT_EQ(raster.width_px, 960);
    EXPECT_EQ(raster.height_px, 600);
    ASSERT_EQ(raster.pixels.size(), 960u * 600u);
    EXPECT_TRUE(raster.counts.empty());
    const std::size_t inner = inner_pixels(raster).size();
    EXPECT_GT(inner, 100'000u);
    EXPECT_LT(inner, 400'000u);
    for (const std::size_t border : {0u, 959u, 599u * 960u, 600u * 960u - 1u})
      EXPECT_EQ(raster.pixels[border], sky_alone().pixels[border]);
  }
}

TEST(WorldPicture, OfAWorldOfOneCubeIsTheSameWhereverTheCubeIs) {
  World one = empty_world({1, 1, 1});
  one.fill({0, 0, 0}, 1);
  World elsewhere = empty_world({3, 3, 3});
  elsewhere.fill({2, 0, 1}, 1);
  const Raster a = half_open(std::move(one)).draw(Shown::kFinal);
  const Raster b = half_open(std::move(elsewhere)).draw(Shown::kFinal);
  std::size_t differing = 0;  // But for the rounding of edges.
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    differing += std::abs(brightness(a.pixels[i]) - brightness(b.pixels[i])) > 6;
  EXPECT_LT(differing, 2000u);
}

TEST(WorldPicture, ShowsThreeFacesOfACube) {
  World world = empty_world({1, 1, 1});
  world.fill({0, 0, 0}, 1);
  const Raster raster = half_open(std::move(world)).draw(Shown::kCubes);
  std::map<Colour, int> pixels;
  for (const std::size_t i : inner_pixels(raster)) ++pixels[raster.pixels[i]];
  // The rest are those on an edge.
  EXPECT_EQ(std::count_if(pixels.begin(), pixels.end(), [](auto n) { return n.second > 20'000; }),
            3);
  EXPECT_GT((pixels[{200, 120, 40}]), 20'000);  // As in the palette, from above.
}

TEST(WorldPicture, OccludesAPlainEvenly) {
  const Raster raster = half_open(plain(8)).draw(Shown::kOcclusion);
  const auto inner = inner_pixels(raster);
  EXPECT_GT(inner.size(), 100'000u);
  for (const std::size_t i : inner) ASSERT_EQ(raster.pixels[i], kHalf);
}

TEST(WorldPicture, DarkensAroundAnOccludedCorner) {
  const Cube occluded{4, 1, 4};
  const Lit lit(plain(8),
                [&](Cube corner) { return corner == occluded ? Harmonics{} : half_open(); });
  for (const Shown shown : {Shown::kOcclusion, Shown::kFinal}) {
    const Raster open = half_open(plain(8)).draw(shown);
    const Raster raster = lit.draw(shown);
    std::size_t darker = 0;
    for (std::size_t i = 0; i < raster.pixels.size(); ++i) {
      ASSERT_LE(brightness(raster.pixels[i]), brightness(open.pixels[i]));
      darker += raster.pixels[i] != open.pixels[i];
    }
    const std::size_t inner = inner_pixels(raster).size();
    EXPECT_GT(darker, inner / 100);
    EXPECT_LT(darker, inner / 10);  // Of 64 cubes it is a corner of four.
  }
  EXPECT_LT(darkest(lit.draw(Shown::kOcclusion)), 3 * 40);
}

/// On the way from an open corner to an occluded one is every tone.
TEST(WorldPicture, InterpolatesHarmonics) {
  World world = empty_world({1, 1, 1});
  world.fill({0, 0, 0}, 1);
  const Lit lit(std::move(world),
                [&](Cube corner) { return corner.x == 0 ? Harmonics{} : half_open(); });
  const Raster raster = lit.draw(Shown::kOcclusion);
  std::array<int, 256> pixels{};
  for (const std::size_t i : inner_pixels(raster)) ++pixels[raster.pixels[i][0]];
  for (int tone = 20; tone <= 180; ++tone) EXPECT_GT(pixels[static_cast<std::size_t>(tone)], 0);
  EXPECT_EQ(std::count(pixels.begin() + 181, pixels.end(), 0), 256 - 181);
}

TEST(WorldPicture, LightsTheSideThatSeesTheSky) {
  const auto ambient_of = [](float cy) {
    World world = plain(4);
    const Lit lit(std::move(world), [&](Cube) { return Harmonics{half_open()[0], 0, cy, 0}; });
    const Raster raster = lit.draw(Shown::kAmbient);
    return brightness(raster.pixels[inner_pixels(raster)[1000]]);  // Of the top, at the far end.
  };
  EXPECT_GT(ambient_of(half_open()[2]), ambient_of(0.0f) + 20);
  EXPECT_GT(ambient_of(0.0f), ambient_of(-half_open()[2]) + 20);
}

TEST(WorldPicture, CastsShadowsOfTheSun) {
  World world = plain(8);
  for (int y = 1; y < 4; ++y) world.fill({4, y, 4}, 1);
  const Lit lit = half_open(std::move(world));
  const Raster raster = lit.draw(Shown::kLighting);
  const Raster ambient = lit.draw(Shown::kAmbient);
  // Of the same ambient light on the plain, some is alone and some is not.
  std::vector<Colour> of_same;
  const auto inner = inner_pixels(raster);
  const Colour far = ambient.pixels[inner[inner.size() / 2]];
  for (const std::size_t i : inner)
    if (ambient.pixels[i] == far) of_same.push_back(raster.pixels[i]);
  const auto [least, most] = std::minmax_element(
      of_same.begin(), of_same.end(),
      [](const Colour& a, const Colour& b) { return brightness(a) < brightness(b); });
  EXPECT_LT(brightness(*least) + 100, brightness(*most));
}

TEST(WorldPicture, OfCubesNeedsNoHarmonics) {
  const Lit dark(plain(4), [](Cube) { return Harmonics{}; });
  EXPECT_EQ(dark.draw(Shown::kCubes).pixels, half_open(plain(4)).draw(Shown::kCubes).pixels);
  EXPECT_NE(dark.draw(Shown::kFinal).pixels, half_open(plain(4)).draw(Shown::kFinal).pixels);
}

/// Cubes within the margin have no probes, and are left out; where it begins some corners have
/// none, either.
TEST(WorldPicture, LeavesOutTheMargin) {
  World filled = empty_world({6, 6, 6});
  for (int i = 0; i < 6 * 6 * 6; ++i) filled.fill({i % 6, i / 6 % 6, i / 36}, 1);
  filled.margin = 2;
  World cube = empty_world({2, 2, 2});
  for (int i = 0; i < 8; ++i) cube.fill({i & 1, i >> 1 & 1, i >> 2}, 1);
  const Lit margin = half_open(std::move(filled));
  EXPECT_EQ(margin.source.probe_count(), 0u);
  const auto size = [](const Lit& lit) { return inner_pixels(lit.draw(Shown::kFinal)).size(); };
  const auto shown = static_cast<double>(size(margin));
  EXPECT_NEAR(shown, static_cast<double>(size(half_open(std::move(cube)))), 0.01 * shown);
  const Raster raster = margin.draw(Shown::kOcclusion);
  for (const std::size_t i : inner_pixels(raster)) ASSERT_EQ(raster.pixels[i], kHalf);
}

TEST(WorldPicture, OfAWorldThatIsAllMarginShowsAll) {
  World world = plain(4);
  world.margin = 16;
  EXPECT_FALSE(inner_pixels(half_open(std::move(world)).draw(Shown::kFinal)).empty());
}

TEST(WorldPicture, IsTheSameEachTime) {
  const Lit lit(plain(6), [](Cube corner) {
    return Harmonics{0.3f * static_cast<float>(corner.x), 0.2f, 0.1f * static_cast<float>(corner.z),
                     0.0f};
  });
  EXPECT_EQ(lit.draw(Shown::kFinal).pixels, lit.draw(Shown::kFinal).pixels);
}

TEST(WorldPicture, NeedsTheHarmonicsOfThatWorld) {
  const Lit lit = half_open(plain(4));
  EXPECT_THROW(draw_world(plain(5), lit.field, Shown::kFinal), CheckError);
}

}  // namespace
}  // namespace lanescope
