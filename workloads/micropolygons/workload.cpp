// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/workload.h"

#include <algorithm>

#include "workloads/micropolygons/mesh_scene.h"
#include "workloads/micropolygons/region_filter.h"
#include "workloads/micropolygons/scene_source.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

/// Complains of the value of a parameter.
[[noreturn]] void refuse(std::string_view parameter, std::string message) {
  const auto& all = w_micropolygons.parameters;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Parameter& p) { return p.name() == parameter; });
  LANESCOPE_CHECK(found != all.end(), "no parameter '{}'", parameter);
  throw ParameterError(found->words, std::move(message));
}

/// A mesh has no frames, and a built-in scene no faces.
void resolve(const std::string& scene, Arguments& arguments) {
  const auto tessellation = decoded(tessellation_parameters(), arguments);
  if (std::string problem = frame_size_problem(tessellation.width_px, tessellation.height_px,
                                               tessellation.samples_per_pixel);
      !problem.empty())
    refuse("width_px", std::move(problem));
  const auto options = decoded(scene_parameters(), arguments);
  if (w_micropolygons.is_file(scene)) {
    arguments.set("frame", {});
    if (!options.patches)
      arguments.set("mesh_patches", std::string(name_of(kMeshPatches, MeshPatches::kPn)));
    return;
  }
  const SurfaceScene& built_in = find_surface_scene(scene);
  arguments.set("mesh_patches", {});
  if (!options.frame) arguments.set("frame", static_cast<std::uint64_t>(built_in.default_frame));
  if (options.frame && *options.frame >= built_in.frame_count)
    refuse("frame", fmt::format("{} is not a frame of {}; use 0 to {}", *options.frame, scene,
                                built_in.frame_count - 1));
}

/// The share of opening a mesh that reading its file takes, about; the rest is the division into
/// segments.
constexpr double kReading = 0.3;

OpeningProgress part_of(const OpeningProgress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction) { progress(begin + fraction * (end - begin)); };
}

std::unique_ptr<Source> open(const std::string& name, const Arguments& arguments,
                             const OpeningProgress& progress) {
  const auto options = decoded(scene_parameters(), arguments);
  const bool is_mesh = w_micropolygons.is_file(name);
  Scene scene = is_mesh ? load_mesh_scene(name, options.patches.value_or(MeshPatches::kPn),
                                          part_of(progress, 0.0, kReading))
                        : find_surface_scene(name).build(options.frame.value_or(0));
  if (options.turn_degrees != 0.0f) scene.camera = scene.camera.turned(options.turn_degrees);
  return std::make_unique<SceneSource>(std::move(scene),
                                       decoded(tessellation_parameters(), arguments),
                                       part_of(progress, is_mesh ? kReading : 0.0, 1.0));
}

double expected_work(const Arguments& arguments) {
  const auto options = decoded(tessellation_parameters(), arguments);
  return static_cast<double>(options.width_px) * options.height_px * options.samples_per_pixel;
}

std::unique_ptr<RegionFilter> filter(const Region& region, const Arguments& arguments) {
  const auto options = decoded(tessellation_parameters(), arguments);
  if (region.x_px + region.width_px > options.width_px ||
      region.y_px + region.height_px > options.height_px)
    throw InputError("--region", "{},{},{}x{} is not inside the frame, which is {}x{}", region.x_px,
                     region.y_px, region.width_px, region.height_px, options.width_px,
                     options.height_px);
  return std::make_unique<PacketRegionFilter>(region, samples_per_axis(options.samples_per_pixel));
}

std::vector<SceneInfo> scenes() {
  static const auto summaries = [] {
    std::vector<std::string> texts;
    for (const SurfaceScene* scene : surface_scenes())
      texts.push_back(fmt::format("{}; frames 0 to {}", scene->summary, scene->frame_count - 1));
    return texts;
  }();
  std::vector<SceneInfo> infos;
  for (std::size_t i = 0; i < summaries.size(); ++i)
    infos.push_back({surface_scenes()[i]->name, summaries[i]});
  return infos;
}

}  // namespace

const Workload w_micropolygons{
    .name = "micropolygons",
    .summary = "triangles or quads about the size of a pixel, from a REYES tessellator",
    .parameters = joined(tessellation_parameters(), scene_parameters()),
    .counters = kTessellationCounters,
    .facet = "micropolygon",
    .scenes = scenes(),
    .file_ending = ".obj",
    .file_kind = "a mesh",
    .resolve = resolve,
    .open = open,
    .expected_work = expected_work,
    .filter = filter,
};

}  // namespace lanescope
