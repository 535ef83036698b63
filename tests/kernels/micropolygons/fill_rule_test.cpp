// SPDX-License-Identifier: MIT
// Shared edges are covered exactly once: meshes without gaps, whose every sample must be hit once.
#include "kernels/micropolygons/fill_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "tests/kernels/micropolygons/runs.h"

namespace lanescope {
namespace {

TEST(FillRule, OwnsExactlyOneDirectionOfAnEdge) {
  for (float dx = -2; dx <= 2; ++dx)
    for (float dy = -2; dy <= 2; ++dy)
      if (dx != 0 || dy != 0) {
        EXPECT_NE(owns_edge(dx, dy), owns_edge(-dx, -dy));
      }
}

/// A frame of 24 x 24 cells covered by a mesh whose inner vertices are moved at random, by less
/// than keeps every quad convex; on whole cells if `step` is 256, so that samples of a grid
/// without jitter, at cell centres, often lie on edges.
Packet covering_mesh(Micropolygon shape, std::uint64_t seed, float spacing, int step) {
  const int n = static_cast<int>(24 / spacing);
  const auto place = [&](int i, int j) {
    const auto move = [&](std::uint64_t salt, bool border) {
      if (border) return 0.0f;
      const auto hash = mix64(seed * 977 + salt + static_cast<std::uint64_t>(i * 64 + j) * 2);
      const float unit = unit_float(hash) - 0.5f;
      return std::round(unit * 0.4f * spacing * 256 / static_cast<float>(step)) *
             static_cast<float>(step) / 256;
    };
    return std::pair{static_cast<float>(i) * spacing + move(0, i == 0 || i == n),
                     static_cast<float>(j) * spacing + move(1, j == 0 || j == n)};
  };
  std::vector<std::vector<std::pair<float, float>>> polygons;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto a = place(i, j), b = place(i + 1, j), c = place(i + 1, j + 1), d = place(i, j + 1);
      if (shape == Micropolygon::kQuad) {
        polygons.push_back({a, b, c, d});
      } else {
        polygons.push_back({a, b, c});
        polygons.push_back({a, c, d});
      }
    }
  }
  return test::packet_of(shape, polygons);
}

TEST(FillRule, AMeshCoversEverySampleOnce) {
  for (const Micropolygon shape : {Micropolygon::kTriangle, Micropolygon::kQuad}) {
    for (const bool jitter : {false, true}) {
      for (const int step : {1, 64, 128}) {
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
          const SampleGrid grid(24, 24, 1, jitter, seed);
          const Packet packet = covering_mesh(shape, seed, seed % 2 ? 1.5f : 3.0f, step);
          const Arguments arguments = test::arguments_of({}, shape);
          for (const Kernel* kernel : test::rasterizers()) {
            for (const int width : test::tried_widths(*kernel)) {
              Frame frame(grid);
              const auto execution = kernel->start({width, Mode::kCounting, arguments, frame});
              execution->run(packet);
              SCOPED_TRACE(fmt::format("{}, W = {}, {}s, seed {}, step {}", kernel->name, width,
                                       name_of(kShapes, shape), seed, step));
              EXPECT_EQ(frame.covered(), 24u * 24);
              const test::Outcome outcome{execution->result(), frame.hash()};
              EXPECT_EQ(outcome.counter(*kernel, "hits"), 24u * 24);
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace lanescope
