// SPDX-License-Identifier: MIT
// What a table is made from: a report and the scenes of it that the table is about.
#pragma once

#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// A kernel on one kind of its work (facet_of): the runs that a table compares over W.
struct Series {
  std::string kernel;
  std::string facet;

  auto operator<=>(const Series&) const = default;
};

/// A figure of one run; none where it is undefined.
using RunFigure = std::function<std::optional<double>(const RunRecord&)>;

/// Scenes of a report: one by itself, or several over which figures are averaged. Keeps a reference
/// to the report. Throws InputError if two runs are of the same kernel, scene, width and facet,
/// because a table could show only one of them.
class ReportView {
 public:
  /// All scenes of the report.
  explicit ReportView(const Report& report);
  /// Throws InputError if the report does not have one of the scenes.
  ReportView(const Report& report, const std::vector<std::string>& scenes);
  /// One scene by itself.
  ReportView(const Report& report, const std::string& scene)
      : ReportView(report, std::vector<std::string>{scene}) {}

  const Report& report() const { return *report_; }
  const std::vector<std::string>& scenes() const { return scenes_; }
  /// Names the scenes: `teapot`, or `mean of ballroll, talking`.
  std::string caption() const;

  /// With what parameters these scenes were run, as shown_setting() has them.
  std::string setting() const;

  /// The run, or null.
  const RunRecord* find(const Series& series, const std::string& scene, int width) const;
  /// Some run of the series, for what no scene or width changes; null if there is none.
  const RunRecord* find_any(const Series& series) const;
  /// Some run of the scene on that kind of work, for figures that no kernel or width changes; null
  /// if there is none.
  const RunRecord* find_any(std::string_view facet, std::string_view scene) const;

  /// Widths of the series in the report, ascending.
  std::vector<int> widths(const Series& series) const;

  /// The scenes of the series's kind of work that it was not run on at any width.
  std::vector<std::string> missing_scenes(const Series& series) const;

  /// The runs that a mean is over: of each scene that the series was run on. None at all if one of
  /// them lacks the run at this width.
  std::vector<const RunRecord*> runs(const Series& series, int width) const;

  /// Arithmetic mean of the figure over the scenes. None if a scene lacks the run or the figure is
  /// undefined there.
  std::optional<double> mean(const Series& series, int width, const RunFigure& figure) const;

 private:
  bool was_run_on(const Series& series, const std::string& scene) const;

  struct Place {
    Series series;
    std::string scene;
    int width;
    auto operator<=>(const Place&) const = default;
  };

  const Report* report_;
  std::vector<std::string> scenes_;
  std::map<Place, const RunRecord*> runs_;
  /// The scenes of each kind of work.
  std::map<std::string, std::set<std::string>> scenes_of_work_;
};

/// The mean of a figure over runs; none if there are none, or the figure is undefined for one.
std::optional<double> mean_over(const std::vector<const RunRecord*>& runs, const RunFigure& figure);

/// The scenes of a report, in the order of their first runs.
std::vector<std::string> scenes_of(const Report& report);

/// Those of `wanted` that the report has, in its order; all of the report's if it has none of them.
std::vector<std::string> scenes_of(const Report& report, const std::vector<std::string>& wanted);

/// The kernels of a report on their kinds of work, kernels in the order of their first runs, facets
/// in the order of their choices.
std::vector<Series> series_of(const Report& report);

/// All widths of a report, ascending.
std::vector<int> widths_of(const Report& report);

/// Those at which a program was counted that issues instructions; all, if there are none.
std::vector<int> machine_widths_of(const Report& report);

/// The parameter that is the facet of a kernel's kind of work; empty if it has none, or if the
/// program does not have the kernel.
std::string_view facet_name(std::string_view kernel);

}  // namespace lanescope
