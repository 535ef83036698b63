// SPDX-License-Identifier: MIT
#include "workloads/geometry/bezier.h"

#include <gtest/gtest.h>

namespace lanescope {
namespace {

TEST(Bernstein, SumsToOneAndIsSymmetric) {
  for (int i = -4; i <= 36; ++i) {
    const float t = static_cast<float>(i) / 32.0f;
    const auto b = bernstein(t), mirrored = bernstein(1.0f - t);
    EXPECT_NEAR(b[0] + b[1] + b[2] + b[3], 1.0f, 1e-6f) << t;
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(b[k], mirrored[3 - k], 1e-6f) << t;
  }
}

TEST(BezierPatch, PassesThroughItsCorners) {
  for (const BezierPatch& patch : teapot_patches()) {
    const auto expect_corner = [&](float u, float v, std::size_t control_point) {
      const Vec3 d = patch.point(u, v) - patch.control_points[control_point];
      EXPECT_EQ(dot(d, d), 0.0f);
    };
    expect_corner(0.0f, 0.0f, 0);
    expect_corner(1.0f, 0.0f, 3);
    expect_corner(0.0f, 1.0f, 12);
    expect_corner(1.0f, 1.0f, 15);
  }
}

TEST(BezierPatch, APlaneOfEvenControlPointsIsItself) {
  BezierPatch patch;
  for (std::size_t i = 0; i < 16; ++i)
    patch.control_points[i] = {static_cast<float>(i % 4), static_cast<float>(i / 4), 2.0f};
  const Vec3 p = patch.point(0.25f, 0.75f);
  EXPECT_NEAR(p.x, 0.75f, 1e-6f);
  EXPECT_NEAR(p.y, 2.25f, 1e-6f);
  EXPECT_NEAR(p.z, 2.0f, 1e-6f);
}

TEST(Teapot, HasThirtyTwoPatchesInNewellsBox) {
  ASSERT_EQ(teapot_patches().size(), 32u);
  for (const BezierPatch& patch : teapot_patches())
    for (const Vec3& p : patch.control_points) {
      EXPECT_GE(p.x, -3.0f);
      EXPECT_LE(p.x, 3.525f);
      EXPECT_LE(std::abs(p.y), 2.0f);
      EXPECT_GE(p.z, 0.0f);
      EXPECT_LE(p.z, 3.15f);
    }
}

TEST(Teapot, BodyFacesOutward) {
  // The body's patches lie around the z axis: their normals point away from it.
  for (std::size_t i = 4; i < 12; ++i) {
    const BezierPatch& patch = teapot_patches()[i];
    const Vec3 p = patch.point(0.5f, 0.5f);
    const Vec3 normal = cross(patch.point(0.6f, 0.5f) - patch.point(0.4f, 0.5f),
                              patch.point(0.5f, 0.6f) - patch.point(0.5f, 0.4f));
    EXPECT_GT(dot(normal, {p.x, p.y, 0.0f}), 0.0f) << "patch " << i;
  }
}

}  // namespace
}  // namespace lanescope
