// SPDX-License-Identifier: MIT
// Newell's teapot (1975) on a wooden table before a curtain.
#include "workloads/geometry/bezier.h"
#include "workloads/micropolygons/scenes/parts.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 48;

/// The teapot is modelled with z up.
Vec3 upright(Vec3 p) { return {p.x, p.z, -p.y}; }

struct Teapot {
  float turns;

  static int patch_count() { return static_cast<int>(teapot_patches().size()); }

  SurfacePoint point(int patch, float u, float v) const {
    SurfacePoint p;
    p.pattern = upright(teapot_patches()[static_cast<std::size_t>(patch)].point(u, v));
    p.position = turned_y(p.pattern, turns);
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const Vec3 q = p.pattern;
    const float glaze = fractal_noise(q * 1.6f, 3);
    const float line = 1.25f + 0.18f * glaze - q.y;
    Material m;
    m.albedo =
        mix(Vec3{0.04f, 0.16f, 0.24f}, Vec3{0.70f, 0.62f, 0.48f}, smooth_step(-0.12f, 0.12f, line));
    m.albedo = m.albedo * (0.92f + 0.25f * glaze);
    m.gloss = 0.9f;
    m.sharpness = 6;
    return m;
  }
};

struct Table {
  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    SurfacePoint p;
    p.position = box_point(face, u, v, {0.0f, -0.25f, 0.0f}, {9.0f, 0.25f, 5.0f});
    const float plank = p.position.z - std::floor(p.position.z);
    const float gap = std::min(plank, 1.0f - plank);
    p.relief = -0.03f * hill(gap * gap * 900.0f);
    if (face == 2) p.position.y += p.relief;
    p.pattern = p.position;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const Vec3 q = p.pattern;
    const float plank = std::floor(q.z);
    const float grain = fractal_noise({q.x * 0.7f + plank * 9.1f, plank, q.z * 9.0f}, 3);
    Material m;
    m.albedo = mix(Vec3{0.30f, 0.15f, 0.07f}, Vec3{0.52f, 0.30f, 0.15f}, saturate(0.5f + grain));
    m.gloss = 0.25f;
    m.sharpness = 5;
    m.openness = saturate(1.0f + p.relief * 20.0f);
    return m;
  }
};

struct Curtain {
  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 0.0f, 0.4f}, [](float s, float t) {
      const float x = (s - 0.5f) * 30.0f, y = -1.5f + 11.5f * t;
      const float sway = noise({x * 0.5f, y * 0.16f, 1.0f});
      SurfacePoint p;
      p.relief = 0.30f * sin_turns(x * 0.62f + 0.5f * sway) + 0.22f * sway;
      p.position = {x, y, -6.5f + p.relief};
      p.pattern = {x, y, p.relief};
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    Material m;
    m.albedo = Vec3{0.36f, 0.07f, 0.06f} * (0.9f + 0.2f * noise(p.pattern * 6.0f));
    m.openness = saturate(0.7f + 0.6f * p.relief);
    return m;
  }
};

Scene build(int frame) {
  Scene scene;
  scene.camera.eye = {0.4f, 3.9f, 9.6f};
  scene.camera.target = {0.15f, 1.3f, 0.0f};
  scene.camera.field_degrees = 29.0f;
  scene.camera.near = 0.5f;
  scene.lighting.to_sun = normalized({-0.55f, 0.70f, 0.55f});
  scene.lighting.background = {0.20f, 0.10f, 0.09f};
  scene.lighting.sun = {1.7f, 1.5f, 1.2f};
  scene.lighting.bounce = {0.20f, 0.13f, 0.08f};
  scene.add(make_surface(Curtain{}));
  scene.add(make_surface(Table{}));
  const float turns = static_cast<float>(frame) / kFrames;
  scene.add(make_surface(Teapot{turns}),
            {{{0.0f, 1.0f, 0.0f}, 1.75f}, {turned_y({2.5f, 1.5f, 0.0f}, turns), 0.4f}});
  return scene;
}

}  // namespace

extern const SurfaceScene s_teapot = {
    .name = "teapot",
    .summary = "Newell's teapot (1975), 32 bicubic patches, on a wooden table",
    .default_frame = 4,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
