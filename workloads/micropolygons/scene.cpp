// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/scene.h"

#include "simulator/base/error.h"

namespace lanescope {

const SceneDescriptor& find_scene(std::string_view name) {
  std::vector<std::string> names;
  for (const SceneDescriptor* scene : scenes()) {
    if (scene->name == name) return *scene;
    names.emplace_back(scene->name);
  }
  throw InputError("--scene", "no scene is called '{}'{}", name, did_you_mean(name, names));
}

}  // namespace lanescope
