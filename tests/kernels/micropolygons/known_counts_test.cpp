// SPDX-License-Identifier: MIT
// Kernels on micropolygons so simple that their counts follow from arithmetic.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernels/micropolygons/runs.h"

namespace lanescope {
namespace {

using test::Outcome;

bool has_width(const Kernel& kernel, int width) { return width <= kernel.most_width; }

const StageCounts& stage(const Kernel& kernel, const Outcome& outcome, std::string_view name) {
  const auto place = std::ranges::find(kernel.stages, name);
  return outcome.result.counts.stages[static_cast<std::size_t>(place - kernel.stages.begin())];
}

/// Active lanes per instruction, as (active, issued * W) divided by the instructions of one block.
void expect_busy(const Kernel& kernel, const Outcome& outcome, std::string_view name,
                 std::uint64_t busy, std::uint64_t slots) {
  const InstructionCounts total = stage(kernel, outcome, name).total();
  const auto width = static_cast<std::uint64_t>(outcome.result.counts.width);
  EXPECT_EQ(total.active * slots, total.issued * width * busy)
      << kernel.name << ", " << name << ": " << total.active << " / " << total.issued * width;
}

/// 25 unit squares, each with one sample at its centre, all hit; cell boundaries belong to the
/// next cell, so each box holds 2 x 2 cells.
constexpr int kCandidates = 4;

TEST(KnownCounts, TwentyFiveQuadsOnSixteenLanes) {
  const Kernel& lockstep = find_kernel("lockstep");
  const SampleGrid grid(64, 64, 1, false, 0);
  const Packet packet = test::squares(5, 5, 1.0f);
  const Outcome o = test::run(lockstep, 16, Mode::kCounting, {}, grid, {&packet});
  EXPECT_EQ(o.counter(lockstep, "tests"), 25u * kCandidates);
  EXPECT_EQ(o.counter(lockstep, "hits"), 25u);
  expect_busy(lockstep, o, "Setup", 25, 32);
  expect_busy(lockstep, o, "Bound", 25, 32);
  expect_busy(lockstep, o, "Test", 25, 32);
  // Each square is hit by its first candidate, all in the same iteration.
  expect_busy(lockstep, o, "Process", 25, 32);
  EXPECT_EQ(o.counter(lockstep, "process_issued"), 2u);
}

TEST(KnownCounts, LockstepWaitsForTheLargestBox) {
  const Kernel& lockstep = find_kernel("lockstep");
  const SampleGrid grid(64, 64, 1, false, 0);
  // Boxes of 4, 1 and 16 cells: 16 iterations, 21 tests.
  const Packet packet = test::packet_of(Micropolygon::kQuad,
                                        {{{0.2f, 0.2f}, {1.8f, 0.2f}, {1.8f, 1.8f}, {0.2f, 1.8f}},
                                         {{8.2f, 8.2f}, {8.8f, 8.2f}, {8.8f, 8.8f}, {8.2f, 8.8f}},
                                         {{4.2f, 4.2f}, {7.8f, 4.2f}, {7.8f, 7.8f}, {4.2f, 7.8f}}});
  const Outcome o = test::run(lockstep, 8, Mode::kCounting, {}, grid, {&packet});
  EXPECT_EQ(o.counter(lockstep, "tests"), 21u);
  EXPECT_EQ(o.counter(lockstep, "hits"), 21u);
  const auto& test_stage = stage(lockstep, o, "Test");
  const auto per_iteration = test_stage.total().issued / 16;
  EXPECT_EQ(test_stage.total().issued, 16 * per_iteration);
  EXPECT_EQ(test_stage.total().active, 21 * per_iteration);
  EXPECT_EQ(test_stage.lane_active[0], 4 * per_iteration);
  EXPECT_EQ(test_stage.lane_active[1], 1 * per_iteration);
  EXPECT_EQ(test_stage.lane_active[2], 16 * per_iteration);
  EXPECT_EQ(test_stage.lane_active[3], 0u);
  EXPECT_EQ(test_stage.histogram[3], 1 * per_iteration);
  EXPECT_EQ(test_stage.histogram[2], 3 * per_iteration);
  EXPECT_EQ(test_stage.histogram[1], 12 * per_iteration);
}

TEST(KnownCounts, RepackKeepsItsLanesBusyWithTheSameBoxes) {
  const Kernel& repack = find_kernel("repack");
  const SampleGrid grid(64, 64, 1, false, 0);
  // 16 boxes of 16 cells and 48 of 1: with stream loading all 8 lanes test in every iteration.
  std::vector<std::vector<std::pair<float, float>>> polygons;
  for (int i = 0; i < 64; ++i) {
    const float side = i % 4 == 0 ? 3.6f : 0.6f;
    const float x = static_cast<float>(i % 8) * 6 + 0.2f, y = static_cast<float>(i / 8) * 6 + 0.2f;
    polygons.push_back({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
  }
  const Packet packet = test::packet_of(Micropolygon::kQuad, polygons);
  const Outcome o = test::run(repack, 8, Mode::kCounting, {}, grid, {&packet});
  EXPECT_EQ(o.counter(repack, "tests"), 16u * 16 + 48);
  EXPECT_EQ(o.counter(repack, "hits"), 16u * 16 + 48);
  // 304 hits are 38 full vectors.
  EXPECT_EQ(o.counter(repack, "process_issued"), 38u);
  expect_busy(repack, o, "Process", 1, 1);
  EXPECT_LE(o.counter(repack, "working_set_maximum"), 4u * 8);
}

TEST(KnownCounts, WhollyCulledBatchesStopAfterSetup) {
  const SampleGrid grid(64, 64, 1, false, 0);
  const Packet packet =
      test::packet_of(Micropolygon::kTriangle, std::vector<std::vector<std::pair<float, float>>>(
                                                   8, {{1.0f, 1.0f}, {1.0f, 5.0f}, {5.0f, 1.0f}}));
  for (const Kernel* kernel : test::rasterizers()) {
    if (kernel->stages.empty()) continue;
    const Outcome o = test::run(*kernel, 8, Mode::kCounting, {}, grid, {&packet});
    EXPECT_EQ(o.counter(*kernel, "micropolygons_culled"), 8u);
    EXPECT_GT(stage(*kernel, o, "Setup").total().issued, 0u);
    for (const std::string_view name : kernel->stages)
      if (name != "Setup") {
        EXPECT_EQ(stage(*kernel, o, name).total().issued, 0u) << name;
      }
  }
}

TEST(KnownCounts, ConflictsAreCounted) {
  const Kernel& lockstep = find_kernel("lockstep");
  const SampleGrid grid(64, 64, 1, false, 0);
  // Four equal squares over one sample: lanes 1 to 3 conflict with lane 0.
  const Packet packet = test::packet_of(
      Micropolygon::kQuad, std::vector<std::vector<std::pair<float, float>>>(
                               4, {{3.2f, 3.2f}, {3.8f, 3.2f}, {3.8f, 3.8f}, {3.2f, 3.8f}}));
  const Outcome o = test::run(lockstep, 8, Mode::kCounting, {}, grid, {&packet});
  EXPECT_EQ(o.counter(lockstep, "process_issued"), 1u);
  EXPECT_EQ(o.counter(lockstep, "conflict_invocations"), 1u);
  EXPECT_EQ(o.counter(lockstep, "conflict_hits"), 3u);
}

/// Instructions of one invocation of each stage: docs/thesis.md explains every one of them.
struct Invocations {
  std::uint64_t setup, bound, stream_load, test, compaction, process;
};

/// One micropolygon over 2 x 2 cells, with one hit in its first cell: one invocation of Setup and
/// Bound, four of Test, one of Process.
void expect_invocations(std::string_view name, Micropolygon shape, const Invocations& expected) {
  const Kernel& kernel = find_kernel(name);
  const SampleGrid grid(8, 8, 1, false, 0);
  std::vector<std::pair<float, float>> corners = {{0.25f, 0.25f}, {1.25f, 0.25f}};
  if (shape == Micropolygon::kQuad) corners.push_back({1.25f, 1.25f});
  corners.push_back({0.25f, 1.25f});
  KernelOptions options;
  const Packet packet = test::packet_of(shape, {corners});
  const Outcome o = test::run(kernel, 8, Mode::kCounting, options, grid, {&packet});
  ASSERT_EQ(o.counter(kernel, "tests"), 4u);
  ASSERT_EQ(o.counter(kernel, "hits"), 1u);
  const auto issued = [&](std::string_view stage_name) {
    return stage(kernel, o, stage_name).total().issued;
  };
  EXPECT_EQ(issued("Setup"), expected.setup);
  EXPECT_EQ(issued("Bound"), expected.bound);
  EXPECT_EQ(issued("Test"), 4 * expected.test + expected.compaction);
  EXPECT_EQ(issued("Process"), expected.process);
  if (name == "repack") {
    EXPECT_EQ(issued("Test Stream-load"), expected.stream_load);
  }
}

TEST(KnownCounts, InstructionsOfOneInvocation) {
  using enum Micropolygon;
  expect_invocations("lockstep", kTriangle, {15, 48, 0, 33, 0, 19});
  expect_invocations("lockstep", kQuad, {17, 56, 0, 39, 0, 30});
  expect_invocations("repack", kTriangle, {15, 42, 8, 40, 4, 66});
  expect_invocations("repack", kQuad, {17, 44, 8, 48, 4, 88});
}

/// A grid of quads, and the same vertices as triangles.
std::pair<Packet, Packet> sheet(int columns, int rows) {
  std::vector<std::vector<std::pair<float, float>>> quads, triangles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float x = static_cast<float>(column), y = static_cast<float>(row);
      const std::pair<float, float> a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
      const bool back = (row + column / 7) % 5 == 0;
      if (back)
        quads.push_back({a, d, c, b});
      else
        quads.push_back({a, b, c, d});
      const auto& q = quads.back();
      triangles.push_back({q[0], q[1], q[2]});
      triangles.push_back({q[0], q[2], q[3]});
    }
  }
  return {test::packet_of(Micropolygon::kQuad, quads),
          test::packet_of(Micropolygon::kTriangle, triangles)};
}

/// The thesis's tables obey it: W quads are the same batch as 2 W triangles.
TEST(KnownCounts, QuadBoundAtWEqualsTriangleBoundAtTwoW) {
  const SampleGrid grid(64, 64, 4, true, 1);
  const auto [quad_packet, triangle_packet] = sheet(30, 20);
  for (const Kernel* kernel : {&find_kernel("lockstep"), &find_kernel("repack")}) {
    for (const int width : test::tried_widths(*kernel)) {
      if (!has_width(*kernel, 2 * width)) continue;
      const auto q = test::run(*kernel, width, Mode::kCounting, {}, grid, {&quad_packet});
      const auto t = test::run(*kernel, 2 * width, Mode::kCounting, {}, grid, {&triangle_packet});
      const auto quad_bound = stage(*kernel, q, "Bound").total();
      const auto triangle_bound = stage(*kernel, t, "Bound").total();
      const auto w = static_cast<std::uint64_t>(width);
      EXPECT_EQ(quad_bound.active * triangle_bound.issued * 2 * w,
                triangle_bound.active * quad_bound.issued * w)
          << kernel->name << ", W = " << width;
    }
  }
}

}  // namespace
}  // namespace lanescope
