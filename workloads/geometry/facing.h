// SPDX-License-Identifier: MIT
// Which side of a mesh is seen.
#pragma once

#include <cstddef>

#include "workloads/geometry/camera.h"
#include "workloads/geometry/mesh.h"

namespace lanescope {

struct Facing {
  std::size_t toward = 0;  ///< Triangles that show the camera their front.
  std::size_t away = 0;    ///< Triangles that show it their back.
  /// Of what is nearest to the camera, the share that is a back, on a coarse grid; 0 if the grid
  /// misses the mesh. Half of a closed body looks away, but none of that is nearest.
  double backs_in_view = 0.0;
};

/// Requires that the mesh lies in front of the camera.
Facing facing_of(const TriangleMesh& mesh, const Camera& camera);

}  // namespace lanescope
