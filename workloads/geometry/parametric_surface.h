// SPDX-License-Identifier: MIT
// A surface from a shape: a plain struct with a function from parameters to a point. The loops over
// a grid are here, so that a shape's functions are inlined into them.
#pragma once

#include <memory>
#include <utility>

#include "workloads/geometry/surface.h"

namespace lanescope {

/// Shape has
///   static or member int patch_count() const;
///   SurfacePoint point(int patch, float u, float v) const;
///   Material material(const SurfacePoint& point, Vec3 normal) const;
template <class Shape>
class ParametricSurface final : public Surface {
 public:
  explicit ParametricSurface(Shape shape) : shape_(std::move(shape)) {}

  int patch_count() const override { return shape_.patch_count(); }

  void evaluate(int patch, const ParameterGrid& grid, SurfacePoint* points) const override {
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        *points++ = shape_.point(patch, grid.u(column), grid.v(row));
  }

  void materials(const SurfacePoint* points, const Vec3* normals, int count,
                 Material* materials) const override {
    for (int i = 0; i < count; ++i) materials[i] = shape_.material(points[i], normals[i]);
  }

 private:
  Shape shape_;
};

template <class Shape>
std::unique_ptr<Surface> make_surface(Shape shape) {
  return std::make_unique<ParametricSurface<Shape>>(std::move(shape));
}

}  // namespace lanescope
