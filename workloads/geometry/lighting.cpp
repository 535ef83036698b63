// SPDX-License-Identifier: MIT
#include "workloads/geometry/lighting.h"

namespace lanescope {
namespace {

// Shadows end at this many radii from the sphere.
constexpr float kReach = 10.0f;

struct Light {
  float sun = 1.0f;
  float sky = 1.0f;
};

/// How much sun and sky a shadower leaves at a point: the sun's shadow softens with distance, the
/// sky loses the solid angle of the sphere.
void darken(const Shadower& s, Vec3 position, Vec3 normal, Vec3 to_sun, Light& left) {
  const Vec3 to_centre = s.centre - position;
  const float radius2 = s.radius * s.radius;
  const float distance2 = std::max(dot(to_centre, to_centre), radius2);
  const float along = dot(to_centre, to_sun);
  const float aside2 = std::max(0.0f, distance2 - along * along);
  const float softness = 0.06f + 0.06f * std::max(0.0f, along) / s.radius;
  const float inner = 1.0f - softness, outer = 1.0f + softness;
  const float ends = smooth_step(kReach, 0.5f * kReach, std::sqrt(distance2 / radius2));
  if (along > 0.0f)
    left.sun *= 1.0f - ends * (1.0f - smooth_step(inner * inner, outer * outer, aside2 / radius2));
  const float facing = dot(to_centre, normal) / std::sqrt(distance2);
  left.sky *= 1.0f - 0.85f * ends * saturate(facing * 0.7f + 0.3f) * radius2 / distance2;
}

/// A film-like curve that keeps highlights from clipping, then gamma 2.
float display(float x) {
  x = std::max(x, 0.0f);
  const float film = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
  return std::sqrt(std::min(film, 1.0f));
}

}  // namespace

void Lighting::shadowers_near(const Surface* surface, Vec3 centre, float radius,
                              std::vector<Shadower>& near) const {
  near.clear();
  for (const Shadower& s : shadowers) {
    const Vec3 d = s.centre - centre;
    const float reach = s.radius * kReach + radius;
    if (s.body != surface && dot(d, d) < reach * reach) near.push_back(s);
  }
}

Vec3 Lighting::shade(const Material& material, Vec3 position, Vec3 normal, Vec3 eye,
                     std::span<const Shadower> near) const {
  const Vec3 view = eye - position;
  const float distance = length(view);
  const Vec3 to_eye = view * (1.0f / distance);
  Light left;
  for (const Shadower& s : near) darken(s, position, normal, to_sun, left);
  const float facing_sun = std::max(0.0f, dot(normal, to_sun)) * left.sun * material.openness;
  const Vec3 ambient = mix(bounce, sky, normal.y * 0.5f + 0.5f) * (left.sky * material.openness);
  Vec3 colour = material.albedo * (sun * facing_sun + ambient);

  const Vec3 half = normalized(to_sun + to_eye);
  float highlight = std::max(0.0f, dot(normal, half));
  for (int i = 0; i < material.sharpness; ++i) highlight *= highlight;
  const float grazing = 1.0f - std::max(0.0f, dot(normal, to_eye));
  const float rim = grazing * grazing * grazing;
  colour = colour + sun * (material.gloss * highlight * left.sun) +
           sky * (material.gloss * 0.5f * rim * left.sky);

  const float depth = std::max(0.0f, distance - haze_start);
  colour = mix(colour, haze, depth / (depth + haze_length));
  return {display(colour.x), display(colour.y), display(colour.z)};
}

}  // namespace lanescope
