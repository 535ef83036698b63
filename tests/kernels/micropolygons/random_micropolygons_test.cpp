// SPDX-License-Identifier: MIT
// Properties on random micropolygons, with shrinking: whatever the input, every kernel agrees with
// the reference, and nothing leaves its memory.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <set>

#include "tests/kernels/micropolygons/runs.h"
#include "workloads/micropolygons/grid.h"

namespace lanescope {
namespace {

/// A coordinate: mostly near a 12 x 12 frame and on the sub-pixel grid, at times far out; a wild
/// one at times huge, infinite or not a number.
rc::Gen<float> coordinate(bool wild) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto tame = rc::gen::weightedOneOf<float>({
      {60, rc::gen::map(rc::gen::inRange(-512, 13 * 256),
                        [](int step) { return static_cast<float>(step) * kSubpixel; })},
      {10,
       rc::gen::map(rc::gen::inRange(0, 13), [](int cell) { return static_cast<float>(cell); })},
      {4, rc::gen::map(rc::gen::inRange(-40, 40),
                       [](int tens) { return static_cast<float>(tens) * 10.5f; })},
      {1, rc::gen::element(1e-40f, -0.0f, kMaxCoordinateCells, -kMaxCoordinateCells)},
  });
  if (!wild) return tame;
  return rc::gen::weightedOneOf<float>({
      {75, tame},
      {2, rc::gen::element(1e30f, -1e30f, 3e38f, 16777216.0f)},
      {1, rc::gen::element(kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN())},
  });
}

rc::Gen<Vertex> vertex(bool wild) {
  return rc::gen::map(rc::gen::tuple(coordinate(wild), coordinate(wild), rc::gen::inRange(0, 1000)),
                      [](const auto& v) {
                        const auto [x, y, shade] = v;
                        const float s = static_cast<float>(shade) / 999.0f;
                        return Vertex{{x, y, 0.25f + s, s, 1.0f - s, s * s, 1.0f}};
                      });
}

/// A micropolygon; at times two of its corners coincide.
rc::Gen<std::vector<Vertex>> micropolygon(Micropolygon shape, bool wild) {
  const auto corners = static_cast<std::size_t>(corner_count(shape));
  return rc::gen::map(rc::gen::pair(rc::gen::container<std::vector<Vertex>>(corners, vertex(wild)),
                                    rc::gen::inRange(0, 8)),
                      [](auto drawn) {
                        if (drawn.second == 0) drawn.first[1] = drawn.first[0];
                        return drawn.first;
                      });
}

Packet draw_packet(Micropolygon shape) {
  const bool wild = *rc::gen::arbitrary<bool>();
  const auto polygons = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::vector<Vertex>>>(micropolygon(shape, wild)));
  Packet packet(shape, static_cast<int>(polygons.size()));
  for (const auto& corners : polygons) packet.append(corners.data());
  return packet;
}

SampleGrid draw_grid() {
  return SampleGrid(*rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7), *rc::gen::element(1, 4, 9),
                    *rc::gen::arbitrary<bool>(), 3);
}

/// Three of the widths that tests try, and 1 for the scalar reference.
std::vector<int> draw_widths() {
  std::set<int> widths{1};
  for (int i = 0; i < 3; ++i)
    widths.insert(*rc::gen::elementOf(
        std::vector<int>(std::begin(test::kTriedWidths), std::end(test::kTriedWidths))));
  return {widths.begin(), widths.end()};
}

RC_GTEST_PROP(RandomMicropolygons, TrianglesAgree, ()) {
  const Packet packet = draw_packet(Micropolygon::kTriangle);
  test::expect_agreement(packet, draw_grid(), *rc::gen::arbitrary<bool>(), draw_widths());
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(RandomMicropolygons, QuadsAgree, ()) {
  const Packet packet = draw_packet(Micropolygon::kQuad);
  test::expect_agreement(packet, draw_grid(), *rc::gen::arbitrary<bool>(), draw_widths());
  RC_ASSERT(!testing::Test::HasFailure());
}

/// The threshold on stream loading changes when lanes are loaded, never what is hit.
RC_GTEST_PROP(RandomMicropolygons, TheStreamLoadThresholdChangesNoHit, ()) {
  const Packet packet = draw_packet(Micropolygon::kTriangle);
  const SampleGrid grid = draw_grid();
  const Kernel& repack = find_kernel("repack");
  KernelOptions options;
  options.stream_load_threshold = static_cast<float>(*rc::gen::inRange(0, 101)) / 100.0f;
  const auto with = test::run(repack, 8, Mode::kCounting, options, grid, {&packet});
  const auto without = test::run(repack, 8, Mode::kCounting, {}, grid, {&packet});
  RC_ASSERT(with.result.results_hash == without.result.results_hash);
  RC_ASSERT(with.frame_hash == without.frame_hash);
}

}  // namespace
}  // namespace lanescope
