// SPDX-License-Identifier: MIT
// Geometry that cannot be drawn: behind the camera, across its plane, not finite, degenerate.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/workloads/micropolygons/tessellation.h"
#include "workloads/geometry/parametric_surface.h"

namespace lanescope {
namespace {

using test::Tessellation;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One surface, seen from the origin along -z.
template <class Function>
Tessellation seen(Function function) {
  Scene scene;
  scene.camera.field_degrees = 60.0f;
  scene.add(make_surface(test::FunctionShape<Function>{function}));
  return test::tessellate(scene, test::small_options(Micropolygon::kQuad));
}

/// A wall at z that faces the camera.
auto wall(float z) {
  return [z](float u, float v) { return Vec3{2.0f * u - 1.0f, 2.0f * v - 1.0f, z}; };
}

TEST(TessellatorDrop, AWallFacingTheCameraHasOnlyFrontFaces) {
  const Tessellation t = seen(wall(-3.0f));
  ASSERT_FALSE(t.polygons.empty());
  for (const test::Polygon& p : t.polygons) EXPECT_GT(p.area(), 0.0);
  EXPECT_EQ(t.counts.dropped, 0u);
  EXPECT_EQ(t.counts.patches_dropped, 0u);
}

TEST(TessellatorDrop, BackFacesAreEmitted) {
  const Tessellation t = seen([](float u, float v) { return wall(-3.0f)(1.0f - u, v); });
  ASSERT_FALSE(t.polygons.empty());
  for (const test::Polygon& p : t.polygons) EXPECT_LT(p.area(), 0.0);
}

TEST(TessellatorDrop, PatchesBehindTheCameraAreCulled) {
  const Tessellation t = seen(wall(3.0f));
  EXPECT_TRUE(t.polygons.empty());
  EXPECT_EQ(t.counts.patches_culled, 1u);
}

TEST(TessellatorDrop, PatchesBesideTheViewAreCulled) {
  const Tessellation t = seen([](float u, float v) {
    return wall(-3.0f)(u, v) + Vec3{20.0f, 0.0f, 0.0f};
  });
  EXPECT_TRUE(t.polygons.empty());
  EXPECT_GT(t.counts.patches_culled, 0u);
}

TEST(TessellatorDrop, AFloorThroughTheCameraPlaneIsDrawnInFrontOfIt) {
  const Tessellation t = seen([](float u, float v) {
    return Vec3{8.0f * u - 4.0f, -0.3f, 4.0f - 10.0f * v};
  });
  EXPECT_GT(t.polygons.size(), 5000u);
  for (const test::Polygon& p : t.polygons)
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(std::isfinite(p.x(i)) && std::isfinite(p.y(i)));
      ASSERT_LT(std::abs(p.x(i)), kMaxCoordinateCells);
    }
}

TEST(TessellatorDrop, ASheetThroughTheEyeEndsAndIsCounted) {
  const Tessellation t = seen([](float u, float v) {
    return Vec3{0.0f, 2.0f * u - 1.0f, 2.0f - 4.0f * v};
  });
  EXPECT_GT(t.counts.patches_dropped + t.counts.dropped, 0u);
}

TEST(TessellatorDrop, SurfacesThatAreNotFiniteAreDropped) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    const Tessellation t = seen([bad](float, float) { return Vec3{bad, bad, bad}; });
    EXPECT_TRUE(t.polygons.empty());
    EXPECT_GT(t.counts.patches_dropped, 0u);
  }
}

TEST(TessellatorDrop, AHoleThatIsNotANumberLeavesTheRest) {
  const Tessellation t = seen([](float u, float v) {
    const bool hole = (u - 0.4f) * (u - 0.4f) + (v - 0.6f) * (v - 0.6f) < 0.01f;
    return hole ? Vec3{kNan, 0.0f, -3.0f} : wall(-3.0f)(u, v);
  });
  EXPECT_GT(t.counts.patches_dropped + t.counts.dropped, 0u);
  EXPECT_GT(t.polygons.size(), 5000u);
  for (const test::Polygon& p : t.polygons) ASSERT_TRUE(std::isfinite(p.area()));
}

TEST(TessellatorDrop, ASinglePointThatIsNotANumberEnds) {
  const Tessellation t = seen([](float u, float v) {
    return u == 0.5f && v == 0.5f ? Vec3{kNan, kNan, kNan} : wall(-3.0f)(u, v);
  });
  EXPECT_GT(t.polygons.size(), 5000u);
}

TEST(TessellatorDrop, DegenerateSurfacesDoNotFail) {
  EXPECT_LE(seen([](float, float) { return Vec3{0.0f, 0.0f, -3.0f}; }).polygons.size(), 1u);
  EXPECT_NO_THROW(seen([](float u, float) { return Vec3{2.0f * u - 1.0f, 0.0f, -3.0f}; }));
}

TEST(TessellatorDrop, HugeSurfacesEnd) {
  const Tessellation t = seen([](float u, float v) {
    return Vec3{(u - 0.5f) * 1e4f, (v - 0.5f) * 1e4f, -3.0f};
  });
  EXPECT_GT(t.polygons.size(), 40000u);
  EXPECT_LT(t.polygons.size(), 120000u);
}

}  // namespace
}  // namespace lanescope
