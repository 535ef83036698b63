// SPDX-License-Identifier: MIT
// A rectangle of a surface's parameters, and what the tessellator has to know of it: is it in view,
// and how many pixels does it cover?
#pragma once

#include <utility>

#include "workloads/geometry/camera.h"
#include "workloads/geometry/surface.h"

namespace lanescope {

struct Patch {
  const Surface* surface = nullptr;
  int index = 0;  ///< Which of the surface's patches.
  float u0 = 0.0f, u1 = 1.0f;
  float v0 = 0.0f, v1 = 1.0f;
  int depth = 0;  ///< Number of splits that led here.

  /// The two halves across u (`along_u`) or across v.
  std::pair<Patch, Patch> halves(bool along_u) const;
};

/// What a patch looks like from the camera, found from a few of its points.
struct PatchProbe {
  enum class Place {
    kOutside,    ///< Wholly outside of the view.
    kCrossing,   ///< Partly behind the camera.
    kBroken,     ///< Partly not finite.
    kInside,     ///< In front of the camera and at least partly in view.
    kNotFinite,  ///< No point of it is finite.
  };
  Place place = Place::kOutside;
  /// Lengths of the patch along u and v: in pixels if it is inside, else in world units.
  float length_u = 0.0f;
  float length_v = 0.0f;
  float area_px = 0.0f;  ///< Projected area, front and back counted alike; 0 unless inside.
};

/// Requires `patch` to lie within [0, 1] x [0, 1].
PatchProbe probe(const Patch& patch, const Projection& projection);

}  // namespace lanescope
