// SPDX-License-Identifier: MIT
// The contract of a surface: patches over the unit square, evaluated a grid at a time.
#pragma once

#include "workloads/geometry/lighting.h"
#include "workloads/geometry/vector.h"

namespace lanescope {

/// Parameters of a grid of points: columns run along u, rows along v. Point (column, row) is at
/// index row * columns + column.
struct ParameterGrid {
  float u0 = 0.0f, v0 = 0.0f;  ///< Parameters of column 0 and row 0.
  float du = 1.0f, dv = 1.0f;  ///< Steps.
  int columns = 0;
  int rows = 0;

  float u(int column) const { return u0 + du * static_cast<float>(column); }
  float v(int row) const { return v0 + dv * static_cast<float>(row); }
  int size() const { return columns * rows; }
};

/// A point of a surface in world space, and what its material is found from.
struct SurfacePoint {
  Vec3 position;
  Vec3 pattern;         ///< Where the point is in the material's own coordinates.
  float relief = 0.0f;  ///< Displacement, 0 at the undisplaced surface.
};

/// One or more patches, each over u and v in [0, 1]. The front of a surface is where
/// dP/du x dP/dv points; closed bodies are oriented outward. Implementations are immutable.
class Surface {
 public:
  virtual ~Surface() = default;

  virtual int patch_count() const { return 1; }

  /// Writes the points of a grid of one patch to points[grid.size()]. Parameters may lie a step or
  /// two outside of [0, 1], where the patch goes on smoothly (normals are taken from neighbouring
  /// points).
  virtual void evaluate(int patch, const ParameterGrid& grid, SurfacePoint* points) const = 0;

  /// Writes unit normals of the same points and returns true, or returns false: the normals are
  /// then taken from differences of the points.
  virtual bool evaluate_normals(int /*patch*/, const ParameterGrid& /*grid*/,
                                Vec3* /*normals*/) const {
    return false;
  }

  /// Writes what the surface is made of at `count` points with unit normals.
  virtual void materials(const SurfacePoint* points, const Vec3* normals, int count,
                         Material* materials) const = 0;
};

}  // namespace lanescope
