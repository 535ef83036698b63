// SPDX-License-Identifier: MIT
#include "workloads/geometry/facing.h"

#include <algorithm>
#include <cmath>

namespace lanescope {
namespace {

/// Negative if counterclockwise as seen, where y is down: then the front shows.
float twice_area_of(const FramePoint& a, const FramePoint& b, const FramePoint& c) {
  return (b.x_px - a.x_px) * (c.y_px - a.y_px) - (b.y_px - a.y_px) * (c.x_px - a.x_px);
}

/// Keeps the nearest triangle at the middle of every cell.
class NearestSides {
 public:
  static constexpr int kSide = 128;

  void add(const std::array<FramePoint, 3>& t, float twice_area) {
    const auto [left, right] = std::minmax({t[0].x_px, t[1].x_px, t[2].x_px});
    const auto [top, bottom] = std::minmax({t[0].y_px, t[1].y_px, t[2].y_px});
    for (int y = first(top); y <= last(bottom); ++y)
      for (int x = first(left); x <= last(right); ++x) add_at(t, twice_area, x, y);
  }

  double share_of_backs() const {
    std::size_t seen = 0, backs = 0;
    for (const Cell& cell : cells_) {
      if (cell.depth < 1.0f) ++seen;
      if (cell.is_back) ++backs;
    }
    return seen == 0 ? 0.0 : static_cast<double>(backs) / static_cast<double>(seen);
  }

 private:
  struct Cell {
    float depth = 1.0f;
    bool is_back = false;
  };

  /// The first and the last cell whose middle lies between two coordinates.
  static int first(float low) {
    return static_cast<int>(std::ceil(std::clamp(low, 0.0f, 1.0f * kSide) - 0.5f));
  }
  static int last(float high) {
    return static_cast<int>(std::floor(std::clamp(high, 0.0f, 1.0f * kSide) - 0.5f));
  }

  void add_at(const std::array<FramePoint, 3>& t, float twice_area, int x, int y) {
    const FramePoint p{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0.0f};
    float depth = 0.0f;
    for (std::size_t i = 0; i < 3; ++i) {
      const float weight = twice_area_of(p, t[(i + 1) % 3], t[(i + 2) % 3]) / twice_area;
      if (!(weight >= 0.0f)) return;
      depth += weight * t[i].depth;
    }
    Cell& cell = cells_[static_cast<std::size_t>(y * kSide + x)];
    if (depth < cell.depth) cell = {depth, twice_area > 0.0f};
  }

  std::vector<Cell> cells_{static_cast<std::size_t>(kSide) * kSide};
};

}  // namespace

Facing facing_of(const TriangleMesh& mesh, const Camera& camera) {
  const Projection projection = camera.projection(NearestSides::kSide, NearestSides::kSide);
  NearestSides nearest;
  Facing facing;
  for (const MeshTriangle& triangle : mesh.triangles) {
    std::array<FramePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = projection.to_frame(projection.to_camera(triangle[i].position));
    const float twice_area = twice_area_of(corners[0], corners[1], corners[2]);
    if (twice_area < 0.0f) ++facing.toward;
    if (twice_area > 0.0f) ++facing.away;
    if (twice_area != 0.0f) nearest.add(corners, twice_area);
  }
  facing.backs_in_view = nearest.share_of_backs();
  return facing;
}

}  // namespace lanescope
