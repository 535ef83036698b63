// SPDX-License-Identifier: MIT
// What there is to see: surfaces, a camera and lights.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "workloads/geometry/camera.h"
#include "workloads/geometry/surface.h"

namespace lanescope {

struct Scene {
  Camera camera;
  Lighting lighting;
  std::vector<std::unique_ptr<Surface>> surfaces;
  std::vector<std::string> notes;  ///< As Source::notes has them.

  /// Adds a surface.
  void add(std::unique_ptr<Surface> surface) { surfaces.push_back(std::move(surface)); }
  /// Adds a surface for which spheres cast shadows on the others.
  void add(std::unique_ptr<Surface> surface, std::vector<Shadower> shadowers);
};

}  // namespace lanescope
