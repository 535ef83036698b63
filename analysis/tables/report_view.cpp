// SPDX-License-Identifier: MIT
#include "analysis/tables/report_view.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "analysis/tables/thesis.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

void check_distinct_runs(const Report& report) {
  std::set<std::tuple<std::string, std::string, int, Micropolygon>> seen;
  for (const RunRecord& run : report.runs) {
    const Configuration& c = run.configuration;
    if (!seen.emplace(c.kernel, c.scene, c.width, c.shape()).second)
      throw InputError("report", "has two runs of {} on {}, W = {}, {}; a table needs one",
                       c.kernel, c.scene, c.width, to_string(c.shape()));
  }
}

template <class FindRun>
std::optional<double> mean_over(const std::vector<std::string>& scenes, const FindRun& find,
                                const RunFigure& figure) {
  double sum = 0.0;
  for (const std::string& scene : scenes) {
    const RunRecord* run = find(scene);
    const auto value = run ? figure(*run) : std::nullopt;
    if (!value) return std::nullopt;
    sum += *value;
  }
  if (scenes.empty()) return std::nullopt;
  return sum / static_cast<double>(scenes.size());
}

}  // namespace

std::vector<std::string> scenes_of(const Report& report) {
  std::vector<std::string> scenes;
  for (const RunRecord& run : report.runs)
    if (std::find(scenes.begin(), scenes.end(), run.configuration.scene) == scenes.end())
      scenes.push_back(run.configuration.scene);
  return scenes;
}

ReportView::ReportView(const Report& report) : report_(&report) {
  check_distinct_runs(report);
  for (const std::string& scene : scenes_of(report))
    if (std::any_of(report.runs.begin(), report.runs.end(), [&](const RunRecord& run) {
          return run.thesis_like && run.configuration.scene == scene;
        }))
      scenes_.push_back(scene);
  if (scenes_.empty()) scenes_ = scenes_of(report);
}

ReportView::ReportView(const Report& report, const std::string& scene)
    : report_(&report), scenes_{scene} {
  check_distinct_runs(report);
  const std::vector<std::string> known = scenes_of(report);
  if (std::find(known.begin(), known.end(), scene) == known.end())
    throw InputError("report", "has no run of the scene '{}'{}", scene, did_you_mean(scene, known));
}

std::string ReportView::caption() const {
  if (scenes_.size() == 1) return scenes_.front();
  if (scenes_.empty()) return "no scenes";
  return fmt::format("mean of {}", fmt::join(scenes_, ", "));
}

const RunRecord* ReportView::find(const Series& series, std::string_view scene, int width) const {
  for (const RunRecord& run : report_->runs) {
    const Configuration& c = run.configuration;
    if (c.kernel == series.kernel && c.scene == scene && c.width == width &&
        c.shape() == series.shape)
      return &run;
  }
  return nullptr;
}

const RunRecord* ReportView::find_any(std::string_view scene, Micropolygon shape) const {
  for (const RunRecord& run : report_->runs)
    if (run.configuration.scene == scene && run.configuration.shape() == shape) return &run;
  return nullptr;
}

std::vector<int> ReportView::widths(const Series& series) const {
  std::set<int> widths;
  for (const RunRecord& run : report_->runs)
    if (run.configuration.kernel == series.kernel && run.configuration.shape() == series.shape)
      widths.insert(run.configuration.width);
  if (widths.empty()) return {kThesisWidths.begin(), kThesisWidths.end()};
  return {widths.begin(), widths.end()};
}

std::optional<double> ReportView::mean(const Series& series, int width,
                                       const RunFigure& figure) const {
  return mean_over(
      scenes_, [&](const std::string& scene) { return find(series, scene, width); }, figure);
}

std::optional<double> ReportView::mean(Micropolygon shape, const RunFigure& figure) const {
  return mean_over(
      scenes_, [&](const std::string& scene) { return find_any(scene, shape); }, figure);
}

}  // namespace lanescope
