// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/tables/thesis.h"
#include "analysis/tables/thesis_figures.h"

namespace lanescope {
namespace {

/// Table 4.3, which is of REPACK on triangles and of no width in particular.
std::optional<double> thesis_overhead(const Series& series, const std::string& stage) {
  if (series.kernel != kRepackTriangle.kernel || series.shape != kRepackTriangle.shape) return {};
  return thesis_value({"table_4_3", "overhead", stage});
}

bool marks_overhead(const ReportView& view, const Series& series) {
  for (const std::string& stage : stages_of(view.report()))
    for (const int width : view.widths(series))
      if (overhead_share(view, series, stage, width).value_or(0.0) > 0.0) return true;
  return false;
}

DataFrame rows(const ReportView& view) {
  DataFrame frame(series_columns({{"stage", "Stage", ""},
                                  {"share", "Overhead", ".1%"},
                                  {"thesis", "Thesis, of no width in particular", ".0%"}}));
  for (const Series& series : series_of(view.report())) {
    if (!marks_overhead(view, series)) continue;
    for (const int width : view.widths(series))
      for (const std::string& stage : stages_of(view.report()))
        if (const auto share = overhead_share(view, series, stage, width))
          frame.add({shown_kernel(series.kernel), shown_shape(series.shape), width, stage, *share,
                     number_or_null(thesis_overhead(series, stage))});
  }
  return frame;
}

bool has_thesis(const DataFrame& shares) {
  return std::any_of(shares.rows().begin(), shares.rows().end(),
                     [](const auto& row) { return !row.back().is_null(); });
}

std::vector<Block> build(const ReportView& view) {
  constexpr std::string_view kSpec = R"json({
    "transform": [{"calculate": "datum.kernel + ', ' + datum.micropolygon", "as": "series"}],
    "facet": {
      "column": {"field": "stage", "title": null, "sort": "@stages"},
      "row": {"field": "series", "title": null, "sort": []}},
    "spec": {
      "width": 125, "height": 160,
      "encoding": {
        "x": {"field": "lanes", "type": "ordinal", "title": "W (lanes)", "axis": {"labelAngle": 0}},
        "y": {"type": "quantitative", "title": "Overhead", "axis": {"format": "%"}}},
      "layer": [
        {"mark": "bar",
         "encoding": {"y": {"field": "share", "type": "quantitative"}, "color": "@stage"}},
        {"transform": [{"filter": "isValid(datum.thesis)"}],
         "mark": {"type": "tick", "color": "currentColor", "thickness": 2, "width": 26},
         "encoding": {"y": {"field": "thesis", "type": "quantitative"}}}]}
  })json";
  DataFrame shares = rows(view);
  auto spec = spec_from(kSpec, view.report());
  if (!has_thesis(shares)) spec["spec"]["layer"].erase(1);
  auto& order = spec["facet"]["row"]["sort"];
  for (const Series& series : series_of(view.report()))
    order.push_back(fmt::format("{}, {}", shown_kernel(series.kernel), shown_shape(series.shape)));
  spec["spec"]["layer"][0]["encoding"]["color"]["legend"] = nullptr;  // The headings say it.
  return {Chart{"shares",
                "Share of the instructions of each stage that the kernel marks as overhead, " +
                    view.caption() +
                    ". Strokes: the thesis's figures of table 4.3, which it gives for no width in "
                    "particular. Kernels that mark nothing are left out.",
                std::move(spec), std::move(shares)}};
}

}  // namespace

extern const Section s_overhead{
    "overhead", "Overhead",
    "What is spent on loading from, compacting into and scheduling of buffers.", build};

}  // namespace lanescope
