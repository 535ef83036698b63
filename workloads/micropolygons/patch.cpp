// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/patch.h"

#include <array>
#include <cmath>

namespace lanescope {
namespace {

constexpr int kCells = 4;
constexpr int kSide = kCells + 1;
constexpr int kPoints = kSide * kSide;

// Points between the probed ones may lie further out by this share of the patch's size; split
// patches of a curved or displaced surface stay well below it.
constexpr float kBulge = 0.125f;

using CameraPoints = std::array<CameraPoint, kPoints>;

struct Extent {
  float low = INFINITY;
  float high = -INFINITY;
  void add(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  float size() const { return high - low; }
};

/// The patch lies outside if all of its points do, by a margin, for one side of the view.
bool is_outside(const CameraPoints& points, const Projection& projection) {
  const float w = projection.half_width(), h = projection.half_height();
  Extent x, y, z, left, right, top, bottom;
  for (const CameraPoint& p : points) {
    x.add(p.x), y.add(p.y), z.add(p.z);
    left.add(p.x + w * p.z), right.add(w * p.z - p.x);
    top.add(p.y + h * p.z), bottom.add(h * p.z - p.y);
  }
  const float bulge = kBulge * std::max({x.size(), y.size(), z.size()});
  if (z.high + bulge < projection.near()) return true;
  const float side_bulge = bulge * std::sqrt(1.0f + w * w);
  const float height_bulge = bulge * std::sqrt(1.0f + h * h);
  return left.high < -side_bulge || right.high < -side_bulge || top.high < -height_bulge ||
         bottom.high < -height_bulge;
}

/// Sum of the lengths of the polylines that lead along u (stride 1) or along v (stride kSide).
template <class Distance>
float summed_length(int stride, Distance distance) {
  float sum = 0.0f;
  for (int line = 0; line < kSide; ++line)
    for (int step = 0; step < kCells; ++step) {
      const int from = stride == 1 ? line * kSide + step : step * kSide + line;
      sum += distance(from, from + stride);
    }
  return sum;
}

void measure_in_world(const CameraPoints& points, PatchProbe& result) {
  const auto distance = [&](int a, int b) {
    const CameraPoint &p = points[static_cast<std::size_t>(a)],
                      &q = points[static_cast<std::size_t>(b)];
    const float d = length(Vec3{p.x - q.x, p.y - q.y, p.z - q.z});
    return std::isfinite(d) ? d : 0.0f;
  };
  result.length_u = summed_length(1, distance) / kSide;
  result.length_v = summed_length(kSide, distance) / kSide;
}

void measure_on_frame(const CameraPoints& points, const Projection& projection,
                      PatchProbe& result) {
  std::array<float, kPoints> x, y;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const FramePoint p = projection.to_frame(points[i]);
    x[i] = p.x_px;
    y[i] = p.y_px;
  }
  const auto distance = [&](int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const float dx = x[j] - x[i], dy = y[j] - y[i];
    return std::sqrt(dx * dx + dy * dy);
  };
  result.length_u = summed_length(1, distance) / kSide;
  result.length_v = summed_length(kSide, distance) / kSide;
  for (int row = 0; row < kCells; ++row)
    for (int column = 0; column < kCells; ++column) {
      const auto i = static_cast<std::size_t>(row * kSide + column);
      const std::size_t j = i + kSide;
      const float twice =
          (x[j + 1] - x[i]) * (y[j] - y[i + 1]) - (y[j + 1] - y[i]) * (x[j] - x[i + 1]);
      result.area_px += 0.5f * std::abs(twice);
    }
}

}  // namespace

std::pair<Patch, Patch> Patch::halves(bool along_u) const {
  Patch low = *this, high = *this;
  low.depth = high.depth = depth + 1;
  if (along_u)
    low.u1 = high.u0 = 0.5f * (u0 + u1);
  else
    low.v1 = high.v0 = 0.5f * (v0 + v1);
  return {low, high};
}

PatchProbe probe(const Patch& patch, const Projection& projection) {
  const ParameterGrid grid{
      patch.u0, patch.v0, (patch.u1 - patch.u0) / kCells, (patch.v1 - patch.v0) / kCells,
      kSide,    kSide};
  std::array<SurfacePoint, kPoints> surface_points;
  patch.surface->evaluate(patch.index, grid, surface_points.data());

  CameraPoints points;
  int finite = 0;
  bool in_front = true;
  for (std::size_t i = 0; i < kPoints; ++i) {
    points[i] = projection.to_camera(surface_points[i].position);
    const CameraPoint& p = points[i];
    finite += is_finite({p.x, p.y, p.z}) ? 1 : 0;
    in_front = in_front && p.z >= projection.near();
  }
  PatchProbe result;
  if (finite == 0) {
    result.place = PatchProbe::Place::kNotFinite;
  } else if (finite == kPoints && is_outside(points, projection)) {
    result.place = PatchProbe::Place::kOutside;
  } else if (finite < kPoints || !in_front) {
    result.place = finite < kPoints ? PatchProbe::Place::kBroken : PatchProbe::Place::kCrossing;
    measure_in_world(points, result);
  } else {
    result.place = PatchProbe::Place::kInside;
    measure_on_frame(points, projection, result);
  }
  return result;
}

}  // namespace lanescope
