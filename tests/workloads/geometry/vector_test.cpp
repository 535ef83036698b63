// SPDX-License-Identifier: MIT
#include "workloads/geometry/vector.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "simulator/base/random.h"
#include "workloads/geometry/noise.h"
#include "workloads/geometry/shapes.h"

namespace lanescope {
namespace {

TEST(Vector, CrossIsRightHandedAndOrthogonal) {
  const Vec3 z = cross({1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
  EXPECT_EQ(z.z, 1.0f);
  const Vec3 a{1.0f, 2.0f, 3.0f}, b{-2.0f, 0.5f, 4.0f};
  EXPECT_NEAR(dot(cross(a, b), a), 0.0f, 1e-5f);
  EXPECT_NEAR(length(normalized(a)), 1.0f, 1e-6f);
}

TEST(SinTurns, AgreesWithTheLibrary) {
  for (int i = -2000; i <= 2000; ++i) {
    const float turns = static_cast<float>(i) / 512.0f;
    const double radians = 2.0 * std::numbers::pi * turns;
    EXPECT_NEAR(sin_turns(turns), std::sin(radians), 2e-6) << turns;
    EXPECT_NEAR(cos_turns(turns), std::cos(radians), 2e-6) << turns;
  }
}

TEST(SmoothStep, IsClampedInBothDirections) {
  EXPECT_EQ(smooth_step(1.0f, 2.0f, 0.0f), 0.0f);
  EXPECT_EQ(smooth_step(1.0f, 2.0f, 1.5f), 0.5f);
  EXPECT_EQ(smooth_step(1.0f, 2.0f, 3.0f), 1.0f);
  EXPECT_EQ(smooth_step(2.0f, 1.0f, 0.0f), 1.0f);
}

TEST(Noise, IsZeroOnTheLatticeContinuousAndBounded) {
  float low = 0.0f, high = 0.0f;
  for (int i = 0; i < 5000; ++i) {
    const auto at = static_cast<float>(i);
    EXPECT_EQ(noise({at, -at, 3.0f}), 0.0f);
    const Vec3 p{at * 0.037f, at * 0.11f - 90.0f, at * 0.23f};
    const float value = noise(p);
    EXPECT_NEAR(value, noise(p + Vec3{1e-4f, -1e-4f, 1e-4f}), 2e-3f);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_GT(low, -1.1f);
  EXPECT_LT(low, -0.4f);
  EXPECT_LT(high, 1.1f);
  EXPECT_GT(high, 0.4f);
}

TEST(Noise, HasTheSameBitsEverywhere) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto at = static_cast<float>(i);
    const float value = fractal_noise({at * 0.37f, at * 0.11f, 7.0f - at * 0.23f}, 3);
    hash = mix64(hash ^ std::bit_cast<std::uint32_t>(value));
  }
  EXPECT_EQ(hash, 5413151999387599150u);
}

TEST(CubeSphere, FacesOutwardAndMeetsAtTheEdges) {
  for (int face = 0; face < 6; ++face) {
    const Vec3 p = cube_sphere_direction(face, 0.4f, 0.7f);
    const Vec3 normal = cross(cube_sphere_direction(face, 0.41f, 0.7f) - p,
                              cube_sphere_direction(face, 0.4f, 0.71f) - p);
    EXPECT_NEAR(length(p), 1.0f, 1e-6f);
    EXPECT_GT(dot(normal, p), 0.0f) << "face " << face;
  }
  // The middle of the edge between +x and +y, as both faces see it.
  const Vec3 a = cube_sphere_direction(0, 1.0f, 0.5f), b = cube_sphere_direction(2, 0.5f, 1.0f);
  EXPECT_NEAR(length(a - b), 0.0f, 1e-6f);
}

TEST(Curve, PassesThroughItsMiddlePoints) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{2, 1, 0}, d{3, 1, 1};
  EXPECT_NEAR(length(curve_point(a, b, c, d, 0.0f) - b), 0.0f, 1e-6f);
  EXPECT_NEAR(length(curve_point(a, b, c, d, 1.0f) - c), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace lanescope
