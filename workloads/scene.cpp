// SPDX-License-Identifier: MIT
#include "workloads/scene.h"

#include "simulator/base/error.h"

namespace lanescope {

void Scene::add(std::unique_ptr<Surface> surface, std::vector<Shadower> shadowers) {
  for (Shadower& shadower : shadowers) {
    shadower.body = surface.get();
    lighting.shadowers.push_back(shadower);
  }
  add(std::move(surface));
}

const SceneDescriptor& find_scene(std::string_view name) {
  std::vector<std::string> names;
  for (const SceneDescriptor* scene : scenes()) {
    if (scene->name == name) return *scene;
    names.emplace_back(scene->name);
  }
  throw InputError("--scene", "no scene is called '{}'{}", name, did_you_mean(name, names));
}

}  // namespace lanescope
