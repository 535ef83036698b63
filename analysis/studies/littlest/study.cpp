// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/study.h"

#include <algorithm>

#include "analysis/studies/littlest/figures.h"

namespace lanescope {
namespace {

constexpr std::string_view kKernels[] = {"across_image", "across_cubes", "across_cameras",
                                         "repacked_cameras", "sky_error"};
constexpr std::string_view kProjections[] = {"faces", "directions"};
constexpr std::string_view kWidths[] = {"8", "16", "24", "32", "64"};
/// Small worlds: they are as varied, and all runs take less than a minute.
constexpr std::string_view kSizes[] = {"24"};
/// A piece of each world is observed: pieces are few and alike.
constexpr std::string_view kObserved[] = {"64"};
constexpr Study::Axis kAxes[] = {{"world_size", kSizes},
                                 {"projection", kProjections},
                                 {"observe_every", kObserved},
                                 {"width_lanes", kWidths}};
constexpr std::string_view kWorlds[] = {"hills", "caves", "town", "stones"};

bool is_about(const Report& report) {
  return std::any_of(report.runs.begin(), report.runs.end(), [](const RunRecord& run) {
    return littlest::is_program(run) || run.configuration.kernel == littlest::kSkyError;
  });
}

}  // namespace

extern const Study study_littlest{
    .name = "littlest",
    .summary =
        "The Littlest CPU Rasterizer (blog post, 2013): one-bit cubemaps of voxels as "
        "vector programs, and spherical harmonics of the sky",
    .kernels = kKernels,
    .axes = kAxes,
    .scene_group = "worlds",
    .scenes = kWorlds,
    .tables = littlest_tables,
    .sections = littlest_sections,
    .is_about = is_about,
    .figures = nullptr,
};

}  // namespace lanescope
