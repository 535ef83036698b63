// SPDX-License-Identifier: MIT
// Parametrizations that scenes build their bodies on. All are oriented outward.
#pragma once

#include <array>

#include "workloads/geometry/vector.h"

namespace lanescope {

/// The axes of one face of a cube: along u, along v, and outward, u x v.
struct CubeFace {
  Vec3 u, v, out;
};

/// Faces +x, -x, +y, -y, +z, -z.
inline constexpr std::array<CubeFace, 6> kCubeFaces = {{
    {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
    {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
}};

/// A direction on the unit sphere, from one of six faces of a cube: no poles, and cells of nearly
/// equal size.
inline Vec3 cube_sphere_direction(int face, float u, float v) {
  const CubeFace& axes = kCubeFaces[static_cast<std::size_t>(face)];
  // Close to tan(pi/4 x): steps of u are steps of angle.
  const auto even_out = [](float x) { return x * (0.7854f + 0.2146f * x * x); };
  const float a = even_out(2.0f * u - 1.0f), b = even_out(2.0f * v - 1.0f);
  return normalized(axes.out + axes.u * a + axes.v * b);
}

/// A point of the surface of a box.
inline Vec3 box_point(int face, float u, float v, Vec3 centre, Vec3 half_size) {
  const CubeFace& axes = kCubeFaces[static_cast<std::size_t>(face)];
  return centre + half_size * (axes.out + axes.u * (2.0f * u - 1.0f) + axes.v * (2.0f * v - 1.0f));
}

/// A point of a thick sheet: patch 0 is the upper side, patch 1 the lower. `upper(u, v)` gives the
/// upper side; the lower lies `thickness` away, at its back. The rim between them is open: it has
/// to be out of view.
template <class Upper>
auto sheet_point(int patch, float u, float v, Vec3 thickness, Upper upper) {
  auto point = patch == 0 ? upper(u, v) : upper(1.0f - u, v);
  if (patch == 1) point.position = point.position - thickness;
  return point;
}

/// A point and a frame of axes on a curve through four points (Catmull-Rom through the middle two
/// for t in [0, 1]).
inline Vec3 curve_point(Vec3 a, Vec3 b, Vec3 c, Vec3 d, float t) {
  const Vec3 linear = (c - a) * 0.5f;
  const Vec3 square = a - b * 2.5f + c * 2.0f - d * 0.5f;
  const Vec3 cube = (d - a) * 0.5f + (b - c) * 1.5f;
  return b + (linear + (square + cube * t) * t) * t;
}

}  // namespace lanescope
