// SPDX-License-Identifier: MIT
// Every kernel on every scene at every width, in every mode, with either shape: the same hits and
// the same frame as the scalar reference, bit for bit. The matrix is made from the registries.
#include <gtest/gtest.h>

#include "tests/kernels/micropolygons/runs.h"
#include "workloads/micropolygons/surface_scene.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope {
namespace {

using test::Outcome;

/// A scene in small, tessellated once for each shape; of its many packets, some spread over it.
struct SmallScene {
  static constexpr int kWidthPx = 64, kHeightPx = 40;

  SmallScene(const SurfaceScene& descriptor, Micropolygon shape)
      : scene(descriptor.build(descriptor.default_frame)) {
    TessellationOptions options;
    options.width_px = kWidthPx;
    options.height_px = kHeightPx;
    options.samples_per_pixel = 4;
    options.shape = shape;
    options.packet_capacity = 200;  // a multiple of no width that is tried but 1, 4 and 8
    const Tessellator tessellator(scene, options);
    for (int segment = 0; segment < tessellator.segment_count(); ++segment)
      tessellator.tessellate(segment,
                             [&](const Packet& packet) { packets.push_back(packet.clone()); });
  }

  std::vector<const Packet*> some(std::size_t step) const {
    std::vector<const Packet*> chosen;
    for (std::size_t i = 0; i < packets.size(); i += step) chosen.push_back(&packets[i]);
    return chosen;
  }

  Scene scene;
  std::vector<Packet> packets;
  SampleGrid grid{kWidthPx, kHeightPx, 4, true, 1};
};

class Agreement : public testing::TestWithParam<std::tuple<const SurfaceScene*, Micropolygon>> {};

TEST_P(Agreement, WithTheReference) {
  const auto [descriptor, shape] = GetParam();
  const SmallScene scene(*descriptor, shape);
  KernelOptions options;
  const auto compare = [&](Mode mode, std::size_t step) {
    const auto packets = scene.some(step);
    const Outcome reference =
        test::run(find_kernel("rastmp"), 1, mode, options, scene.grid, packets);
    EXPECT_GT(reference.counter(find_kernel("rastmp"), "hits"), 100u);
    for (const Kernel* kernel : test::rasterizers()) {
      for (const int width : test::tried_widths(*kernel)) {
        SCOPED_TRACE(fmt::format("{}, W = {}, {}", kernel->name, width, to_string(mode)));
        const Outcome outcome = test::run(*kernel, width, mode, options, scene.grid, packets);
        if (mode == Mode::kUncounted) {
          EXPECT_EQ(outcome.result.results_hash, reference.result.results_hash);
          EXPECT_EQ(outcome.frame_hash, reference.frame_hash);
        } else {
          test::expect_same(*kernel, outcome, reference);
        }
      }
    }
  };
  compare(Mode::kCounting, 1);
  compare(Mode::kUncounted, 1);
  compare(Mode::kChecked, 16);
  compare(Mode::kTracing, 16);
}

/// Packets are independent: two executions that share them count what one does.
TEST_P(Agreement, OfSplitExecutions) {
  const auto [descriptor, shape] = GetParam();
  const SmallScene scene(*descriptor, shape);
  KernelOptions options;
  for (const Kernel* kernel : test::rasterizers()) {
    const int width = kernel->most_width;
    const auto packets = scene.some(4);
    const auto half = packets.begin() + static_cast<std::ptrdiff_t>(packets.size() / 3);
    const auto whole =
        test::run(*kernel, width, Mode::kCounting, options, scene.grid, packets).result;
    auto sum =
        test::run(*kernel, width, Mode::kCounting, options, scene.grid, {half, packets.end()})
            .result;
    merge(*kernel, sum,
          test::run(*kernel, width, Mode::kCounting, options, scene.grid, {packets.begin(), half})
              .result);
    EXPECT_EQ(sum.counts, whole.counts);
    EXPECT_EQ(sum.counters, whole.counters);
    EXPECT_EQ(sum.results_hash, whole.results_hash);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement,
                         testing::Combine(testing::ValuesIn(surface_scenes()),
                                          testing::Values(Micropolygon::kTriangle,
                                                          Micropolygon::kQuad)),
                         [](const auto& info) {
                           return fmt::format("{}_{}", std::get<0>(info.param)->name,
                                              name_of(kShapes, std::get<1>(info.param)));
                         });

}  // namespace
}  // namespace lanescope
