// SPDX-License-Identifier: MIT
// Images and harmonics that are known beforehand: of empty and of full worlds, and of a single cube
// in each place.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernels/voxels/cube_images.h"
#include "tests/kernels/voxels/runs.h"

namespace lanescope {
namespace {

constexpr SkyProjection kBoth[] = {SkyProjection::kFaces, SkyProjection::kDirections};
const double kOpenSky = std::sqrt(4 * std::numbers::pi);

Brick empty_brick(std::uint64_t first_probe, std::vector<Probe> probes) {
  Brick brick;
  brick.clear();
  brick.first_probe = first_probe;
  brick.probes = std::move(probes);
  return brick;
}

template <class Test>
void fill_where(Brick& brick, const Test& test) {
  for (int z = 0; z < kBrickCubes; ++z)
    for (int y = 0; y < kBrickCubes; ++y)
      for (int x = 0; x < kBrickCubes; ++x)
        if (test(Cube{x, y, z})) brick.fill({x, y, z});
}

/// Expects these harmonics of each probe, from all programs and the reference.
void expect_harmonics(const Brick& brick, const std::array<double, kHarmonics>& wanted,
                      double tolerance) {
  for (const SkyProjection projection : kBoth) {
    std::vector<const Kernel*> all = test::voxel_programs();
    all.push_back(&find_kernel("voxel_rays"));
    for (const Kernel* kernel : all) {
      SCOPED_TRACE(fmt::format("{}, {}", kernel->name, name_of(kProjections, projection)));
      const auto rendered = test::render(*kernel, std::min(5, kernel->most_width), Mode::kCounting,
                                         projection, {brick});
      for (const Harmonics& harmonics : rendered.probes)
        for (std::size_t h = 0; h < kHarmonics; ++h)
          EXPECT_NEAR(harmonics[h], wanted[h], tolerance) << "harmonic " << h;
    }
  }
}

TEST(KnownImages, AnEmptyWorldIsAllSky) {
  const Brick brick = empty_brick(0, {{0, 0, 0}, {8, 3, 5}, {15, 15, 15}});
  expect_harmonics(brick, {kOpenSky, 0, 0, 0}, 1e-6);
  for (const Kernel* kernel : test::voxel_programs()) {
    const auto rendered = test::render(*kernel, 1, Mode::kCounting, SkyProjection::kFaces, {brick});
    EXPECT_EQ(rendered.counter(*kernel, "octants_rendered"), 24u);
    EXPECT_EQ(rendered.counter(*kernel, "samples_taken"), 24u * 768);
    EXPECT_EQ(rendered.counter(*kernel, "samples_occluded"), 0u);
    EXPECT_EQ(rendered.counter(*kernel, "cubes_merged"), 0u);
  }
}

TEST(KnownImages, AFullWorldHasNone) {
  Brick brick = empty_brick(0, {{0, 0, 0}, {15, 15, 15}, {4, 9, 1}});
  fill_where(brick, [](Cube) { return true; });
  expect_harmonics(brick, {0, 0, 0, 0}, 0);
  for (const Kernel* kernel : test::voxel_programs()) {
    const auto rendered =
        test::render(*kernel, 1, Mode::kCounting, SkyProjection::kDirections, {brick});
    EXPECT_EQ(rendered.counter(*kernel, "octants_blocked"), 24u);
    EXPECT_EQ(rendered.counter(*kernel, "octants_rendered"), 0u);
  }
}

/// The upper half of the sphere: half of harmonic 0, and sqrt(3 / 4 pi) pi of the one of y.
TEST(KnownImages, APlainSeesTheUpperHalf) {
  Brick brick = empty_brick(0, {{0, 8, 0}, {7, 8, 15}});
  fill_where(brick, [](Cube c) { return c.y < kReach + 8; });
  expect_harmonics(brick, {kOpenSky / 2, 0, std::sqrt(3 * std::numbers::pi) / 2, 0}, 1e-5);
}

/// A shell of cubes just within reach hides all; just beyond it hides nothing.
TEST(KnownImages, ReachIsSixteenCubes) {
  for (const int distance : {kReach - 1, kReach}) {
    Brick brick = empty_brick(0, {{8, 8, 8}});
    const auto away = [](int place) { return place >= 24 ? place - 24 : 23 - place; };
    fill_where(brick, [&](Cube c) {
      return std::max({away(c.x), away(c.y), away(c.z)}) == distance;
    });
    expect_harmonics(brick, {distance < kReach ? 0 : kOpenSky, 0, 0, 0}, 1e-6);
  }
}

/// A shell of megacubes hides all, but those that the reach of cubes holds are skipped.
TEST(KnownImages, MegacubesBeginWhereTheReachEnds) {
  for (const int distance : {kMegaSkipped - 1, kMegaSkipped, kReach - 1}) {
    Brick brick = empty_brick(0, {{8, 9, 10}});
    brick.clear(true);
    for (int i = 0; i < 8 * kOctantCubes; ++i) {
      const int away[] = {i % 16, i / 16 % 16, i / 256 % 16}, octant = i / kOctantCubes;
      if (std::max({away[0], away[1], away[2]}) != distance) continue;
      const auto at = [&](int corner, int axis) {
        return corner + kMegaCube * (octant >> axis & 1 ? -1 - away[axis] : away[axis]);
      };
      brick.fill_mega({at(8, 0), at(9, 1), at(10, 2)});
    }
    expect_harmonics(brick, {distance < kMegaSkipped ? kOpenSky : 0, 0, 0, 0}, 1e-6);
  }
}

/// One cube in each of the 4096 places of an octant, each octant in turn.
TEST(KnownImages, OneCubeInEachPlace) {
  std::vector<Brick> bricks;
  for (int place = 0; place < kOctantCubes; place += test::kTriedEvery) {
    const int octant = (place + place / 16 + place / 256) % kOctants;
    Brick brick = empty_brick(bricks.size(), {{8, 8, 8}});
    const auto at = [&](int axis, int away) { return octant >> axis & 1 ? 23 - away : 24 + away; };
    brick.fill({at(0, place % 16), at(1, place / 16 % 16), at(2, place / 256)});
    bricks.push_back(std::move(brick));
  }
  for (const SkyProjection projection : kBoth)
    test::expect_agreement(bricks, projection, {Mode::kCounting}, {1, 24, 64});
}

/// Found by the article's measure too: every cube covers a pixel, and 5.7 of them on average.
TEST(CubeImages, CoverWhatIsKnownOfThem) {
  const CubeImages& images = cube_images(SkyProjection::kFaces);
  std::uint64_t covered = 0;
  for (int cube = 0; cube < kOctantCubes; ++cube) {
    int bits = 0;
    for (const CubeImages::Part& part : images.parts_of(cube)) {
      EXPECT_EQ(part.bits,
                images.images[static_cast<std::size_t>(cube * images.words) + part.word]);
      bits += std::popcount(part.bits);
    }
    EXPECT_GE(bits, 1) << cube;
    covered += static_cast<std::uint64_t>(bits);
  }
  EXPECT_NEAR(static_cast<double>(covered) / kOctantCubes, 5.7, 0.05);
}

/// The cube at the camera covers everything; its neighbour along x what the ray's slope says:
/// pixels of the face towards x whose ray leaves the first cube through its far wall.
TEST(CubeImages, NearestCubesInClosedForm) {
  const CubeImages& images = cube_images(SkyProjection::kFaces);
  for (int w = 0; w < images.words; ++w) EXPECT_EQ(images.images[static_cast<std::size_t>(w)], ~0u);
  const auto next = std::span(images.images).subspan(24, 24);
  for (std::size_t w = 0; w < 8; ++w) EXPECT_EQ(next[w], ~0u) << "the face towards x";
}

TEST(OctantRows, AreAllRowsTheNearestFirst) {
  const auto& rows = octant_rows();
  ASSERT_EQ(rows.size(), 256u);
  std::array<bool, 256> seen{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_FALSE(std::exchange(seen[static_cast<std::size_t>(16 * rows[i].z + rows[i].y)], true));
    if (i == 0) continue;
    const auto squared = [](OctantRow r) { return r.y * r.y + r.z * r.z; };
    EXPECT_LE(squared(rows[i - 1]), squared(rows[i]));
  }
}

}  // namespace
}  // namespace lanescope
