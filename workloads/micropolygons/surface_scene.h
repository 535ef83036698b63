// SPDX-License-Identifier: MIT
// The contract of a scene: a name, a sentence, and a function from a frame number to surfaces, a
// camera and lights.
#pragma once

#include <string_view>
#include <vector>

#include "workloads/geometry/scene.h"

namespace lanescope {

/// A built-in scene; workloads/micropolygons/scenes/<name>.cpp ends in one, and the registry lists
/// them.
struct SurfaceScene {
  std::string_view name;
  std::string_view summary;
  int default_frame;
  int frame_count;  ///< Frames of the animation; build() takes 0 to frame_count - 1.
  Scene (*build)(int frame);
};

/// Every built-in scene, in the order of workloads/micropolygons/scenes/CMakeLists.txt.
const std::vector<const SurfaceScene*>& surface_scenes();

/// The scene of that name. Throws InputError, with the nearest name, if there is none.
const SurfaceScene& find_surface_scene(std::string_view name);

}  // namespace lanescope
