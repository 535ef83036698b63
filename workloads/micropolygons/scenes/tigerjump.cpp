// SPDX-License-Identifier: MIT
// A tiger leaps over a boulder in a hilly meadow.
#include "simulator/base/random.h"
#include "workloads/micropolygons/scenes/parts.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 48;

/// One limb of the tiger with its fur.
struct Fur {
  Limb limb;
  Vec3 origin;
  float clumps = 1.0f;   ///< Height of the fur, in parts of the usual.
  float stripes = 8.0f;  ///< Dark rings along the limb.
  float seed = 0.0f;

  static int patch_count() { return 2; }

  SurfacePoint point(int half, float u, float v) const {
    const Limb::Point at = limb.point(half, u, v);
    const Vec3 body = at.centre + at.outward * at.radius;
    const float clump = noise({body.x * 5.0f + seed, body.y * 9.0f, body.z * 9.0f});
    const float hairs = noise({body.x * 13.0f, body.y * 30.0f, body.z * 30.0f});
    SurfacePoint p;
    p.relief = clumps * (0.018f * clump + 0.0055f * hairs);
    const float swell = std::min(1.0f, at.radius * 8.0f);
    p.position = origin + body + at.outward * (p.relief * swell);
    const float up = sin_turns(at.around);
    p.pattern = {at.along, up, hairs};
    return p;
  }

  Material material(const SurfacePoint& p, Vec3 normal) const {
    const Vec3 q = p.position - origin;
    const float warp = noise({q.x * 2.2f + seed, q.y * 2.2f, q.z * 2.2f});
    const float ring = sin_turns(stripes * p.pattern.x + 0.55f * warp + 0.06f * p.pattern.z);
    const float broken = noise({q.x * 1.3f, q.y * 3.1f + seed, q.z * 3.1f});
    const float stripe = smooth_step(0.45f, 0.62f, ring + 0.35f * broken);
    const float belly = smooth_step(-0.15f, -0.65f, normal.y + 0.25f * broken);
    Material m;
    m.albedo = mix(Vec3{0.66f, 0.27f, 0.05f}, Vec3{0.76f, 0.68f, 0.56f}, belly);
    m.albedo = mix(m.albedo, {0.03f, 0.022f, 0.018f}, stripe * (1.0f - 0.5f * belly));
    m.albedo = m.albedo * (0.9f + 0.35f * p.pattern.z);
    m.gloss = 0.14f;
    m.sharpness = 3;
    m.openness = saturate(0.9f + 8.0f * p.relief);
    return m;
  }
};

/// The head looks along +x: a skull, a muzzle and cheeks, with a mask of stripes.
struct Face {
  Vec3 centre;

  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    const Vec3 d = cube_sphere_direction(face, u, v);
    const auto bump = [d](Vec3 at, float size) {
      const Vec3 away = Vec3{d.x, d.y, std::abs(d.z)} - at;
      return hill(dot(away, away) / (size * size));
    };
    const float fur = noise(d * 9.0f), hairs = noise(d * 24.0f);
    SurfacePoint p;
    p.relief = 0.022f * fur + 0.012f * hairs;
    const float shape =
        0.26f * bump({0.96f, -0.30f, 0.0f}, 0.60f) + 0.16f * bump({0.92f, -0.34f, 0.22f}, 0.34f) -
        0.10f * bump({0.82f, 0.28f, 0.48f}, 0.30f) + 0.24f * bump({0.25f, -0.45f, 0.85f}, 0.60f) -
        0.10f * bump({0.88f, -0.64f, 0.10f}, 0.26f);
    p.position = centre + Vec3{0.42f, 0.41f, 0.43f} * d * (1.0f + shape + p.relief);
    p.pattern = d;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const Vec3 d = p.pattern;
    const float z = std::abs(d.z);
    const float muzzle = smooth_step(0.2f, -0.25f, d.y) * smooth_step(0.0f, 0.55f, d.x);
    const float ring = sin_turns(3.2f * d.x + 2.4f * z + 0.4f * noise(d * 3.0f));
    const float stripe = smooth_step(0.45f, 0.7f, ring) * smooth_step(0.92f, 0.7f, d.x);
    const Vec3 nose = d - normalized({0.99f, -0.10f, 0.0f});
    const Vec3 eye = Vec3{d.x, d.y, z} - normalized({0.80f, 0.30f, 0.46f});
    Material m;
    m.albedo = mix(Vec3{0.66f, 0.27f, 0.05f}, Vec3{0.78f, 0.71f, 0.60f}, muzzle);
    m.albedo = mix(m.albedo, {0.03f, 0.022f, 0.018f}, stripe);
    m.albedo = mix(m.albedo, {0.45f, 0.14f, 0.12f}, hill(dot(nose, nose) * 40.0f));
    m.albedo = mix(m.albedo, {0.02f, 0.02f, 0.01f}, saturate(4.0f * hill(dot(eye, eye) * 42.0f)));
    m.albedo = mix(m.albedo, {0.75f, 0.60f, 0.10f}, saturate(4.0f * hill(dot(eye, eye) * 110.0f)));
    m.albedo = mix(m.albedo, {0.01f, 0.01f, 0.01f}, saturate(4.0f * hill(dot(eye, eye) * 600.0f)));
    m.gloss = 0.15f;
    m.sharpness = 4;
    m.openness = saturate(0.9f + 6.0f * p.relief);
    return m;
  }
};

float meadow_height(float x, float z) {
  const float far_away = smooth_step(2.0f, 34.0f, -z);
  return far_away * (6.5f + 5.0f * noise({x * 0.06f, 2.0f, z * 0.02f})) +
         0.35f * noise({x * 0.35f, 8.0f, z * 0.35f});
}

struct Meadow {
  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 1.5f, 0.0f}, [](float s, float t) {
      const Vec3 at = turned_y({(s - 0.5f) * 64.0f, 0.0f, (0.5f - t) * 64.0f}, 0.035f);
      const float x = at.x, z = at.z - 15.0f;
      const float tufts = noise({x * 1.6f, 0.0f, z * 1.6f});
      const float blades = noise({x * 6.5f, 1.0f, z * 5.0f});
      SurfacePoint p;
      p.relief = 0.07f * tufts + 0.010f * blades;
      p.position = {x, meadow_height(x, z) + p.relief, z};
      p.pattern = {x, z, blades};
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const float dry = noise({p.pattern.x * 0.22f, 5.0f, p.pattern.y * 0.22f});
    Material m;
    m.albedo = mix(Vec3{0.045f, 0.12f, 0.02f}, Vec3{0.30f, 0.26f, 0.08f},
                   saturate(0.42f + 0.7f * dry + 0.3f * p.pattern.z));
    m.openness = saturate(0.75f + 4.0f * p.relief);
    return m;
  }
};

using Joints = std::array<Limb::Joint, Limb::kJoints>;

/// `stretch` is 1 with the legs thrown out, 0 with them drawn in.
void add_tiger(Scene& scene, Vec3 origin, float stretch) {
  const auto add = [&](const Joints& joints, float width, float clumps, float stripes, float seed) {
    scene.add(make_surface(Fur{{joints, width}, origin, clumps, stripes, seed}));
  };
  const float s = stretch;
  std::vector<Shadower> trunk;
  for (const float x : {-1.0f, -0.5f, 0.0f, 0.5f, 1.0f})
    trunk.push_back({origin + Vec3{x, 0.05f, 0.0f}, 0.46f});
  scene.add(make_surface(Fur{{{{{{-1.55f, -0.12f, 0}, 0.30f},
                                {{-0.95f, 0.06f, 0}, 0.50f},
                                {{-0.1f, 0.05f, 0}, 0.43f},
                                {{0.75f, 0.10f, 0}, 0.52f},
                                {{1.45f, 0.30f, 0}, 0.33f}}},
                              0.92f},
                             origin,
                             1.4f,
                             11.0f,
                             0.0f}),
            trunk);
  add({{{{0.95f, 0.18f, 0}, 0.36f},
        {{1.25f, 0.35f, 0}, 0.36f},
        {{1.55f, 0.52f, 0}, 0.32f},
        {{1.75f, 0.60f, 0}, 0.30f},
        {{1.95f, 0.66f, 0}, 0.24f}}},
      1.0f, 1.4f, 4.0f, 5.0f);
  scene.add(make_surface(Face{origin + Vec3{2.02f, 0.70f, 0.0f}}),
            {{origin + Vec3{2.02f, 0.7f, 0.0f}, 0.38f}});
  for (const float side : {-1.0f, 1.0f}) {
    const float z = 0.30f * side, lead = 0.10f * side;
    const float ear = 0.26f * side;
    add({{{{1.86f, 0.98f, ear}, 0.11f},
          {{1.84f, 1.07f, ear}, 0.13f},
          {{1.82f, 1.14f, ear}, 0.12f},
          {{1.80f, 1.20f, ear}, 0.09f},
          {{1.79f, 1.25f, ear}, 0.04f}}},
        0.8f, 0.5f, 1.0f, 2.0f);
    add({{{{0.75f, 0.05f, z}, 0.33f},
          {{mix(0.95f, 1.25f, s), mix(-0.45f, -0.22f, s), z}, 0.23f},
          {{mix(0.75f, 1.80f, s) + lead, mix(-0.85f, -0.30f, s), z}, 0.165f},
          {{mix(0.85f, 2.25f, s) + lead, mix(-1.10f, -0.22f, s), z}, 0.125f},
          {{mix(1.05f, 2.55f, s) + lead, mix(-1.15f, -0.30f, s), z}, 0.18f}}},
        1.0f, 1.0f, 7.0f, 11.0f + side);
    add({{{{-1.15f, -0.02f, z}, 0.42f},
          {{mix(-0.75f, -1.45f, s), mix(-0.55f, -0.50f, s), z}, 0.31f},
          {{mix(-1.15f, -2.05f, s) - lead, mix(-0.85f, -0.58f, s), z}, 0.17f},
          {{mix(-0.95f, -2.50f, s) - lead, mix(-1.10f, -0.90f, s), z}, 0.115f},
          {{mix(-0.65f, -2.80f, s) - lead, mix(-1.15f, -1.10f, s), z}, 0.17f}}},
        1.0f, 1.0f, 7.0f, 17.0f + side);
  }
  add({{{{-1.45f, 0.02f, 0}, 0.16f},
        {{-2.0f, 0.20f, 0.05f}, 0.11f},
        {{-2.5f, 0.55f, 0.0f}, 0.095f},
        {{-2.95f, 0.62f, -0.05f}, 0.085f},
        {{-3.35f, 0.45f, 0.0f}, 0.06f}}},
      1.0f, 1.0f, 10.0f, 23.0f);
}

Scene build(int frame) {
  Scene scene;
  const float phase = static_cast<float>(frame) / (kFrames - 1);
  const float arc = 4.0f * phase * (1.0f - phase);
  scene.camera.eye = {2.4f, 2.9f, 7.8f};
  scene.camera.target = {0.0f, 1.55f, 0.0f};
  scene.camera.field_degrees = 33.0f;
  scene.camera.near = 0.5f;
  scene.lighting.to_sun = normalized({0.55f, 0.62f, 0.60f});
  scene.lighting.sun = {1.75f, 1.5f, 1.1f};
  scene.lighting.sky = {0.30f, 0.40f, 0.52f};
  scene.lighting.bounce = {0.12f, 0.15f, 0.06f};
  scene.lighting.haze = {0.50f, 0.58f, 0.62f};
  scene.lighting.background = {0.58f, 0.74f, 0.92f};
  scene.lighting.haze_start = 9.0f;
  scene.lighting.haze_length = 60.0f;
  scene.add(make_surface(Meadow{}));
  add_tiger(scene, {mix(-1.6f, 1.6f, phase), 0.95f + 1.05f * arc, 0.0f},
            smooth_step(0.0f, 0.6f, arc));
  for (std::uint64_t i = 0; i < 16; ++i) {
    const auto random = [i](std::uint64_t k) { return unit_float(mix64(i * 8 + k + 500)); };
    const float z = 1.2f - 16.0f * random(0);
    const float x = i == 0 ? 0.5f : (random(1) - 0.5f) * (11.0f - 1.2f * z);
    const float radius = i == 0 ? 0.75f : 0.15f + 0.55f * random(2) * random(2);
    const Vec3 centre{x, meadow_height(x, z) + 0.25f * radius, z};
    const Vec3 seed{random(3) * 50.0f, random(4) * 50.0f, 0.0f};
    scene.add(
        make_surface(Stone{centre, radius, seed, {0.20f, 0.20f, 0.17f}, {0.38f, 0.37f, 0.31f}}),
        {{centre, radius * 0.85f}});
  }
  return scene;
}

}  // namespace

extern const SurfaceScene s_tigerjump = {
    .name = "tigerjump",
    .summary = "a tiger in mid-leap over boulders in a hilly meadow",
    .default_frame = 26,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
