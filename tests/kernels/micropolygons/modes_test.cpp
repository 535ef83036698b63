// SPDX-License-Identifier: MIT
// The fast modes against the slow ones, which charge each instruction as it is issued: whatever the
// width and the options, all count the same, to the last lane.
#include <gtest/gtest.h>

#include "simulator/base/random.h"
#include "tests/kernels/micropolygons/runs.h"

namespace lanescope {
namespace {

using test::Outcome;

/// Micropolygons of many sizes and either orientation, some of them off the frame.
Packet assorted(Micropolygon shape, int count, std::uint64_t seed) {
  Packet packet(shape, count);
  for (int n = 0; n < count; ++n) {
    auto random = [&, salt = std::uint64_t{0}]() mutable {
      return unit_float(mix64(seed * 7919 + static_cast<std::uint64_t>(n) * 64 + ++salt));
    };
    const float x = 34 * random() - 1, y = 26 * random() - 1, size = 0.2f + 3.5f * random();
    const float turn = random() < 0.2f ? -1.0f : 1.0f;
    const float dx[] = {0, size, size, 0}, dy[] = {0, 0, size, size};
    Vertex corners[4];
    for (int k = 0; k < corner_count(shape); ++k)
      corners[k] = {{x + dx[k] + 0.1f * random(), y + turn * dy[k] + 0.1f * random(),
                     1.0f + random(), random(), random(), random(), 1.0f}};
    packet.append(corners);
  }
  return packet;
}

void expect_modes_agree(Micropolygon shape, const KernelOptions& options) {
  const SampleGrid grid(32, 24, 1, true, 3);
  const Packet first = assorted(shape, 150, 1), second = assorted(shape, 61, 2);
  for (const Kernel* kernel : test::rasterizers()) {
    for (const int width : test::tried_widths(*kernel)) {
      SCOPED_TRACE(fmt::format("{}, W = {}", kernel->name, width));
      const auto run = [&](Mode mode) {
        return test::run(*kernel, width, mode, options, grid, {&first, &second});
      };
      const Outcome counting = run(Mode::kCounting);
      EXPECT_GT(counting.counter(*kernel, "hits"), 100u);
      for (const Mode mode : {Mode::kChecked, Mode::kTracing, Mode::kUncounted}) {
        SCOPED_TRACE(to_string(mode));
        const Outcome other = run(mode);
        EXPECT_EQ(other.result.results_hash, counting.result.results_hash);
        EXPECT_EQ(other.frame_hash, counting.frame_hash);
        if (mode == Mode::kUncounted) continue;
        EXPECT_EQ(other.result.counts, counting.result.counts);
        EXPECT_EQ(other.result.counters, counting.result.counters);
        EXPECT_EQ(other.result.series, counting.result.series);
      }
    }
  }
}

class Modes : public testing::TestWithParam<std::tuple<Micropolygon, Edges, bool>> {};

TEST_P(Modes, CountTheSame) {
  KernelOptions options;
  Micropolygon shape;
  std::tie(shape, options.edges, options.cull_backfaces) = GetParam();
  expect_modes_agree(shape, options);
}

TEST_P(Modes, CountTheSameWithAThreshold) {
  KernelOptions options;
  Micropolygon shape;
  std::tie(shape, options.edges, options.cull_backfaces) = GetParam();
  options.stream_load_threshold = 0.4f;
  expect_modes_agree(shape, options);
}

INSTANTIATE_TEST_SUITE_P(
    Options, Modes,
    testing::Combine(testing::Values(Micropolygon::kTriangle, Micropolygon::kQuad),
                     testing::Values(Edges::kInline, Edges::kPrecomputed), testing::Bool()),
    [](const auto& info) {
      const bool is_inline = std::get<1>(info.param) == Edges::kInline;
      return fmt::format("{}_{}_{}", name_of(kShapes, std::get<0>(info.param)),
                         is_inline ? "inline" : "precomputed",
                         std::get<2>(info.param) ? "culled" : "turned");
    });

}  // namespace
}  // namespace lanescope
