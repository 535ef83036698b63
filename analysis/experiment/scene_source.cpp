// SPDX-License-Identifier: MIT
#include "analysis/experiment/scene_source.h"

namespace lanescope {

Scene build_scene(const Configuration& configuration) {
  Scene scene = configuration.is_mesh()
                    ? load_mesh_scene(configuration.scene, *configuration.mesh_patches)
                    : find_scene(configuration.scene).build(configuration.frame);
  if (configuration.turn_degrees != 0.0f)
    scene.camera = scene.camera.turned(configuration.turn_degrees);
  return scene;
}

bool is_thesis_like(const Configuration& configuration) {
  return !configuration.is_mesh() && find_scene(configuration.scene).thesis_like;
}

}  // namespace lanescope
