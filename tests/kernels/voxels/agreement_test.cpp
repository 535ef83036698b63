// SPDX-License-Identifier: MIT
// Every program on every built-in world, at every width, in every mode, with either projection: the
// images of the reference, bit for bit. The matrix is made from the registries.
#include <gtest/gtest.h>

#include <map>

#include "tests/kernels/voxels/runs.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

const std::vector<int> kAllWidths(std::begin(test::kTriedWidths), std::end(test::kTriedWidths));

class VoxelAgreement : public testing::TestWithParam<std::tuple<const VoxelScene*, SkyProjection>> {
};

TEST_P(VoxelAgreement, WithTheReference) {
  const auto [scene, projection] = GetParam();
  // A world that is no multiple of a brick; some probes of each of its bricks.
  const World world = scene->build(37, 3);
  const auto many = test::bricks_of(world, 31 * test::kTriedEvery);
  const auto few = test::bricks_of(world, 331);
  test::expect_agreement(many, projection, {Mode::kCounting, Mode::kUncounted}, kAllWidths);
  test::expect_agreement(few, projection, {Mode::kChecked, Mode::kTracing}, {1, 7, 16, 33, 64});
}

/// With megacubes beyond the cubes.
TEST_P(VoxelAgreement, OfTwoLevels) {
  const auto [scene, projection] = GetParam();
  const auto bricks = test::bricks_of(scene->build(40, 4), 307, 2);
  test::expect_agreement(bricks, projection, {Mode::kCounting, Mode::kUncounted}, {1, 5, 24, 64});
  const std::vector<Brick> few(bricks.begin(), bricks.begin() + 1);
  test::expect_agreement(few, projection, {Mode::kChecked, Mode::kTracing}, {7, 64});
}

/// Bricks are independent: two executions that share them count what one does.
TEST_P(VoxelAgreement, OfSplitExecutions) {
  const auto [scene, projection] = GetParam();
  const auto bricks = test::bricks_of(scene->build(37, 3), 67);
  const auto half = bricks.begin() + static_cast<std::ptrdiff_t>(bricks.size() / 3);
  for (const Kernel* kernel : test::voxel_programs()) {
    SCOPED_TRACE(kernel->name);
    const int width = std::min(23, kernel->most_width);
    const auto run = [&](const std::vector<Brick>& some) {
      return test::render(*kernel, width, Mode::kCounting, projection, some).result;
    };
    const KernelResult whole = run(bricks);
    KernelResult sum = run({half, bricks.end()});
    if (half != bricks.begin()) merge(*kernel, sum, run({bricks.begin(), half}));
    EXPECT_EQ(sum.counts, whole.counts);
    EXPECT_EQ(sum.counters, whole.counters);
    EXPECT_EQ(sum.results_hash, whole.results_hash);
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, VoxelAgreement,
                         testing::Combine(testing::ValuesIn(voxel_scenes()),
                                          testing::Values(SkyProjection::kFaces,
                                                          SkyProjection::kDirections)),
                         [](const auto& info) {
                           return fmt::format("{}_{}", std::get<0>(info.param)->name,
                                              name_of(kProjections, std::get<1>(info.param)));
                         });

/// The slow modes charge each instruction as it is issued.
TEST(VoxelModes, CountTheSame) {
  const auto bricks = test::bricks_of(find_voxel_scene("scattered20").build(24, 5), 97);
  for (const SkyProjection projection : {SkyProjection::kFaces, SkyProjection::kDirections})
    for (const Kernel* kernel : test::voxel_programs())
      for (const int width : {1, 5, 8, 24, 33, 64}) {
        if (width > kernel->most_width) continue;
        SCOPED_TRACE(fmt::format("{}, W = {}", kernel->name, width));
        const auto run = [&](Mode mode) {
          return test::render(*kernel, width, mode, projection, bricks).result;
        };
        const KernelResult counting = run(Mode::kCounting);
        EXPECT_FALSE(counting.counts.stages.at(2).instructions.empty());
        EXPECT_EQ(run(Mode::kChecked).counts, counting.counts);
        EXPECT_EQ(run(Mode::kTracing).counts, counting.counts);
      }
}

}  // namespace
}  // namespace lanescope
