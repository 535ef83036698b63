// SPDX-License-Identifier: MIT
#include "workloads/geometry/lighting.h"

#include <gtest/gtest.h>

#include "tests/workloads/micropolygons/tessellation.h"
#include "workloads/geometry/parametric_surface.h"

namespace lanescope {
namespace {

constexpr Vec3 kUp{0.0f, 1.0f, 0.0f};
constexpr Vec3 kEye{0.0f, 4.0f, 4.0f};

Lighting noon() {
  Lighting lighting;
  lighting.to_sun = kUp;
  return lighting;
}

TEST(Lighting, FacingTheSunIsBrighterThanFacingAway) {
  const Lighting lighting = noon();
  const Vec3 lit = lighting.shade({}, {}, kUp, kEye, {});
  const Vec3 dark = lighting.shade({}, {}, -kUp, kEye, {});
  EXPECT_GT(lit.x, dark.x);
  EXPECT_GT(dark.x, 0.0f);
  EXPECT_LE(lit.x, 1.0f);
}

TEST(Lighting, AShadowerDarkensWhatLiesBehindIt) {
  const auto origin = [](float, float) { return Vec3{}; };
  const auto body = make_surface(test::FunctionShape<decltype(origin)>{origin});
  Lighting lighting = noon();
  lighting.shadowers.push_back({{0.0f, 2.0f, 0.0f}, 1.0f, body.get()});
  std::vector<Shadower> near;
  lighting.shadowers_near(body.get(), {}, 0.1f, near);
  EXPECT_TRUE(near.empty()) << "a body does not shadow itself";
  lighting.shadowers_near(nullptr, {}, 0.1f, near);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_LT(lighting.shade({}, {}, kUp, kEye, near).x, lighting.shade({}, {}, kUp, kEye, {}).x);
  lighting.shadowers_near(nullptr, {100.0f, 0.0f, 0.0f}, 0.1f, near);
  EXPECT_TRUE(near.empty());
}

TEST(Lighting, HazeTakesOverFarAway) {
  Lighting lighting = noon();
  lighting.haze = {0.0f, 0.0f, 1.0f};
  lighting.haze_start = 1.0f;
  const Vec3 far = lighting.shade({}, {0.0f, 0.0f, -1e6f}, kUp, kEye, {});
  EXPECT_LT(far.x, 0.1f);
  EXPECT_GT(far.z, 0.7f);
}

}  // namespace
}  // namespace lanescope
