// SPDX-License-Identifier: MIT
#include "workloads/voxels/scenes/scattered.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

World build(int size_cubes, std::uint64_t seed) { return scattered_world(size_cubes, seed, 1); }

}  // namespace

extern const VoxelScene v_scattered1 = {
    .name = "scattered1",
    .summary = "cubes filled at random, 1 of a hundred",
    .build = build,
};

}  // namespace lanescope
