// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/figures.h"

#include <algorithm>
#include <cmath>

namespace lanescope::littlest {
namespace {

constexpr std::string_view kWorkload = "voxels";
constexpr std::string_view kOctants = "octants_rendered";
/// Of the squares that sky_error counts.
constexpr double kErrorUnit = 1e-9;
/// `scattered20` is filled to 20 percent.
constexpr std::string_view kScattered = "scattered";

std::optional<double> over_octants(const RunRecord& run, std::uint64_t issued) {
  const auto octants = run.counter(kOctants);
  if (!octants || *octants == 0 || run.stages.empty()) return std::nullopt;
  return static_cast<double>(issued) / static_cast<double>(*octants);
}

}  // namespace

bool is_program(const RunRecord& run) { return run.workload == kWorkload && !run.stages.empty(); }

std::vector<Series> programs_of(const Report& report) {
  std::vector<Series> programs;
  const ReportView view(report);
  for (const Series& series : series_of(report))
    if (const RunRecord* run = view.find_any(series); run && is_program(*run))
      programs.push_back(series);
  return programs;
}

std::vector<Series> programs_of(const Report& report, std::string_view projection) {
  std::vector<Series> programs = programs_of(report);
  std::erase_if(programs, [&](const Series& series) { return series.facet != projection; });
  return programs;
}

std::optional<double> per_octant(const RunRecord& run) {
  return over_octants(run, total(run).issued);
}

std::optional<double> per_octant(const ReportView& view, const Series& series, int width) {
  return view.mean(series, width, [](const RunRecord& run) { return per_octant(run); });
}

std::optional<double> stage_per_octant(const ReportView& view, const Series& series,
                                       std::string_view stage, int width) {
  return view.mean(series, width, [&](const RunRecord& run) -> std::optional<double> {
    const StageRecord* const record = run.stage(stage);
    if (!record) return std::nullopt;
    return over_octants(run, record->total().issued);
  });
}

std::vector<Filled> filled_scenes(const Report& report) {
  std::vector<Filled> filled;
  for (const std::string& scene : scenes_of(report)) {
    if (!scene.starts_with(kScattered)) continue;
    const std::string percent = scene.substr(kScattered.size());
    if (percent.empty() || percent.find_first_not_of("0123456789") != std::string::npos) continue;
    filled.push_back({scene, std::atof(percent.c_str()) / 100});
  }
  std::sort(filled.begin(), filled.end(),
            [](const Filled& a, const Filled& b) { return a.share < b.share; });
  return filled;
}

std::vector<std::string> scenes_and_filled(const ReportView& view) {
  std::vector<std::string> scenes = view.scenes();
  for (const Filled& filled : filled_scenes(view.report()))
    if (std::find(scenes.begin(), scenes.end(), filled.scene) == scenes.end())
      scenes.push_back(filled.scene);
  return scenes;
}

std::optional<Winner> winner(const ReportView& scene, std::string_view projection, int width) {
  std::optional<Winner> best;
  const std::vector<Series> programs = programs_of(scene.report(), projection);
  if (programs.size() < 2) return std::nullopt;
  for (const Series& series : programs) {
    const auto cost = per_octant(scene, series, width);
    if (!cost) return std::nullopt;
    if (!best || *cost < best->per_octant) best = Winner{series, *cost};
  }
  return best;
}

std::optional<double> root_mean_square(const ReportView& view, std::string_view projection,
                                       std::string_view counter, std::string_view count) {
  const Series series{std::string(kSkyError), std::string(projection)};
  const std::vector<int> widths = view.widths(series);
  if (widths.empty()) return std::nullopt;
  const auto mean = mean_counter_ratio(view, series, widths.front(), counter, count);
  if (!mean) return std::nullopt;
  return std::sqrt(*mean * kErrorUnit);
}

}  // namespace lanescope::littlest
