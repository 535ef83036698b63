// SPDX-License-Identifier: MIT
// The contract of a scene: a name, a sentence, and a function from a frame number to surfaces, a
// camera and lights.
#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "workloads/camera.h"
#include "workloads/surface.h"

namespace lanescope {

struct Scene {
  Camera camera;
  Lighting lighting;
  std::vector<std::unique_ptr<Surface>> surfaces;

  /// Adds a surface.
  void add(std::unique_ptr<Surface> surface) { surfaces.push_back(std::move(surface)); }
  /// Adds a surface for which spheres cast shadows on the others.
  void add(std::unique_ptr<Surface> surface, std::vector<Shadower> shadowers);
};

/// A built-in scene; workloads/scenes/<name>.cpp ends in one, and the registry lists them.
struct SceneDescriptor {
  std::string_view name;
  std::string_view summary;
  /// One of the four of the thesis's character, over which its tables are averaged.
  bool thesis_like;
  int default_frame;
  int frame_count;  ///< Frames of the animation; build() takes 0 to frame_count - 1.
  Scene (*build)(int frame);
};

/// Every built-in scene, in the order of workloads/scenes/CMakeLists.txt.
const std::vector<const SceneDescriptor*>& scenes();

/// The scene of that name. Throws InputError, with the nearest name, if there is none.
const SceneDescriptor& find_scene(std::string_view name);

}  // namespace lanescope
