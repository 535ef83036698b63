// SPDX-License-Identifier: MIT
// A stitched ball rolls over sand among pebbles and leaves a track.
#include "simulator/base/random.h"
#include "workloads/micropolygons/scenes/parts.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 48;
constexpr float kBallRadius = 1.45f;
constexpr float kRollLength = 6.0f;

float ball_x(int frame) {
  return -0.5f * kRollLength + kRollLength * static_cast<float>(frame) / (kFrames - 1);
}

/// Height of the sand without ripples: level near the ball, dunes far behind.
float dune_height(float x, float z) {
  const float far_away = smooth_step(3.0f, 26.0f, -z);
  return far_away * (5.2f + 2.4f * noise({x * 0.09f, 0.5f, z * 0.13f})) +
         0.2f * noise({x * 0.3f, 3.5f, z * 0.3f});
}

struct Sand {
  float track_end_x;

  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 1.2f, 0.0f}, [this](float s, float t) {
      const Vec3 at = turned_y({(s - 0.5f) * 84.0f, 0.0f, (0.5f - t) * 84.0f}, 0.02f);
      const float x = at.x, z = at.z - 16.0f;
      const float grain = fractal_noise({x * 2.6f, 0.0f, z * 2.6f}, 2);
      const float bend = noise({x * 0.35f, 7.0f, z * 0.35f});
      const float ripple = sin_turns(z * 1.7f + x * 0.4f + bend * 1.2f);
      const float across = z * (1.0f / 0.62f);
      const float in_track = hill(across * across) * smooth_step(0.4f, -0.4f, x - track_end_x);
      const float relief = (0.020f * ripple + 0.026f * grain) * (1.0f - 0.6f * in_track);
      SurfacePoint p;
      p.position = {x, dune_height(x, z) + relief - 0.16f * in_track, z};
      p.pattern = {x, z, in_track};
      p.relief = relief;
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    Material m;
    const float patchy = noise({p.pattern.x * 0.8f, 1.0f, p.pattern.y * 0.8f});
    m.albedo = mix(Vec3{0.36f, 0.21f, 0.10f}, Vec3{0.56f, 0.38f, 0.20f},
                   saturate(0.5f + 0.5f * patchy + p.relief * 4.0f));
    m.albedo = m.albedo * (1.0f - 0.25f * p.pattern.z);
    m.openness = saturate(0.85f + p.relief * 6.0f);
    return m;
  }
};

struct Ball {
  Vec3 centre;
  float turns;

  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    const Vec3 d = cube_sphere_direction(face, u, v);
    const float dimples = std::abs(noise(d * 7.0f));
    const float leather = fractal_noise(d * 21.0f, 2);
    const float seam = std::min({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const float groove = hill(seam * seam * 900.0f);
    SurfacePoint p;
    p.relief = 0.045f * dimples + 0.012f * leather - 0.05f * groove;
    p.position = centre + turned_z(turned_x(d, 0.07f), -turns) * (kBallRadius * (1.0f + p.relief));
    p.pattern = d;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const Vec3 d = p.pattern;
    const bool odd = ((d.x > 0.0f) != (d.y > 0.0f)) != (d.z > 0.0f);
    Material m;
    m.albedo = odd ? Vec3{0.72f, 0.07f, 0.04f} : Vec3{0.86f, 0.78f, 0.62f};
    m.albedo = m.albedo * saturate(0.75f + p.relief * 7.0f);
    m.gloss = 0.45f;
    m.sharpness = 5;
    m.openness = saturate(0.9f + p.relief * 4.0f);
    return m;
  }
};

void add_pebbles(Scene& scene) {
  constexpr int kPebbles = 34;
  for (std::uint64_t i = 0; i < kPebbles; ++i) {
    const auto random = [i](std::uint64_t k) { return unit_float(mix64(i * 8 + k)); };
    const float z = 3.6f - 15.0f * random(0);
    const float x = (random(1) - 0.5f) * (12.0f - z);
    if (std::abs(z) < 1.0f) continue;
    const float radius = 0.10f + 0.34f * random(2) * random(3);
    const Vec3 centre{x, dune_height(x, z) + radius * 0.35f, z};
    const Vec3 seed{random(4) * 40.0f, random(5) * 40.0f, random(6) * 40.0f};
    scene.add(make_surface(Stone{centre, radius, seed}), {{centre, radius * 0.85f}});
  }
}

Scene build(int frame) {
  Scene scene;
  const float x = ball_x(frame);
  const Vec3 centre{x, kBallRadius - 0.12f + dune_height(x, 0.0f), 0.0f};
  scene.camera.eye = {0.6f, 3.6f, 8.6f};
  scene.camera.target = {0.0f, 0.75f, 0.0f};
  scene.camera.field_degrees = 32.0f;
  scene.camera.near = 0.5f;
  scene.lighting.to_sun = normalized({-0.62f, 0.52f, 0.42f});
  scene.lighting.background = {0.72f, 0.78f, 0.86f};
  scene.lighting.sun = {1.35f, 1.1f, 0.8f};
  scene.lighting.haze = {0.9f, 0.72f, 0.56f};
  scene.lighting.haze_start = 10.0f;
  scene.lighting.haze_length = 34.0f;
  scene.add(make_surface(Sand{x}));
  const float circumference = 2.0f * std::numbers::pi_v<float> * kBallRadius;
  scene.add(make_surface(Ball{centre, x / circumference}), {{centre, kBallRadius}});
  add_pebbles(scene);
  return scene;
}

}  // namespace

extern const SurfaceScene s_ballroll = {
    .name = "ballroll",
    .summary = "a stitched ball rolls over rippled sand among pebbles",
    .default_frame = 26,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
