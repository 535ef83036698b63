// SPDX-License-Identifier: MIT
// How a vertex gets its colour: a sun, a sky, a little haze, and round bodies that cast shadows.
#pragma once

#include <span>
#include <vector>

#include "workloads/geometry/vector.h"

namespace lanescope {

/// What a surface is made of at a point; colours are linear.
struct Material {
  Vec3 albedo{0.5f, 0.5f, 0.5f};
  float gloss = 0.0f;     ///< Strength of the highlight, 0 for matte.
  int sharpness = 5;      ///< The highlight's exponent is 2 to this power.
  float openness = 1.0f;  ///< Share of the sky that reaches the point: less in furrows.
};

class Surface;

/// A sphere that casts shadows, standing in for a body.
struct Shadower {
  Vec3 centre;
  float radius = 0.0f;
  /// The body, on which it casts none: the angle to the light shades it already.
  const Surface* body = nullptr;
};

/// Colours of light are linear; 1 is the brightness of a white wall in the sun.
struct Lighting {
  Vec3 to_sun{0.4f, 0.8f, 0.45f};
  Vec3 sun{1.0f, 0.95f, 0.85f};
  Vec3 sky{0.30f, 0.38f, 0.52f};     ///< Light from above.
  Vec3 bounce{0.16f, 0.13f, 0.10f};  ///< Light from below.
  /// As displayed, each channel in [0, 1]: what samples without a surface show.
  Vec3 background{0.70f, 0.78f, 0.88f};
  Vec3 haze{0.6f, 0.7f, 0.85f};
  float haze_start = 1e9f;   ///< Distance from the camera where haze begins.
  float haze_length = 1.0f;  ///< Distance over which haze grows to one half.
  std::vector<Shadower> shadowers;

  /// Writes to `near` the shadowers that may darken points of `surface` within a sphere.
  void shadowers_near(const Surface* surface, Vec3 centre, float radius,
                      std::vector<Shadower>& near) const;

  /// The colour, as displayed (gamma 2, each channel in [0, 1]), of a point seen from `eye` and
  /// shadowed by `near`. Requires a unit normal.
  Vec3 shade(const Material& material, Vec3 position, Vec3 normal, Vec3 eye,
             std::span<const Shadower> near) const;
};

}  // namespace lanescope
