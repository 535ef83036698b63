// SPDX-License-Identifier: MIT
#include "workloads/voxels/scenes/scattered.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

World build(int size_cubes, std::uint64_t seed) { return scattered_world(size_cubes, seed, 5); }

}  // namespace

extern const VoxelScene v_scattered5 = {
    .name = "scattered5",
    .summary = "cubes filled at random, 5 of a hundred",
    .build = build,
};

}  // namespace lanescope
