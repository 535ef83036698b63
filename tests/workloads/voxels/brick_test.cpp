// SPDX-License-Identifier: MIT
// Bricks, and the source that cuts a world into them, against arrays and loops that are plain.
#include "workloads/voxels/brick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "simulator/base/random.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

/// Filled at random, `percent` of a hundred.
World random_world(Cube size, std::uint64_t seed, std::uint64_t percent, int margin = 0) {
  World world(size);
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const auto place = static_cast<std::uint64_t>((z * size.y + y) * size.x + x);
        if (mix64(mix64(seed) ^ place) % 100 < percent) world.fill({x, y, z}, 1);
      }
  world.margin = margin;
  return world;
}

template <class Visit>
void for_each_cube_of_brick(const Visit& visit) {
  for (int z = 0; z < kBrickCubes; ++z)
    for (int y = 0; y < kBrickCubes; ++y)
      for (int x = 0; x < kBrickCubes; ++x) visit(Cube{x, y, z});
}

Brick brick_of(const World& world) {
  Brick brick;
  brick.clear();
  for_each_cube_of_brick([&](Cube c) {
    if (world.filled(c)) brick.fill(c);
  });
  return brick;
}

TEST(Brick, HasTheCubesThatWereFilled) {
  const World world = random_world({kBrickCubes, kBrickCubes, kBrickCubes}, 1, 30);
  const Brick brick = brick_of(world);
  for_each_cube_of_brick([&](Cube c) { ASSERT_EQ(brick.filled(c), world.filled(c)); });
}

TEST(Brick, HasRowsOfBothWays) {
  const World world = random_world({kBrickCubes, kBrickCubes, kBrickCubes}, 2, 50);
  const Brick brick = brick_of(world);
  std::vector<std::uint32_t> expected;
  for (int z = 0; z < kBrickCubes; ++z)
    for (int y = 0; y < kBrickCubes; ++y) {
      std::uint32_t forward = 0, backward = 0;
      for (int bit = 0; bit < 32; ++bit) {
        forward |= std::uint32_t{world.filled({16 + bit, y, z})} << bit;
        backward |= std::uint32_t{world.filled({31 - bit, y, z})} << bit;
      }
      ASSERT_EQ(std::size_t(Brick::row(y, z)), expected.size());
      expected.insert(expected.end(), {forward, backward});
    }
  EXPECT_EQ(brick.rows, expected);
}

/// What the two words of a row are for.
TEST(Brick, HasWhatAProbeSeesFromOneBitOn) {
  const World world = random_world({kBrickCubes, 1, 1}, 3, 50);
  const Brick brick = brick_of(world);
  for (int x = 0; x < kBrickCorners; ++x)
    for (int away = 0; away < kReach; ++away) {
      const int corner = kReach + x;
      EXPECT_EQ((brick.rows[Brick::kForward] >> (x + away) & 1) != 0,
                world.filled({corner + away, 0, 0}));
      EXPECT_EQ((brick.rows[Brick::kBackward] >> (16 - x + away) & 1) != 0,
                world.filled({corner - 1 - away, 0, 0}));
    }
}

TEST(Brick, IsEmptyAfterClear) {
  Brick brick = brick_of(random_world({kBrickCubes, kBrickCubes, kBrickCubes}, 4, 10));
  brick.clear();
  EXPECT_EQ(brick.rows, std::vector<std::uint32_t>(Brick::kWords));
}

TEST(Brick, HasAHashOfAllThatItHolds) {
  Brick brick = brick_of(random_world({40, 40, 40}, 5, 10));
  brick.probes = {{1, 2, 3}};
  const std::uint64_t hash = brick.hash();
  EXPECT_EQ(brick.element_count(), 1u);
  for (const auto& change : std::vector<void (*)(Brick&)>{
           [](Brick& b) { ++b.origin.x; }, [](Brick& b) { ++b.origin.y; },
           [](Brick& b) { ++b.origin.z; }, [](Brick& b) { ++b.first_probe; },
           [](Brick& b) {
             b.fill({47, 47, 47});
           },
           [](Brick& b) { b.probes[0].x = 0; }, [](Brick& b) { b.probes[0].z = 0; },
           [](Brick& b) { b.probes.clear(); }}) {
    Brick changed = brick;
    change(changed);
    EXPECT_NE(changed.hash(), hash);
  }
}

// The source

using CornerCounts = std::map<std::tuple<int, int, int>, int>;

/// The corners that some filled and some empty cube meet at, by looking at all.
CornerCounts surface_corners(const World& world) {
  CornerCounts corners;
  const Cube size = world.size();
  const int margin = world.margin;
  for (int z = margin; z <= size.z - margin; ++z)
    for (int y = margin; y <= size.y - margin; ++y)
      for (int x = margin; x <= size.x - margin; ++x) {
        int filled = 0;
        for (const int dz : {-1, 0})
          for (const int dy : {-1, 0})
            for (const int dx : {-1, 0}) filled += world.filled({x + dx, y + dy, z + dz});
        if (filled % 8 != 0) corners[{x, y, z}] = 1;
      }
  return corners;
}

struct WorldCase {
  Cube size;
  std::uint64_t percent;
  int margin;
};

std::shared_ptr<const World> world_of(const WorldCase& c) {
  return std::make_shared<const World>(random_world(c.size, 9, c.percent, c.margin));
}

constexpr WorldCase kWorlds[] = {
    {{1, 1, 1}, 100, 0},   {{16, 16, 16}, 20, 0}, {{15, 31, 33}, 3, 0},    {{48, 48, 48}, 40, 16},
    {{20, 40, 24}, 60, 5}, {{33, 16, 50}, 99, 2}, {{100, 17, 16}, 100, 0},
};

class VoxelSources : public ::testing::TestWithParam<WorldCase> {};
INSTANTIATE_TEST_SUITE_P(Worlds, VoxelSources, ::testing::ValuesIn(kWorlds));

TEST_P(VoxelSources, HaveEverySurfaceCornerOnce) {
  const auto world = world_of(GetParam());
  const VoxelSource source(world);
  CornerCounts found;
  for (int segment = 0; segment < source.segment_count(); ++segment)
    source.produce(segment, [&](const Work& work) {
      const auto& brick = static_cast<const Brick&>(work);
      EXPECT_FALSE(brick.probes.empty());
      for (const Probe& p : brick.probes) {
        EXPECT_LT(std::max({p.x, p.y, p.z}), kBrickCorners);
        ++found[{brick.origin.x + p.x, brick.origin.y + p.y, brick.origin.z + p.z}];
      }
    });
  EXPECT_EQ(found, surface_corners(*world));
  EXPECT_EQ(source.probe_count(), found.size());
}

TEST_P(VoxelSources, HaveTheCubesAroundEachBrick) {
  const auto world = world_of(GetParam());
  WorldOptions options;
  options.piece_probes = 7;
  const VoxelSource source(world, options);
  for (int segment = 0; segment < source.segment_count(); ++segment) {
    std::uint64_t pieces = 0, seen = 0, filled = 0;
    const auto counters = source.produce(segment, [&](const Work& work) {
      const auto& brick = static_cast<const Brick&>(work);
      EXPECT_EQ(brick.segment, static_cast<std::uint64_t>(segment));
      EXPECT_EQ(brick.ordinal, pieces++);
      EXPECT_GE(brick.probes.size(), 1u);
      EXPECT_LE(brick.probes.size(), 7u);
      EXPECT_FALSE(brick.has_megacubes());
      seen = filled = 0;
      for_each_cube_of_brick([&](Cube c) {
        const Cube there{brick.origin.x - kReach + c.x, brick.origin.y - kReach + c.y,
                         brick.origin.z - kReach + c.z};
        ASSERT_EQ(brick.filled(c), world->filled(there));
        seen += world->contains(there);
        filled += brick.filled(c);
      });
    });
    EXPECT_EQ(counters, (std::vector<std::uint64_t>{1, seen, filled}));
    EXPECT_EQ(counters.size(), kWorldCounters.size());
  }
}

/// By the definition: the cubes of each are counted.
TEST(Megacubes, AreOpaqueWhereEnoughOfThemIsFilled) {
  const World world = random_world({9, 7, 11}, 3, 55);
  for (const float share : {0.0f, 0.25f, 0.5f, 1.0f}) {
    const Megacubes megacubes(world, share);
    for (int z = -6; z < 13; ++z)
      for (int y = -6; y < 9; ++y)
        for (int x = -6; x < 11; ++x) {
          int filled = 0;
          for (int i = 0; i < 64; ++i)
            filled += world.filled({x + i % 4, y + i / 4 % 4, z + i / 16});
          ASSERT_EQ(megacubes.opaque({x, y, z}),
                    filled >= 1 && static_cast<float>(filled) >= 64 * share);
        }
  }
}

TEST(Megacubes, AreInTheRowsOfABrick) {
  const auto world = std::make_shared<const World>(random_world({70, 40, 55}, 4, 52));
  WorldOptions options;
  options.levels = 2;
  const Megacubes megacubes(*world, kMegaFill);
  const VoxelSource source(world, options);
  source.produce(source.segment_count() / 2, [&](const Work& work) {
    const auto& brick = static_cast<const Brick&>(work);
    ASSERT_TRUE(brick.has_megacubes());
    if (brick.ordinal > 0) return;
    for (int z = -64; z < 76; ++z)
      for (int y = -64; y < 76; ++y)
        for (int x = -64; x < 76; ++x)
          ASSERT_EQ(brick.mega_filled({x, y, z}),
                    megacubes.opaque({brick.origin.x + x, brick.origin.y + y, brick.origin.z + z}));
  });
}

/// Both words of a row have each megacube that a probe may see along it.
TEST(Megacubes, AreAtTheBitsThatAreSaid) {
  Brick brick;
  for (int x = -64; x < 76; ++x) {
    brick.clear(true);
    brick.fill_mega({x, 5, -9});
    EXPECT_TRUE(brick.mega_filled({x, 5, -9}));
    for (int probe = 0; probe < kBrickCorners; ++probe) {
      const int place = probe % 4, a = probe / 4;
      const auto row = static_cast<std::size_t>(Brick::mega_row(place, 5, -9));
      for (int i = 0; i < kReach; ++i) {
        EXPECT_EQ(brick.rows[row + Brick::kForward] >> (a + i) & 1, x == probe + 4 * i);
        EXPECT_EQ(brick.rows[row + Brick::kBackward] >> (3 - a + i) & 1, x == probe - 4 * (i + 1));
      }
    }
  }
}

TEST_P(VoxelSources, NumberProbesAsForEachProbeDoes) {
  const VoxelSource source(world_of(GetParam()));
  std::map<std::uint64_t, std::array<int, 3>> produced, visited;
  for (int segment = 0; segment < source.segment_count(); ++segment)
    source.produce(segment, [&](const Work& work) {
      const auto& brick = static_cast<const Brick&>(work);
      for (std::uint64_t i = 0; i < brick.probes.size(); ++i) {
        const Probe p = brick.probes[i];
        produced[brick.first_probe + i] = {brick.origin.x + p.x, brick.origin.y + p.y,
                                           brick.origin.z + p.z};
      }
    });
  source.for_each_probe([&](Cube corner, std::uint64_t number) {
    EXPECT_TRUE(visited.emplace(number, std::array{corner.x, corner.y, corner.z}).second);
  });
  EXPECT_EQ(produced, visited);
  ASSERT_EQ(produced.size(), source.probe_count());
  EXPECT_EQ(produced.begin()->first, 0u);
  EXPECT_EQ(produced.rbegin()->first, source.probe_count() - 1);
}

TEST_P(VoxelSources, GiveTheSameInAnyOrderOfSegments) {
  const auto world = world_of(GetParam());
  const auto hash = [](const VoxelSource& source, int first, int step) {
    std::uint64_t sum = 0;
    for (int i = 0, segment = first; i < source.segment_count(); ++i, segment += step)
      source.produce(segment, [&](const Work& work) { sum += work.hash(); });
    return sum;
  };
  const VoxelSource source(world), again(world);
  const int last = source.segment_count() - 1;
  EXPECT_EQ(hash(source, 0, 1), hash(source, last, -1));
  EXPECT_EQ(hash(source, 0, 1), hash(again, 0, 1));
}

TEST(VoxelSource, SaysThatAWorldHasNoProbe) {
  const auto empty = std::make_shared<const World>(Cube{8, 8, 8});
  const VoxelSource source(empty);
  EXPECT_EQ(source.segment_count(), 0);
  EXPECT_EQ(source.probe_count(), 0u);
  EXPECT_EQ(source.notes().size(), 1u);
}

TEST(VoxelSource, MayHaveAMarginThatLeavesNothing) {
  const VoxelSource source(world_of({{8, 8, 8}, 50, 5}));
  EXPECT_EQ(source.probe_count(), 0u);
}

}  // namespace
}  // namespace lanescope
