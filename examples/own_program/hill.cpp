// SPDX-License-Identifier: MIT
// A chequered hill that rises from frame to frame.
#include "workloads/geometry/parametric_surface.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 10;

struct Hill {
  float height;

  static int patch_count() { return 1; }

  SurfacePoint point(int /*patch*/, float u, float v) const {
    const float x = 2.0f * u - 1.0f, y = 2.0f * v - 1.0f;
    const float slope_x = 1.0f - x * x, slope_y = 1.0f - y * y;
    SurfacePoint p;
    p.position = {4.0f * x, 3.0f * y, height * slope_x * slope_y};
    p.pattern = p.position;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const bool is_dark =
        (static_cast<int>(p.pattern.x + 8.0f) + static_cast<int>(p.pattern.y + 8.0f)) % 2;
    Material m;
    m.albedo = is_dark ? Vec3{0.1f, 0.2f, 0.1f} : Vec3{0.7f, 0.8f, 0.5f};
    return m;
  }
};

Scene build(int frame) {
  Scene scene;
  scene.camera.eye = {0.0f, -4.0f, 9.0f};
  scene.camera.target = {0.0f, 0.0f, 0.0f};
  scene.lighting.to_sun = normalized({-0.5f, 0.6f, 0.7f});
  scene.add(make_surface(Hill{0.3f * static_cast<float>(frame)}));
  return scene;
}

}  // namespace

extern const SurfaceScene s_hill = {
    .name = "hill",
    .summary = "a chequered hill that rises",
    .default_frame = 5,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
