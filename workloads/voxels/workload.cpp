// SPDX-License-Identifier: MIT
#include "workloads/voxels/workload.h"

#include "workloads/voxels/options.h"
#include "workloads/voxels/vox_reader.h"
#include "workloads/voxels/voxel_scene.h"
#include "workloads/voxels/voxel_source.h"

namespace lanescope {
namespace {

constexpr std::uint64_t kDefaultSize = 48;
constexpr std::uint64_t kDefaultSeed = 1;

/// Without megacubes no share decides on them.
void resolve_megacubes(Arguments& arguments) {
  const auto options = decoded(world_parameters(), arguments);
  if (options.levels == 1)
    arguments.set("mega_fill", {});
  else if (!options.mega_fill)
    arguments.set("mega_fill", kMegaFill);
}

/// A file has neither size nor seed to choose.
void resolve(const std::string& scene, Arguments& arguments) {
  resolve_megacubes(arguments);
  if (w_voxels.is_file(scene)) {
    arguments.set("world_size", {});
    arguments.set("world_seed", {});
    return;
  }
  find_voxel_scene(scene);
  const auto options = decoded(world_parameters(), arguments);
  if (!options.size_cubes) arguments.set("world_size", kDefaultSize);
  if (!options.seed) arguments.set("world_seed", kDefaultSeed);
}

std::unique_ptr<Source> open(const std::string& name, const Arguments& arguments,
                             const OpeningProgress& progress) {
  const auto options = decoded(world_parameters(), arguments);
  auto world = std::make_shared<const World>(
      w_voxels.is_file(name)
          ? read_vox(name)
          : find_voxel_scene(name).build(options.size_cubes.value_or(kDefaultSize),
                                         options.seed.value_or(kDefaultSeed)));
  if (progress) progress(0.5);
  auto source = std::make_unique<VoxelSource>(std::move(world), options);
  if (progress) progress(1.0);
  return source;
}

double expected_work(const Arguments& arguments) {
  const double size = decoded(world_parameters(), arguments).size_cubes.value_or(kDefaultSize);
  return size * size;
}

std::vector<SceneInfo> scenes() {
  std::vector<SceneInfo> infos;
  for (const VoxelScene* scene : voxel_scenes()) infos.push_back({scene->name, scene->summary});
  return infos;
}

}  // namespace

const Workload w_voxels{
    .name = "voxels",
    .summary = "the sky that is seen from the corners of a world of cubes",
    .parameters = joined(world_parameters()),
    .counters = kWorldCounters,
    .facet = "projection",
    .scenes = scenes(),
    .file_ending = ".vox",
    .file_kind = "a world of cubes",
    .resolve = resolve,
    .open = open,
    .expected_work = expected_work,
};

}  // namespace lanescope
