// SPDX-License-Identifier: MIT
// Edges along which neighbouring triangles have different normals. Patches that curve with their
// own normals alone would part there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "workloads/geometry/mesh.h"

namespace lanescope {

/// How far the ends of the edges of a triangle lie off the tangent planes at the other ends, as
/// vectors along the normals: element 2 * e is the end of edge e, which leads from corner e to the
/// next, off the plane at its beginning; element 2 * e + 1 the beginning off the plane at the end.
/// They are what a curved patch is made of beside its corners.
using EdgeOffsets = std::array<Vec3, 6>;

/// As the triangle's own normals have them.
EdgeOffsets edge_offsets(const MeshTriangle& triangle);

/// The offsets of triangles that have such edges: there they are averages over all triangles that
/// share the edge, whatever their vertices are called in the file.
class Creases {
 public:
  explicit Creases(const std::vector<MeshTriangle>& triangles);
  /// Null if the triangle has no such edge.
  const EdgeOffsets* find(std::size_t triangle) const;

 private:
  std::vector<std::uint32_t> triangles_;  ///< Sorted.
  std::vector<EdgeOffsets> offsets_;      ///< Of those.
};

}  // namespace lanescope
