// SPDX-License-Identifier: MIT
#include "workloads/geometry/bezier.h"

#include <cstddef>

namespace lanescope {
namespace {

#include "workloads/geometry/teapot_patches.inc"

std::vector<BezierPatch> make_teapot_patches() {
  std::vector<BezierPatch> patches;
  for (const auto& indices : kTeapotPatches) {
    BezierPatch& patch = patches.emplace_back();
    for (std::size_t i = 0; i < 16; ++i) patch.control_points[i] = kTeapotPoints[indices[i]];
  }
  return patches;
}

}  // namespace

std::array<float, 4> bernstein(float t) {
  const float s = 1.0f - t;
  return {s * s * s, 3.0f * s * s * t, 3.0f * s * t * t, t * t * t};
}

Vec3 BezierPatch::point(float u, float v) const {
  const std::array<float, 4> bu = bernstein(u), bv = bernstein(v);
  Vec3 sum;
  for (std::size_t row = 0; row < 4; ++row) {
    const Vec3* p = &control_points[4 * row];
    sum = sum + (p[0] * bu[0] + p[1] * bu[1] + p[2] * bu[2] + p[3] * bu[3]) * bv[row];
  }
  return sum;
}

const std::vector<BezierPatch>& teapot_patches() {
  static const std::vector<BezierPatch> patches = make_teapot_patches();
  return patches;
}

}  // namespace lanescope
