// SPDX-License-Identifier: MIT
// The camera pivots in a court of fluted columns.
#include "simulator/base/random.h"
#include "workloads/micropolygons/scenes/parts.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 48;
constexpr float kShaftRadius = 0.62f;
constexpr float kShaftHeight = 6.4f;
constexpr float kWallZ = -9.0f;
constexpr Vec3 kMarble{0.74f, 0.68f, 0.58f};

/// A weathered drum-built shaft with sixteen flutes.
struct Shaft {
  Vec3 foot;
  float seed;

  static int patch_count() { return 4; }

  SurfacePoint point(int quarter, float u, float v) const {
    // Rows of micropolygons run up the flutes, not across them.
    const float around = 0.25f * (static_cast<float>(quarter) + 1.0f - v);
    const float height = u * kShaftHeight;
    const Vec3 out{cos_turns(around), 0.0f, -sin_turns(around)};
    const float wave = 0.5f - 0.5f * cos_turns(16.0f * around);
    const float flute = smooth_step(0.05f, 0.9f, wave) * smooth_step(0.03f, 0.06f, u);
    const Vec3 grain{out.x * 2.0f, height * 1.4f, out.z * 2.0f + seed};
    const float worn = fractal_noise(grain * 2.2f, 3);
    const float chip = smooth_step(0.30f, 0.62f, noise(grain * 1.3f));
    const float joint =
        std::abs(height * (1.0f / 1.6f) - std::floor(height * (1.0f / 1.6f) + 0.5f));
    SurfacePoint p;
    p.relief =
        -0.042f * flute + 0.010f * worn - 0.035f * chip - 0.02f * hill(joint * joint * 9000.0f);
    const float taper = 1.0f - 0.13f * u * u;
    p.position = foot + out * (kShaftRadius * taper + p.relief) + Vec3{0.0f, height, 0.0f};
    p.pattern = grain;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const float bent = noise(p.pattern * 0.9f);
    const float vein = smooth_step(0.07f, 0.0f, std::abs(noise(p.pattern * 0.6f) + 0.3f * bent));
    Material m;
    m.albedo = mix(kMarble, {0.46f, 0.36f, 0.30f}, 0.6f * vein) * (0.92f + 0.16f * bent);
    m.gloss = 0.18f;
    m.sharpness = 4;
    m.openness = saturate(1.0f + p.relief * 6.0f);
    return m;
  }
};

/// Height of a pavement or wall of slabs with worn edges: 0 inside, lower at the joints.
float slab_joint(float x, float y) {
  const float dx = std::abs(x - std::floor(x + 0.5f)), dy = std::abs(y - std::floor(y + 0.5f));
  const float edge = std::min(dx, dy);
  return -hill(edge * edge * 700.0f);
}

std::uint64_t slab_id(float x, float y) {
  return mix64(static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x))) * 8191 +
               static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(y))));
}

struct Floor {
  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 0.8f, 0.0f}, [](float s, float t) {
      const float x = (s - 0.5f) * 44.0f, z = 11.0f - t * 20.5f;
      SurfacePoint p;
      p.relief = 0.012f * slab_joint(x * 0.8f, z * 0.8f) +
                 0.010f * fractal_noise({x * 2.3f, 0.0f, z * 2.3f}, 3);
      p.position = {x, p.relief + 0.05f * noise({x * 0.4f, 9.0f, z * 0.4f}), z};
      p.pattern = {x, 0.0f, z};
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const bool odd = slab_id(p.pattern.x * 0.8f, p.pattern.z * 0.8f) & 1;
    Material m;
    m.albedo = odd ? Vec3{0.44f, 0.33f, 0.25f} : Vec3{0.55f, 0.48f, 0.40f};
    m.albedo = m.albedo * (0.85f + 0.3f * noise(p.pattern * 1.3f));
    m.gloss = 0.35f;
    m.sharpness = 5;
    m.openness = saturate(0.95f + p.relief * 12.0f);
    return m;
  }
};

struct Wall {
  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 0.0f, 0.8f}, [](float s, float t) {
      const float x = (s - 0.5f) * 44.0f, y = -0.2f + t * 5.4f;
      const float row = std::floor(y * 1.1f);
      const float shift = 0.5f * (row - 2.0f * std::floor(row * 0.5f));
      SurfacePoint p;
      p.pattern = {x * 0.55f + shift, y * 1.1f, 0.0f};
      p.relief = 0.05f * slab_joint(p.pattern.x, p.pattern.y) +
                 0.045f * fractal_noise({x * 1.5f, y * 1.5f, 2.0f}, 3);
      p.position = {x, y, kWallZ + p.relief};
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const float tone = unit_float(slab_id(p.pattern.x, p.pattern.y));
    Material m;
    m.albedo = mix(Vec3{0.42f, 0.20f, 0.13f}, Vec3{0.58f, 0.36f, 0.24f}, tone);
    m.albedo = m.albedo * (0.85f + 0.3f * noise(p.pattern * 3.0f));
    m.openness = saturate(0.9f + p.relief * 5.0f);
    return m;
  }
};

void add_column(Scene& scene, float x, float z, float seed) {
  std::vector<Shadower> trunk;
  for (int i = 0; i < 6; ++i) trunk.push_back({{x, 0.5f + 1.1f * static_cast<float>(i), z}, 0.66f});
  scene.add(make_surface(Shaft{{x, 0.62f, z}, seed}), trunk);
  scene.add(make_surface(Block{{x, 0.15f, z}, {0.95f, 0.15f, 0.95f}, 0.02f, kMarble}));
  scene.add(make_surface(Moulding{{x, 0.40f, z}, 0.74f, 0.14f, kMarble}));
  scene.add(make_surface(Moulding{{x, 0.60f, z}, 0.66f, 0.08f, kMarble}));
  scene.add(make_surface(Moulding{{x, kShaftHeight + 0.4f, z}, 0.60f, 0.16f, kMarble}));
  scene.add(
      make_surface(Block{{x, kShaftHeight + 0.85f, z}, {0.95f, 0.3f, 0.95f}, 0.02f, kMarble}));
}

Scene build(int frame) {
  Scene scene;
  const float pivot = (static_cast<float>(frame) / (kFrames - 1) - 0.5f) * 0.12f - 0.045f;
  scene.camera.eye = {-3.4f, 2.5f, 9.0f};
  scene.camera.target = scene.camera.eye + turned_y({0.1f, 0.03f, -1.0f}, pivot);
  scene.camera.field_degrees = 38.0f;
  scene.camera.near = 0.5f;
  scene.lighting.to_sun = normalized({-0.75f, 0.62f, 0.55f});
  scene.lighting.sun = {1.3f, 1.05f, 0.75f};
  scene.lighting.sky = {0.26f, 0.31f, 0.42f};
  scene.lighting.bounce = {0.20f, 0.15f, 0.11f};
  scene.lighting.background = {0.52f, 0.70f, 0.92f};
  scene.lighting.haze = {0.55f, 0.44f, 0.36f};
  scene.lighting.haze_start = 9.0f;
  scene.lighting.haze_length = 40.0f;
  scene.add(make_surface(Floor{}));
  scene.add(make_surface(Wall{}));
  for (int i = 0; i < 4; ++i) {
    const float x = -8.0f + 5.8f * static_cast<float>(i);
    add_column(scene, x, 0.8f, static_cast<float>(i) * 7.3f);
    add_column(scene, x + 2.9f, -5.0f, 60.0f + static_cast<float>(i) * 5.9f);
  }
  return scene;
}

}  // namespace

extern const SurfaceScene s_columnpivot = {
    .name = "columnpivot",
    .summary = "the camera pivots in a court of weathered, fluted columns",
    .default_frame = 22,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
