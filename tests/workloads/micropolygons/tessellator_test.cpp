// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/tessellator.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>

#include "simulator/base/error.h"
#include "simulator/base/random.h"
#include "tests/workloads/micropolygons/tessellation.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

using test::Polygon;
using test::small_options;
using test::Tessellation;

class EveryScene : public ::testing::TestWithParam<const SurfaceScene*> {
 protected:
  Scene scene() const { return GetParam()->build(GetParam()->default_frame); }
};

std::string name_of(const ::testing::TestParamInfo<const SurfaceScene*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, ::testing::ValuesIn(surface_scenes()), name_of);

std::uint64_t hash_of(const Packet& packet) {
  std::uint64_t hash = mix64(packet.first_id) + static_cast<std::uint64_t>(packet.size());
  for (int corner = 0; corner < corner_count(packet.shape()); ++corner)
    for (int a = 0; a < kAttributeCount; ++a)
      for (int i = 0; i < packet.padded_capacity(); ++i)
        hash = mix64(hash ^ std::bit_cast<std::uint32_t>(
                                packet.values(corner, static_cast<Attribute>(a))[i]));
  return hash;
}

std::uint64_t hash_of(const Tessellator& tessellator, int segment) {
  std::uint64_t hash = 0;
  tessellator.tessellate(segment,
                         [&](const Packet& packet) { hash = mix64(hash ^ hash_of(packet)); });
  return hash;
}

TEST_P(EveryScene, GivesTheSamePacketsInAnyOrderOfSegments) {
  const Scene first = scene(), second = scene();
  const TessellationOptions options = small_options(Micropolygon::kTriangle);
  const Tessellator forward(first, options), backward(second, options);
  const int count = forward.segment_count();
  ASSERT_EQ(count, backward.segment_count());
  std::vector<std::uint64_t> hashes(static_cast<std::size_t>(count));
  for (int s = count - 1; s >= 0; --s) hashes[static_cast<std::size_t>(s)] = hash_of(backward, s);
  for (int s = 0; s < count; ++s)
    EXPECT_EQ(hash_of(forward, s), hashes[static_cast<std::size_t>(s)]) << "segment " << s;
}

TEST_P(EveryScene, HasTheSameVerticesForTrianglesAndQuads) {
  const Scene s = scene();
  const Tessellation triangles = test::tessellate(s, small_options(Micropolygon::kTriangle));
  const Tessellation quads = test::tessellate(s, small_options(Micropolygon::kQuad));
  ASSERT_EQ(triangles.polygons.size(), 2 * quads.polygons.size());
  constexpr int kCorners[2][3] = {{0, 1, 2}, {0, 2, 3}};
  for (std::size_t i = 0; i < triangles.polygons.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      ASSERT_EQ(triangles.polygons[i].vertex[corner].attributes,
                quads.polygons[i / 2].vertex[kCorners[i % 2][corner]].attributes);
}

TEST_P(EveryScene, SnapsVerticesAndKeepsColoursInRange) {
  const Scene s = scene();
  for (const Polygon& p : test::tessellate(s, small_options(Micropolygon::kQuad)).polygons)
    for (const Vertex& v : p.vertex) {
      for (const Attribute a : {Attribute::kX, Attribute::kY})
        ASSERT_EQ(v[a], std::nearbyint(v[a] / kSubpixel) * kSubpixel);
      ASSERT_GE(v[Attribute::kZ], 0.0f);
      ASSERT_LT(v[Attribute::kZ], 1.0f);
      for (const Attribute a : {Attribute::kRed, Attribute::kGreen, Attribute::kBlue}) {
        ASSERT_GE(v[a], 0.0f);
        ASSERT_LE(v[a], 1.0f);
      }
      ASSERT_EQ(v[Attribute::kAlpha], 1.0f);
    }
}

TEST_P(EveryScene, HasHalfItsFacesAwayAndTrianglesOfHalfAPixel) {
  const Scene s = scene();
  TessellationOptions options = small_options(Micropolygon::kTriangle);
  options.width_px *= 2;
  options.height_px *= 2;
  double front = 0.0, area_cells = 0.0;
  const Tessellation all = test::tessellate(s, options);
  for (const Polygon& p : all.polygons)
    if (p.area() > 0.0) {
      front += 1.0;
      area_cells += p.area();
    }
  EXPECT_NEAR(front / static_cast<double>(all.polygons.size()), 0.5, 0.03);
  EXPECT_NEAR(area_cells / 4.0 / front, 0.43, 0.03);
  EXPECT_EQ(all.counts.dropped, 0u);
}

TEST_P(EveryScene, FillsPacketsButTheLastOfASegment) {
  const Scene s = scene();
  TessellationOptions options = small_options(Micropolygon::kTriangle);
  options.packet_capacity = 250;
  const Tessellator tessellator(s, options);
  for (int segment = 0; segment < tessellator.segment_count(); ++segment) {
    std::uint64_t next_id = static_cast<std::uint64_t>(segment) << 32;
    bool was_full = true;
    const TessellationCounts counts = tessellator.tessellate(segment, [&](const Packet& packet) {
      EXPECT_TRUE(was_full);
      EXPECT_GT(packet.size(), 0);
      EXPECT_EQ(packet.first_id, next_id);
      next_id += static_cast<std::uint64_t>(packet.size());
      was_full = packet.full();
    });
    EXPECT_EQ(counts.micropolygons, next_id - (static_cast<std::uint64_t>(segment) << 32));
  }
}

TEST_P(EveryScene, CountsDoNotDependOnPacketCapacity) {
  const Scene s = scene();
  TessellationOptions options = small_options(Micropolygon::kQuad);
  const TessellationCounts a = test::tessellate(s, options).counts;
  options.packet_capacity = 64;
  const TessellationCounts b = test::tessellate(s, options).counts;
  EXPECT_EQ(a.micropolygons, b.micropolygons);
  EXPECT_EQ(a.grids, b.grids);
  EXPECT_GT(a.patches_culled, 0u);
}

TEST_P(EveryScene, SmallerGridLimitsNeedMoreGrids) {
  const Scene s = scene();
  TessellationOptions options = small_options(Micropolygon::kQuad);
  std::uint64_t fewer = ~std::uint64_t{0};
  for (const int limit : {4, 8, 16}) {
    options.grid_limit = limit;
    const TessellationCounts counts = test::tessellate(s, options).counts;
    EXPECT_LE(counts.micropolygons, counts.grids * static_cast<std::uint64_t>(limit * limit));
    EXPECT_LT(counts.grids, fewer);
    fewer = counts.grids;
  }
}

TEST_P(EveryScene, QuadsGrowWithTheDiceArea) {
  const Scene s = scene();
  TessellationOptions options = small_options(Micropolygon::kQuad);
  options.dice_area_px = 4.0f;
  const auto coarse = static_cast<double>(test::tessellate(s, options).counts.micropolygons);
  options.dice_area_px = 1.0f;
  const auto fine = static_cast<double>(test::tessellate(s, options).counts.micropolygons);
  EXPECT_NEAR(fine / coarse, 4.0, 0.8);
}

TEST(Tessellator, VerticesScaleWithTheCellsOfAPixel) {
  const Scene scene = surface_scenes().front()->build(0);
  TessellationOptions options = small_options(Micropolygon::kQuad);
  const Tessellation two = test::tessellate(scene, options);
  options.samples_per_pixel = 16;
  const Tessellation four = test::tessellate(scene, options);
  ASSERT_EQ(two.polygons.size(), four.polygons.size());
  for (std::size_t i = 0; i < two.polygons.size(); ++i)
    ASSERT_NEAR(2.0f * two.polygons[i].x(0), four.polygons[i].x(0), 2.0f * kSubpixel);
}

TEST(Tessellator, ReportsOptionsOutOfRange) {
  const Scene scene;
  const auto message = [&](auto change) {
    TessellationOptions options;
    change(options);
    try {
      Tessellator{scene, options};
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  using O = TessellationOptions;
  EXPECT_EQ(message([](O& o) { o.width_px = 0; }),
            "--resolution: 0 is not an integer from 1 to 16384");
  EXPECT_EQ(message([](O& o) { o.height_px = 20000; }),
            "--resolution: 20000 is not an integer from 1 to 16384");
  EXPECT_EQ(message([](O& o) { o.dice_area_px = NAN; }),
            "--dice-area: nan is not a number from 0.01 to 10000");
  EXPECT_EQ(message([](O& o) { o.grid_limit = 129; }),
            "--grid: 129 is not an integer from 1 to 128");
  EXPECT_EQ(message([](O& o) { o.packet_capacity = 0; }),
            "--drain: 0 is not an integer from 1 to 1048576");
  EXPECT_EQ(message([](O&) {}), "no error");
}

TEST(Tessellator, AnEmptySceneHasNoSegments) {
  const Scene scene;
  EXPECT_EQ(Tessellator(scene, {}).segment_count(), 0);
}

}  // namespace
}  // namespace lanescope
