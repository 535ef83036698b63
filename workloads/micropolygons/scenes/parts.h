// SPDX-License-Identifier: MIT
// Bodies that several scenes use: stones, blocks, mouldings, limbs.
#pragma once

#include <array>

#include "workloads/geometry/noise.h"
#include "workloads/geometry/parametric_surface.h"
#include "workloads/geometry/shapes.h"

namespace lanescope {

/// A rounded stone.
struct Stone {
  Vec3 centre;
  float radius = 1.0f;
  Vec3 seed;  ///< Different for stones that should look different.
  Vec3 dark{0.26f, 0.27f, 0.30f};
  Vec3 light{0.55f, 0.52f, 0.48f};

  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    const Vec3 d = cube_sphere_direction(face, u, v);
    SurfacePoint p;
    p.relief = 0.28f * noise(d * 1.3f + seed) + 0.035f * fractal_noise(d * 6.0f + seed, 2);
    p.position = centre + Vec3{1.0f, 0.68f, 0.9f} * d * (radius * (1.0f + p.relief));
    p.pattern = d * 2.0f + seed;
    return p;
  }

  Material material(const SurfacePoint& p, Vec3 /*normal*/) const {
    Material m;
    const float vein = smooth_step(0.12f, 0.0f, std::abs(noise(p.pattern * 1.7f)));
    m.albedo = mix(dark, light, vein);
    m.gloss = 0.12f;
    m.sharpness = 4;
    m.openness = saturate(0.85f + p.relief);
    return m;
  }
};

/// A rough block of stone; displaced from its centre, so that its faces stay joined.
struct Block {
  Vec3 centre;
  Vec3 half_size;
  float roughness = 0.02f;  ///< Height of the displacement.
  Vec3 albedo{0.7f, 0.66f, 0.58f};

  static int patch_count() { return 6; }

  SurfacePoint point(int face, float u, float v) const {
    SurfacePoint p;
    p.position = box_point(face, u, v, centre, half_size);
    p.pattern = p.position;
    p.relief = fractal_noise(p.position * 3.0f, 3);
    p.position = p.position + normalized(p.position - centre) * (roughness * p.relief);
    return p;
  }

  Material material(const SurfacePoint& p, Vec3 /*normal*/) const {
    Material m;
    m.albedo = albedo * (0.9f + 0.25f * noise(p.pattern * 1.1f) + 0.12f * p.relief);
    m.gloss = 0.06f;
    m.sharpness = 3;
    return m;
  }
};

/// A ring lying level: a moulding of a column.
struct Moulding {
  Vec3 centre;
  float ring_radius = 1.0f;
  float tube_radius = 0.1f;
  Vec3 albedo{0.7f, 0.66f, 0.58f};

  static int patch_count() { return 4; }

  SurfacePoint point(int quarter, float u, float v) const {
    const float around = 0.25f * (static_cast<float>(quarter) + u);
    const float rough = 1.0f + 0.06f * noise({16.0f * around, 5.0f * v, centre.x + centre.z});
    const float tube = tube_radius * rough;
    const float out = ring_radius + tube * cos_turns(v);
    SurfacePoint p;
    p.position =
        centre + Vec3{out * cos_turns(around), tube * sin_turns(v), -out * sin_turns(around)};
    p.pattern = p.position;
    return p;
  }

  Material material(const SurfacePoint& p, Vec3 /*normal*/) const {
    Material m;
    m.albedo = albedo * (0.9f + 0.25f * noise(p.pattern * 1.5f));
    m.gloss = 0.1f;
    m.sharpness = 4;
    return m;
  }
};

/// The bare form of a limb: a round body about a curve in a plane of constant z, closed and rounded
/// at both ends. Scenes displace it along `outward`.
struct Limb {
  static constexpr std::size_t kJoints = 5;
  struct Joint {
    Vec3 position;
    float radius = 0.1f;
  };
  struct Point {
    Vec3 centre;   ///< On the curve.
    Vec3 outward;  ///< Unit vector.
    float radius;  ///< From the curve to the surface.
    float along;   ///< 0 at the first joint, 1 at the last.
    float around;  ///< Turns about the curve.
  };

  std::array<Joint, kJoints> joints;
  float width = 1.0f;  ///< Extent along z relative to the extent in the plane.

  Vec3 centre_at(float along) const {
    const float t = saturate(along) * (kJoints - 1);
    const auto i = std::min(static_cast<int>(t), static_cast<int>(kJoints) - 2);
    const auto at = [this](int k) {
      return joints[static_cast<std::size_t>(std::clamp(k, 0, static_cast<int>(kJoints) - 1))]
          .position;
    };
    return curve_point(at(i - 1), at(i), at(i + 1), at(i + 2), t - static_cast<float>(i));
  }

  float radius_at(float along) const {
    const float t = saturate(along) * (kJoints - 1);
    const auto i = static_cast<std::size_t>(std::min(static_cast<int>(t), int{kJoints} - 2));
    return mix(joints[i].radius, joints[i + 1].radius,
               smooth_step(0.0f, 1.0f, t - static_cast<float>(i)));
  }

  /// Half of the limb, 0 or 1, at (u, v): u around, v from the first joint to the last.
  Point point(int half, float u, float v) const {
    Point p;
    const float s = sin_turns(0.5f * v);
    const float rounding = 1.0f - (1.0f - s) * (1.0f - s) * (1.0f - s);
    p.along = 0.5f - 0.5f * cos_turns(0.5f * v);
    p.around = 0.5f * (static_cast<float>(half) + u);
    p.centre = centre_at(p.along);
    p.radius = radius_at(p.along) * rounding;
    const Vec3 ahead = normalized(centre_at(p.along + 0.02f) - centre_at(p.along - 0.02f));
    const Vec3 side{0.0f, 0.0f, width};
    p.outward = side * cos_turns(p.around) + cross(ahead, {0, 0, 1}) * sin_turns(p.around);
    return p;
  }
};

}  // namespace lanescope
