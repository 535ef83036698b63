// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/study.h"

#include <algorithm>

#include "analysis/studies/luong/thesis_json.h"

namespace lanescope {
namespace {

constexpr std::string_view kKernels[] = {"lockstep", "repack"};
constexpr std::string_view kMicropolygons[] = {"triangle", "quad"};
constexpr std::string_view kWidths[] = {"8", "16", "32", "64"};
constexpr Study::Axis kAxes[] = {{"micropolygon", kMicropolygons}, {"width_lanes", kWidths}};
/// Stand in for the thesis's, which were never published.
constexpr std::string_view kScenes[] = {"ballroll", "columnpivot", "tigerjump", "talking"};

bool is_about(const Report& report) {
  return std::any_of(report.runs.begin(), report.runs.end(), [](const RunRecord& run) {
    return !run.stages.empty() && std::find(std::begin(kKernels), std::end(kKernels),
                                            run.configuration.kernel) != std::end(kKernels);
  });
}

}  // namespace

extern const Study study_luong{
    .name = "luong",
    .summary =
        "Luong, Data-Parallel Rasterization of Micropolygons (2010): LOCKSTEP and REPACK, "
        "tables 4.1 to 4.6",
    .kernels = kKernels,
    .axes = kAxes,
    .scene_group = "thesis",
    .scenes = kScenes,
    .tables = luong_tables,
    .sections = luong_sections,
    .is_about = is_about,
    .figures = luong::thesis_json,
};

}  // namespace lanescope
