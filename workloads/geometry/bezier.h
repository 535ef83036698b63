// SPDX-License-Identifier: MIT
// Bicubic Bezier patches.
#pragma once

#include <array>
#include <vector>

#include "workloads/geometry/vector.h"

namespace lanescope {

/// Values of the four cubic Bernstein polynomials, which sum to 1.
std::array<float, 4> bernstein(float t);

/// Control point (row, column) is at 4 * row + column; u runs along a row, v from row to row.
struct BezierPatch {
  std::array<Vec3, 16> control_points;

  /// Defined for all u and v; the patch proper is [0, 1] x [0, 1].
  Vec3 point(float u, float v) const;
};

/// Newell's teapot (1975): 32 patches, as modelled, with z up and the base on z = 0, oriented
/// outward.
const std::vector<BezierPatch>& teapot_patches();

}  // namespace lanescope
