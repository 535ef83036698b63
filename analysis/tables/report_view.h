// SPDX-License-Identifier: MIT
// What a table is made from: a report and the scenes of it that the table is about.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/report.h"

namespace lanescope {

/// A kernel on one kind of micropolygon: the runs that one table of the thesis compares over W.
struct Series {
  std::string_view kernel;
  Micropolygon shape;
};

/// A figure of one run; none where it is undefined.
using RunFigure = std::function<std::optional<double>(const RunRecord&)>;

/// Scenes of a report: one by itself, or several over which figures are averaged.
class ReportView {
 public:
  /// The scenes that are like the thesis's, or all of the report's if it has none of those. Keeps a
  /// reference to `report`. Throws InputError if two runs are of the same kernel, scene, width and
  /// micropolygon, because a table could show only one of them.
  explicit ReportView(const Report& report);
  /// One scene by itself. Throws InputError if the report does not have it.
  ReportView(const Report& report, const std::string& scene);

  const Report& report() const { return *report_; }
  const std::vector<std::string>& scenes() const { return scenes_; }
  /// Names the scenes: `teapot`, or `mean of ballroll, talking`.
  std::string caption() const;

  /// The run, or null.
  const RunRecord* find(const Series& series, std::string_view scene, int width) const;
  /// Some run of the scene on that kind of micropolygon, for figures that no kernel or width
  /// changes; null if there is none.
  const RunRecord* find_any(std::string_view scene, Micropolygon shape) const;

  /// Widths of the series in the report, ascending; the thesis's if it has none.
  std::vector<int> widths(const Series& series) const;

  /// Arithmetic mean over the scenes of the figure, as the thesis averages ratios. None if a scene
  /// lacks the run or the figure is undefined there.
  std::optional<double> mean(const Series& series, int width, const RunFigure& figure) const;
  /// The same for figures that no kernel or width changes.
  std::optional<double> mean(Micropolygon shape, const RunFigure& figure) const;

 private:
  const Report* report_;
  std::vector<std::string> scenes_;
};

/// The scenes of a report, in the order of their first runs.
std::vector<std::string> scenes_of(const Report& report);

}  // namespace lanescope
