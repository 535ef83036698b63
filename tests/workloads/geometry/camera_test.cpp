// SPDX-License-Identifier: MIT
#include "workloads/geometry/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanescope {
namespace {

TEST(Camera, ProjectsTheTargetToTheMiddleOfTheFrame) {
  Camera camera;
  camera.eye = {3.0f, 2.0f, 5.0f};
  camera.target = {1.0f, 1.0f, 1.0f};
  const Projection projection = camera.projection(640, 360);
  const FramePoint p = projection.to_frame(projection.to_camera(camera.target));
  EXPECT_NEAR(p.x_px, 320.0f, 1e-3f);
  EXPECT_NEAR(p.y_px, 180.0f, 1e-3f);
}

TEST(Camera, ProjectsTheEdgesOfItsField) {
  Camera camera;
  camera.field_degrees = 90.0f;
  const Projection projection = camera.projection(400, 200);
  // At distance 2, half the height is 2 tan(45 degrees) = 2.
  const FramePoint top = projection.to_frame(projection.to_camera({0.0f, 2.0f, -2.0f}));
  EXPECT_NEAR(top.x_px, 200.0f, 1e-3f);
  EXPECT_NEAR(top.y_px, 0.0f, 1e-3f);
  const FramePoint right = projection.to_frame(projection.to_camera({4.0f, 0.0f, -2.0f}));
  EXPECT_NEAR(right.x_px, 400.0f, 1e-3f);
  EXPECT_NEAR(right.y_px, 100.0f, 1e-3f);
  EXPECT_NEAR(projection.half_width(), 2.0f, 1e-5f);
  EXPECT_NEAR(projection.half_height(), 1.0f, 1e-5f);
}

TEST(Camera, DepthGrowsWithDistanceAndIsLinearOnTheFrame) {
  Camera camera;
  camera.near = 0.5f;
  const Projection projection = camera.projection(100, 100);
  EXPECT_EQ(projection.to_frame({0.0f, 0.0f, 0.5f}).depth, 0.0f);
  EXPECT_FLOAT_EQ(projection.to_frame({0.0f, 0.0f, 1.0f}).depth, 0.5f);
  EXPECT_LT(projection.to_frame({0.0f, 0.0f, 2.0f}).depth,
            projection.to_frame({0.0f, 0.0f, 3.0f}).depth);
  // A slanted segment: the middle of its image has the mean of the depths.
  const CameraPoint a{-1.0f, 0.0f, 2.0f}, b{2.0f, 0.0f, 4.0f};
  const FramePoint fa = projection.to_frame(a), fb = projection.to_frame(b);
  // Perspective-correct middle: weights are proportional to the other end's distance.
  const float t = a.z / (a.z + b.z);
  const CameraPoint middle{a.x + (b.x - a.x) * t, 0.0f, a.z + (b.z - a.z) * t};
  const FramePoint fm = projection.to_frame(middle);
  EXPECT_NEAR(fm.x_px, 0.5f * (fa.x_px + fb.x_px), 1e-3f);
  EXPECT_NEAR(fm.depth, 0.5f * (fa.depth + fb.depth), 1e-6f);
}

TEST(Camera, TurningRotatesThePictureAboutItsMiddle) {
  Camera camera;
  const Projection level = camera.projection(200, 200);
  const Projection turned = camera.turned(90.0f).projection(200, 200);
  const Vec3 p{0.3f, 0.1f, -2.0f};
  const FramePoint before = level.to_frame(level.to_camera(p));
  const FramePoint after = turned.to_frame(turned.to_camera(p));
  const float x = before.x_px - 100.0f, y = before.y_px - 100.0f;
  // Counterclockwise with y down: (x, y) goes to (y, -x).
  EXPECT_NEAR(after.x_px - 100.0f, y, 1e-3f);
  EXPECT_NEAR(after.y_px - 100.0f, -x, 1e-3f);
  EXPECT_FLOAT_EQ(before.depth, after.depth);
}

TEST(Camera, TurnsAddUp) {
  const Camera camera;
  EXPECT_FLOAT_EQ(camera.turned(5.0f).turned(7.0f).roll_degrees, 12.0f);
}

}  // namespace
}  // namespace lanescope
