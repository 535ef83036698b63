// SPDX-License-Identifier: MIT
#include "workloads/geometry/scene.h"

namespace lanescope {

void Scene::add(std::unique_ptr<Surface> surface, std::vector<Shadower> shadowers) {
  for (Shadower& shadower : shadowers) {
    shadower.body = surface.get();
    lighting.shadowers.push_back(shadower);
  }
  add(std::move(surface));
}

}  // namespace lanescope
