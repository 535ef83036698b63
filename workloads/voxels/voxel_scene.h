// SPDX-License-Identifier: MIT
// The built-in worlds.
#pragma once

#include <string_view>
#include <vector>

#include "workloads/voxels/world.h"

namespace lanescope {

/// The descriptor; workloads/voxels/scenes/<name>.cpp ends in one, and the registry lists them.
struct VoxelScene {
  std::string_view name;
  std::string_view summary;
  /// The world, the same for the same size and seed. Requires a size from 16 to 256.
  World (*build)(int size_cubes, std::uint64_t seed);
};

/// Every built-in world, in the order of scenes/CMakeLists.txt.
const std::vector<const VoxelScene*>& voxel_scenes();

/// The world of that name. Throws InputError, with the nearest name, if there is none.
const VoxelScene& find_voxel_scene(std::string_view name);

}  // namespace lanescope
