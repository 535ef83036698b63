// SPDX-License-Identifier: MIT
// Dicing: a patch becomes a grid of shaded vertices on the frame.
#pragma once

#include <cstdint>
#include <vector>

#include "workloads/geometry/camera.h"
#include "workloads/geometry/lighting.h"
#include "workloads/micropolygons/micropolygon.h"
#include "workloads/micropolygons/patch.h"

namespace lanescope {

/// How far, in pixels, the outer vertices of every grid are moved outward: the grids of
/// neighbouring patches, which may have different rates, overlap instead of leaving cracks.
inline constexpr float kGridOverlapPx = 1.0f / 16.0f;

/// Vertices farther than this from the origin of the frame are not exact on the sub-pixel grid in
/// single precision; micropolygons with such vertices are dropped.
inline constexpr float kMaxCoordinateCells = 32768.0f;

/// A grid of columns x rows quads and the memory for it, used again from grid to grid.
class Grid {
 public:
  /// Vertices come out in cells, `cells_per_px` to a pixel along x and y. No outward move if
  /// `overlap_px` is 0. `projection` and `lighting` must outlive the grid.
  Grid(const Projection& projection, const Lighting& lighting, int cells_per_px, float overlap_px)
      : projection_(projection),
        lighting_(lighting),
        cells_per_px_(static_cast<float>(cells_per_px)),
        overlap_px_(overlap_px) {}

  /// Evaluates, shades and projects a patch. Requires columns > 0 and rows > 0.
  void dice(const Patch& patch, int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// Vertex (column, row), 0 <= column <= columns(), 0 <= row <= rows().
  const Vertex& vertex(int column, int row) const { return vertices_[index(column, row)]; }
  /// Finite, in front of the camera and within kMaxCoordinateCells.
  bool valid(int column, int row) const { return valid_[index(column, row)] != 0; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row * (columns_ + 1) + column);
  }
  void evaluate(const Patch& patch);
  void take_normals_from_differences(const std::vector<SurfacePoint>& ringed);
  void fill_degenerate_normals();
  void shade(const Surface* surface);
  void project();
  void extend_edges();
  void extend(std::size_t outer, std::size_t inner);
  void snap();

  const Projection& projection_;
  const Lighting& lighting_;
  float cells_per_px_;
  float overlap_px_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<SurfacePoint> ringed_;  ///< With a ring of points around the grid, for normals.
  std::vector<SurfacePoint> points_;
  std::vector<Vec3> normals_;
  std::vector<Material> materials_;
  std::vector<Shadower> shadowers_;  ///< Of those of the lighting, the ones near.
  std::vector<Vertex> vertices_;
  std::vector<std::uint8_t> valid_;
};

}  // namespace lanescope
