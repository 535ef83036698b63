// SPDX-License-Identifier: MIT
#include "workloads/voxels/voxel_scene.h"

#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {

const VoxelScene& find_voxel_scene(std::string_view name) {
  for (const VoxelScene* scene : voxel_scenes())
    if (scene->name == name) return *scene;
  throw InputError("--scene", "no world is called '{}'{}", name,
                   did_you_mean(name, names_of(voxel_scenes())));
}

}  // namespace lanescope
