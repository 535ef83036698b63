// SPDX-License-Identifier: MIT
#include "workloads/voxels/scenes/scattered.h"
#include "workloads/voxels/voxel_scene.h"

namespace lanescope {
namespace {

World build(int size_cubes, std::uint64_t seed) { return scattered_world(size_cubes, seed, 60); }

}  // namespace

extern const VoxelScene v_scattered60 = {
    .name = "scattered60",
    .summary = "cubes filled at random, 60 of a hundred",
    .build = build,
};

}  // namespace lanescope
