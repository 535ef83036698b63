// SPDX-License-Identifier: MIT
#include "analysis/tables/report_view.h"

#include <algorithm>

#include "analysis/configuration/special_options.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

bool has(const std::vector<std::string>& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// `edges (inline, precomputed)`, for each parameter that differs.
std::string differences(const Configuration& a, const Configuration& b) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : all_values(a).all())
    if (const Value other = value_of(b, name); other != value)
      texts.push_back(fmt::format("{} ({}, {})", name, value_text(value), value_text(other)));
  return fmt::format("{}", fmt::join(texts, " and "));
}

[[noreturn]] void fail_for_two_runs(const Configuration& a, const Configuration& b) {
  const std::string differ = differences(a, b);
  throw InputError("report", "has two runs of {} on {} at W = {} that {}; a table needs one",
                   a.kernel, a.scene, a.width,
                   differ.empty() ? "have the same parameters" : "differ in " + differ);
}

/// The place of a facet among the choices of its parameter, or behind them.
std::size_t place_of_facet(const Series& series) {
  const Parameter* const parameter = find_parameter(facet_name(series.kernel));
  if (!parameter) return 0;
  const auto& choices = parameter->choices;
  return static_cast<std::size_t>(std::find(choices.begin(), choices.end(), series.facet) -
                                  choices.begin());
}

/// The widths of some runs, ascending.
template <class Predicate>
std::vector<int> widths_where(const Report& report, const Predicate& predicate) {
  std::set<int> widths;
  for (const RunRecord& run : report.runs)
    if (predicate(run)) widths.insert(run.configuration.width);
  return {widths.begin(), widths.end()};
}

}  // namespace

ReportView::ReportView(const Report& report) : ReportView(report, scenes_of(report)) {}

ReportView::ReportView(const Report& report, const std::vector<std::string>& scenes)
    : report_(&report), scenes_(scenes) {
  for (const RunRecord& run : report.runs) {
    const Configuration& c = run.configuration;
    const auto [place, is_new] =
        runs_.emplace(Place{{c.kernel, facet_of(c)}, c.scene, c.width}, &run);
    if (!is_new) fail_for_two_runs(place->second->configuration, c);
    scenes_of_work_[run.workload].insert(c.scene);
  }
  const std::vector<std::string> known = scenes_of(report);
  for (const std::string& scene : scenes)
    if (!has(known, scene))
      throw InputError("report", "has no run of the scene '{}'{}", scene,
                       did_you_mean(scene, known));
}

std::string ReportView::caption() const {
  if (scenes_.size() == 1) return scenes_.front();
  if (scenes_.empty()) return "no scenes";
  return fmt::format("mean of {}", fmt::join(scenes_, ", "));
}

std::string ReportView::setting() const {
  std::vector<const Configuration*> configurations;
  for (const RunRecord& run : report_->runs)
    if (has(scenes_, run.configuration.scene)) configurations.push_back(&run.configuration);
  return shown_setting(configurations);
}

const RunRecord* ReportView::find(const Series& series, const std::string& scene, int width) const {
  const auto found = runs_.find({series, scene, width});
  return found == runs_.end() ? nullptr : found->second;
}

const RunRecord* ReportView::find_any(const Series& series) const {
  const auto found = runs_.lower_bound({series, {}, 0});
  return found == runs_.end() || found->first.series != series ? nullptr : found->second;
}

const RunRecord* ReportView::find_any(std::string_view facet, std::string_view scene) const {
  const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const auto& entry) {
    return entry.first.series.facet == facet && entry.first.scene == scene;
  });
  return found == runs_.end() ? nullptr : found->second;
}

std::vector<int> ReportView::widths(const Series& series) const {
  std::set<int> widths;
  for (auto at = runs_.lower_bound({series, {}, 0});
       at != runs_.end() && at->first.series == series; ++at)
    widths.insert(at->first.width);
  return {widths.begin(), widths.end()};
}

bool ReportView::was_run_on(const Series& series, const std::string& scene) const {
  const auto first = runs_.lower_bound({series, scene, 0});
  return first != runs_.end() && first->first.series == series && first->first.scene == scene;
}

std::vector<std::string> ReportView::missing_scenes(const Series& series) const {
  std::vector<std::string> missing;
  const RunRecord* const any = find_any(series);
  if (!any) return scenes_;
  const auto& of_work = scenes_of_work_.at(any->workload);
  for (const std::string& scene : scenes_)
    if (of_work.contains(scene) && !was_run_on(series, scene)) missing.push_back(scene);
  return missing;
}

std::vector<const RunRecord*> ReportView::runs(const Series& series, int width) const {
  std::vector<const RunRecord*> runs;
  for (const std::string& scene : scenes_) {
    if (!was_run_on(series, scene)) continue;
    const RunRecord* const run = find(series, scene, width);
    if (!run) return {};
    runs.push_back(run);
  }
  return runs;
}

std::optional<double> ReportView::mean(const Series& series, int width,
                                       const RunFigure& figure) const {
  return mean_over(runs(series, width), figure);
}

std::optional<double> mean_over(const std::vector<const RunRecord*>& runs,
                                const RunFigure& figure) {
  double sum = 0.0;
  for (const RunRecord* run : runs) {
    const auto value = figure(*run);
    if (!value) return std::nullopt;
    sum += *value;
  }
  if (runs.empty()) return std::nullopt;
  return sum / static_cast<double>(runs.size());
}

std::vector<std::string> scenes_of(const Report& report) {
  std::vector<std::string> scenes;
  for (const RunRecord& run : report.runs)
    if (!has(scenes, run.configuration.scene)) scenes.push_back(run.configuration.scene);
  return scenes;
}

std::vector<std::string> scenes_of(const Report& report, const std::vector<std::string>& wanted) {
  const std::vector<std::string> all = scenes_of(report);
  std::vector<std::string> present;
  for (const std::string& scene : all)
    if (has(wanted, scene)) present.push_back(scene);
  return present.empty() ? all : present;
}

std::vector<Series> series_of(const Report& report) {
  std::vector<std::string> kernels;
  std::map<std::string, std::vector<Series>> of_kernel;
  for (const RunRecord& run : report.runs) {
    const Series series{run.configuration.kernel, facet_of(run.configuration)};
    auto& facets = of_kernel[series.kernel];
    if (facets.empty()) kernels.push_back(series.kernel);
    if (std::find(facets.begin(), facets.end(), series) == facets.end()) facets.push_back(series);
  }
  std::vector<Series> all;
  for (const std::string& kernel : kernels) {
    auto& facets = of_kernel[kernel];
    std::stable_sort(facets.begin(), facets.end(), [](const Series& a, const Series& b) {
      return place_of_facet(a) < place_of_facet(b);
    });
    all.insert(all.end(), facets.begin(), facets.end());
  }
  return all;
}

std::vector<int> widths_of(const Report& report) {
  return widths_where(report, [](const RunRecord&) { return true; });
}

std::vector<int> machine_widths_of(const Report& report) {
  std::vector<int> widths =
      widths_where(report, [](const RunRecord& run) { return !run.stages.empty(); });
  return widths.empty() ? widths_of(report) : widths;
}

std::string_view facet_name(std::string_view kernel) {
  const Kernel* const known = known_kernel(kernel);
  return known ? known->workload->facet : std::string_view();
}

}  // namespace lanescope
