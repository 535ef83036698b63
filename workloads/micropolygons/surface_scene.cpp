// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/surface_scene.h"

#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {

const SurfaceScene& find_surface_scene(std::string_view name) {
  for (const SurfaceScene* scene : surface_scenes())
    if (scene->name == name) return *scene;
  throw InputError("--scene", "no scene is called '{}'{}", name,
                   did_you_mean(name, names_of(surface_scenes())));
}

}  // namespace lanescope
