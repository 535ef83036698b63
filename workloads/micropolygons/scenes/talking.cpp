// SPDX-License-Identifier: MIT
// A modelled head talks in front of a curtain; the mouth opens and closes.
#include "workloads/micropolygons/scenes/parts.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

constexpr int kFrames = 48;

/// A smooth bump on the unit sphere about a direction, 1 in its middle and 0 beyond its extents
/// across and up the face.
float bump(Vec3 d, Vec3 centre, float across, float up) {
  const Vec3 away = d - centre;
  const float x = away.x / across, y = away.y / up, z = away.z / std::max(across, up);
  return hill(x * x + y * y + z * z);
}

/// The same on both sides of the face.
float bumps(Vec3 d, Vec3 centre, float across, float up) {
  return bump({std::abs(d.x), d.y, d.z}, centre, across, up);
}

struct Head {
  Vec3 centre;
  float open;  ///< 0 for a closed mouth, 1 for a wide open one.
  float nod_turns;

  static int patch_count() { return 6; }

  /// 1 where hair grows.
  static float hair(Vec3 d) {
    const float fringe = 0.10f * noise({d.x * 5.0f, 3.0f, d.z * 5.0f});
    const float line = d.y - 0.46f + fringe + 0.55f * saturate(-d.z - 0.05f) +
                       0.85f * saturate(std::abs(d.x) - 0.62f);
    return smooth_step(-0.02f, 0.05f, line) * smooth_step(-0.62f, -0.45f, d.y);
  }

  /// Height of the features over a plain head, in parts of its radius.
  static float features(Vec3 d) {
    float height = 0.0f;
    height += 0.20f * bump(d, {0.0f, 0.02f, 1.0f}, 0.16f, 0.34f);      // bridge of the nose
    height += 0.20f * bump(d, {0.0f, -0.10f, 0.99f}, 0.20f, 0.20f);    // tip
    height += 0.07f * bumps(d, {0.13f, -0.14f, 0.98f}, 0.13f, 0.12f);  // nostrils
    height -= 0.13f * bumps(d, {0.34f, 0.13f, 0.93f}, 0.25f, 0.20f);   // eye sockets
    height += 0.075f * bumps(d, {0.34f, 0.33f, 0.88f}, 0.36f, 0.15f);  // brows
    height += 0.07f * bumps(d, {0.50f, -0.16f, 0.85f}, 0.36f, 0.34f);  // cheeks
    height += 0.11f * bump(d, {0.0f, -0.68f, 0.73f}, 0.36f, 0.26f);    // chin
    height += 0.24f * bumps(d, {0.99f, 0.02f, -0.05f}, 0.17f, 0.30f);  // ears
    height -= 0.15f * bumps(d, {0.99f, 0.03f, 0.03f}, 0.08f, 0.17f);
    return height;
  }

  struct Mouth {
    float lip;  ///< 1 on the lips.
    float gap;  ///< 1 between them.
  };

  /// Lips about a slit that opens.
  Mouth mouth(Vec3 d) const {
    const float slit = 0.02f + 0.085f * open;
    const float middle = -0.40f - 0.03f * open - 0.06f * d.x * d.x;
    const float across = d.x / (0.34f - 0.05f * open);
    const float inside = saturate(1.0f - across * across) * (d.z > 0.0f ? 1.0f : 0.0f);
    const float y = std::abs(d.y - middle);
    const float from_lip = y - slit * std::sqrt(inside) - 0.03f;
    return {smooth_step(0.0f, 0.3f, inside) * hill(from_lip * from_lip * 240.0f),
            smooth_step(1.25f * slit, slit, y / std::max(0.2f, std::sqrt(inside))) *
                smooth_step(0.0f, 0.2f, inside)};
  }

  SurfacePoint point(int face, float u, float v) const {
    const Vec3 d = cube_sphere_direction(face, u, v);
    const float hairy = hair(d);
    const float strand = noise({d.x * 26.0f, d.y * 6.0f, d.z * 14.0f});
    const float lock = noise({d.x * 7.0f, d.y * 2.5f, d.z * 4.0f});
    const float pores = noise(d * 34.0f);
    const float skin = 0.0022f * pores;
    const Mouth lips = mouth(d);
    SurfacePoint p;
    p.relief = 0.05f * lips.lip - (0.05f + 0.20f * open) * lips.gap;
    const float radius =
        1.0f + features(d) + p.relief + mix(skin, 0.09f + 0.022f * strand + 0.04f * lock, hairy);
    Vec3 q = Vec3{0.80f, 1.08f, 0.92f} * d * radius;
    const float jaw = smooth_step(-0.38f, -0.50f, d.y) * smooth_step(-0.2f, 0.4f, d.z);
    q.y -= 0.10f * open * jaw;
    q.x *= 1.0f - 0.16f * smooth_step(-0.1f, -0.9f, d.y);
    p.position = centre + turned_y(turned_x(q, nod_turns), -0.055f);
    p.pattern = d;
    return p;
  }

  Material material(const SurfacePoint& p, Vec3 /*normal*/) const {
    const Vec3 d = p.pattern;
    const float blush = bumps(d, {0.52f, -0.18f, 0.84f}, 0.30f, 0.24f) +
                        0.8f * bump(d, {0.0f, -0.10f, 0.99f}, 0.2f, 0.2f);
    const float blotch = noise(d * 4.0f);
    Material m;
    m.albedo = mix(Vec3{0.60f, 0.36f, 0.25f}, Vec3{0.62f, 0.24f, 0.17f},
                   saturate(0.6f * blush + 0.15f * blotch));
    const Mouth lips = mouth(d);
    m.albedo = mix(m.albedo, {0.46f, 0.13f, 0.11f}, 0.9f * lips.lip);
    m.albedo = mix(m.albedo, {0.09f, 0.015f, 0.015f}, lips.gap);
    const float brow = bumps(d, {0.36f, 0.30f, 0.88f}, 0.28f, 0.06f);
    const float strand = noise({d.x * 26.0f, d.y * 6.0f, d.z * 14.0f});
    const Vec3 hair_colour =
        mix(Vec3{0.10f, 0.05f, 0.02f}, Vec3{0.24f, 0.12f, 0.05f}, saturate(0.5f + 0.9f * strand));
    m.albedo = mix(m.albedo, hair_colour, std::max(hair(d), saturate(1.5f * brow)));
    m.gloss = 0.22f * (1.0f - lips.gap);
    m.sharpness = 4;
    m.openness = saturate(1.0f + 2.5f * std::min(p.relief, 0.0f)) *
                 (1.0f - 0.5f * bumps(d, {0.34f, 0.13f, 0.93f}, 0.22f, 0.16f));
    return m;
  }
};

struct Eye {
  Vec3 centre;

  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    SurfacePoint p;
    p.pattern = cube_sphere_direction(face, u, v);
    p.position = centre + p.pattern * 0.155f;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const Vec3 gaze = p.pattern - Vec3{0.07f, -0.01f, 0.997f};
    const float away = length(gaze);
    Material m;
    m.albedo =
        mix(Vec3{0.16f, 0.30f, 0.36f}, Vec3{0.80f, 0.76f, 0.72f}, smooth_step(0.44f, 0.50f, away));
    m.albedo = mix(Vec3{0.01f, 0.01f, 0.01f}, m.albedo, smooth_step(0.20f, 0.25f, away));
    m.gloss = 1.2f;
    m.sharpness = 7;
    return m;
  }
};

/// Shoulders in a knitted jumper.
struct Shoulders {
  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    const Vec3 d = cube_sphere_direction(face, u, v);
    const Vec3 body =
        Vec3{2.15f, 1.25f, 0.95f} * d + Vec3{0.0f, 0.10f, 0.0f} * bump(d, {0, 1, 0}, 0.5f, 0.5f);
    const float fold = noise({body.x * 1.6f, body.y * 0.9f, body.z * 1.6f});
    const float row = body.y * 5.5f + 0.25f * fold;
    const float stitch = sin_turns(body.x * 6.5f + 0.5f * std::floor(row)) *
                         sin_turns(0.5f * (row - std::floor(row)));
    SurfacePoint p;
    p.relief = 0.05f * fold + 0.016f * stitch;
    p.position = Vec3{0.0f, -2.35f, -0.25f} + body * (1.0f + p.relief);
    p.pattern = {body.x, row, 0.0f};
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    const float stripe = smooth_step(0.30f, 0.36f, std::abs(sin_turns(p.pattern.y * 0.07f)));
    Material m;
    m.albedo = mix(Vec3{0.62f, 0.50f, 0.26f}, Vec3{0.08f, 0.17f, 0.27f}, stripe);
    m.openness = saturate(0.8f + 9.0f * p.relief);
    return m;
  }
};

struct Neck {
  static constexpr Limb kLimb{{{{{0.0f, -1.9f, -0.1f}, 0.50f},
                                {{0.0f, -1.45f, -0.12f}, 0.50f},
                                {{0.0f, -1.1f, -0.12f}, 0.47f},
                                {{0.0f, -0.7f, -0.1f}, 0.47f},
                                {{0.0f, -0.2f, -0.1f}, 0.44f}}},
                              0.95f};

  static int patch_count() { return 2; }

  SurfacePoint point(int half, float u, float v) const {
    const Limb::Point at = kLimb.point(half, u, v);
    SurfacePoint p;
    p.pattern = at.centre + at.outward * at.radius;
    p.relief = 0.012f * noise(p.pattern * 4.0f) + 0.0015f * noise(p.pattern * 30.0f);
    p.position = p.pattern + at.outward * p.relief;
    return p;
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    Material m;
    m.albedo = Vec3{0.58f, 0.34f, 0.24f} * (1.0f + 4.0f * p.relief);
    m.gloss = 0.2f;
    m.sharpness = 4;
    return m;
  }
};

/// Cut on the bias: the weave runs aslant.
struct Curtain {
  static int patch_count() { return 2; }

  SurfacePoint point(int patch, float u, float v) const {
    return sheet_point(patch, u, v, {0.0f, 0.0f, 0.3f}, [](float s, float t) {
      const Vec3 at = turned_z({(s - 0.5f) * 12.0f, (t - 0.5f) * 12.0f, 0.0f}, 0.032f);
      const float x = at.x, y = at.y;
      const float sway = noise({x * 0.9f, y * 0.25f, 1.0f});
      const float weave = noise({x * 14.0f, y * 14.0f, 4.0f});
      SurfacePoint p;
      p.relief = 0.16f * sin_turns(x * 1.15f + 0.6f * sway) + 0.14f * sway + 0.006f * weave;
      p.position = {x, y, -2.6f + p.relief};
      p.pattern = {x, y, weave};
      return p;
    });
  }

  static Material material(const SurfacePoint& p, Vec3 /*normal*/) {
    Material m;
    m.albedo = Vec3{0.06f, 0.20f, 0.21f} * (1.0f + 0.25f * p.pattern.z);
    m.gloss = 0.1f;
    m.sharpness = 3;
    m.openness = saturate(0.75f + 1.1f * p.relief);
    return m;
  }
};

Scene build(int frame) {
  Scene scene;
  const float phase = static_cast<float>(frame) / kFrames;
  const float open = 0.5f - 0.5f * cos_turns(3.0f * phase);
  const float nod = 0.012f * sin_turns(phase);
  const Vec3 centre{0.0f, 0.1f, 0.0f};
  scene.camera.eye = {0.5f, 0.1f, 6.6f};
  scene.camera.target = {0.0f, -0.15f, 0.0f};
  scene.camera.field_degrees = 31.0f;
  scene.camera.near = 0.5f;
  scene.lighting.to_sun = normalized({-0.55f, 0.55f, 0.75f});
  scene.lighting.background = {0.10f, 0.16f, 0.18f};
  scene.lighting.sun = {1.5f, 1.3f, 1.1f};
  scene.lighting.sky = {0.26f, 0.30f, 0.36f};
  scene.lighting.bounce = {0.16f, 0.12f, 0.10f};
  scene.add(make_surface(Curtain{}));
  scene.add(make_surface(Shoulders{}), {{{0.0f, -2.4f, -0.3f}, 1.3f}});
  scene.add(make_surface(Neck{}));
  scene.add(make_surface(Head{centre, open, nod}), {{centre, 0.95f}});
  for (const float side : {-1.0f, 1.0f}) {
    const Vec3 socket = turned_x({side * 0.275f, 0.155f, 0.665f}, nod);
    scene.add(make_surface(Eye{centre + turned_y(socket, -0.055f)}));
  }
  return scene;
}

}  // namespace

extern const SurfaceScene s_talking = {
    .name = "talking",
    .summary = "a modelled head talks in front of a curtain",
    .default_frame = 5,
    .frame_count = kFrames,
    .build = build,
};

}  // namespace lanescope
