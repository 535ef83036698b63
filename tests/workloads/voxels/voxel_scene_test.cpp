// SPDX-License-Identifier: MIT
#include "workloads/voxels/voxel_scene.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "simulator/base/error.h"
#include "workloads/voxels/brick.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

constexpr int kSizes[] = {16, 17, 48, 80};

struct Range {
  double low, high;
};

/// Filled cubes of a hundred.
Range share_of(const std::string& name) {
  const std::map<std::string, Range> shares = {
      {"hills", {20, 55}},       {"caves", {50, 80}},       {"town", {10, 45}},
      {"stones", {1, 6}},        {"scattered1", {0, 2}},    {"scattered5", {4, 6}},
      {"scattered20", {19, 21}}, {"scattered40", {39, 41}}, {"scattered60", {59, 61}}};
  const auto found = shares.find(name);
  return found == shares.end() ? Range{0, 100} : found->second;
}

double filled_percent(const World& world) {
  const Cube size = world.size();
  return 100.0 * static_cast<double>(world.filled_count()) /
         (static_cast<double>(size.x) * size.y * size.z);
}

template <class Visit>
void for_each_cube(const World& world, const Visit& visit) {
  for (int z = 0; z < world.size().z; ++z)
    for (int y = 0; y < world.size().y; ++y)
      for (int x = 0; x < world.size().x; ++x) visit(Cube{x, y, z});
}

bool same(const World& a, const World& b) {
  if (!(a.size() == b.size()) || a.palette != b.palette || a.margin != b.margin) return false;
  bool is_same = true;
  for_each_cube(a, [&](Cube c) { is_same &= a.colour_number(c) == b.colour_number(c); });
  return is_same;
}

void expect_good(const VoxelScene& scene, int size_cubes, std::uint64_t seed) {
  SCOPED_TRACE(std::string(scene.name) + ' ' + std::to_string(size_cubes));
  const World world = scene.build(size_cubes, seed);
  // Probes of scattered worlds see nothing of their outside.
  const int size = scene.name.starts_with("scattered") ? std::max(size_cubes, 40) : size_cubes;
  EXPECT_EQ(world.size().x, size);
  EXPECT_EQ(world.size().z, size);
  EXPECT_GE(world.size().y, 16);
  EXPECT_LE(world.size().y, size);
  const Range share = share_of(std::string(scene.name));
  // In a small world, chance makes more of a difference.
  const bool is_small = size_cubes < 48;
  EXPECT_GE(filled_percent(world), is_small ? 0.6 * share.low - 1.0 : share.low);
  EXPECT_LE(filled_percent(world), is_small ? share.high + 3.0 : share.high);
}

TEST(VoxelScenes, HaveNamesAndSummaries) {
  std::set<std::string_view> names;
  for (const VoxelScene* scene : voxel_scenes()) {
    EXPECT_TRUE(names.insert(scene->name).second) << scene->name;
    EXPECT_FALSE(scene->summary.empty()) << scene->name;
  }
  EXPECT_EQ(voxel_scenes().front()->name, "hills");
}

TEST(VoxelScenes, AreFilledAsTheySay) {
  for (const VoxelScene* scene : voxel_scenes())
    for (const int size : kSizes)
      for (const std::uint64_t seed : {1u, 2u, 3u}) expect_good(*scene, size, seed);
}

TEST(VoxelScenes, MayBeLarge) {
  for (const VoxelScene* scene : voxel_scenes()) expect_good(*scene, 256, ~std::uint64_t{0});
}

TEST(VoxelScenes, AreTheSameForTheSameSeed) {
  for (const VoxelScene* scene : voxel_scenes())
    for (const int size : {16, 48})
      EXPECT_TRUE(same(scene->build(size, 5), scene->build(size, 5))) << scene->name << size;
}

TEST(VoxelScenes, DifferBetweenSeeds) {
  for (const VoxelScene* scene : voxel_scenes())
    for (const int size : {16, 48})
      for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{1} << 63})
        EXPECT_FALSE(same(scene->build(size, 0), scene->build(size, seed))) << scene->name << size;
}

TEST(VoxelScenes, HaveProbes) {
  for (const VoxelScene* scene : voxel_scenes())
    for (const int size : kSizes) {
      const VoxelSource source(std::make_shared<const World>(scene->build(size, 1)));
      EXPECT_GT(source.probe_count(), 0u) << scene->name << size;
      EXPECT_TRUE(source.notes().empty()) << scene->name << size;
    }
}

/// Every cube has a colour that the palette says: entries that are not said are black.
TEST(VoxelScenes, HaveColours) {
  for (const VoxelScene* scene : voxel_scenes()) {
    const World world = scene->build(48, 1);
    std::set<World::Colour> colours;
    for_each_cube(world, [&](Cube c) {
      if (world.filled(c)) colours.insert(world.colour(c));
    });
    EXPECT_FALSE(colours.contains({})) << scene->name;
    EXPECT_GE(colours.size(), 10u) << scene->name;
  }
}

TEST(ScatteredScenes, KeepWhatIsOutsideOutOfSight) {
  const auto margin = [](int size) {
    return find_voxel_scene("scattered20").build(size, 1).margin;
  };
  EXPECT_EQ(margin(16), kReach);
  EXPECT_EQ(margin(48), 20);
  EXPECT_EQ(margin(100), 46);
}

TEST(ScatteredScenes, ContainThoseOfASmallerShare) {
  const World few = find_voxel_scene("scattered5").build(20, 4);
  const World many = find_voxel_scene("scattered40").build(20, 4);
  for_each_cube(few, [&](Cube c) { EXPECT_LE(few.filled(c), many.filled(c)); });
}

TEST(FindVoxelScene, FindsEveryWorld) {
  for (const VoxelScene* scene : voxel_scenes()) EXPECT_EQ(&find_voxel_scene(scene->name), scene);
}

TEST(FindVoxelScene, SuggestsTheNearestName) {
  try {
    find_voxel_scene("hils");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "--scene: no world is called 'hils'; did you mean 'hills'?");
  }
}

}  // namespace
}  // namespace lanescope
