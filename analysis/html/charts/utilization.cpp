// SPDX-License-Identifier: MIT
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/tables/thesis_figures.h"

namespace lanescope {
namespace {

DataFrame rows(const ReportView& view) {
  DataFrame frame(series_columns({{"stage", "Stage", ""}, {"utilization", "Utilization", ".1%"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series)) {
      const auto add = [&](const std::string& stage, std::optional<double> value) {
        if (value)
          frame.add({shown_kernel(series.kernel), shown_shape(series.shape), width, stage, *value});
      };
      for (const std::string& stage : stages_of(view.report()))
        add(stage, stage_utilization(view, series, stage, width));
      add("All but Setup", overall_utilization(view, series, width));
    }
  return frame;
}

std::vector<Block> build(const ReportView& view) {
  constexpr std::string_view kSpec = R"json({
    "facet": {
      "column": {"field": "kernel", "title": null, "sort": "@kernels"},
      "row": {"field": "micropolygon", "title": null, "sort": ["triangles", "quads"]}},
    "spec": {
      "width": 330, "height": 230,
      "encoding": {
        "x": "@lanes",
        "y": {"field": "utilization", "type": "quantitative", "title": "Utilization",
              "scale": {"domain": [0, 1]}, "axis": {"format": "%"}}},
      "layer": [
        {"transform": [{"filter": "datum.stage != 'All but Setup'"}],
         "mark": {"type": "line", "point": {"size": 40}}, "encoding": {"color": "@stage"}},
        {"transform": [{"filter": "datum.stage == 'All but Setup'"}],
         "mark": {"type": "line", "stroke": "currentColor", "strokeDash": [6, 4],
                  "point": {"shape": "diamond", "fill": "currentColor", "stroke": null}}}
      ]}
  })json";
  return {Chart{"lines",
                "Utilization of each stage over W, " + view.caption() +
                    ". Dashed: all stages but Setup together, as the thesis sums.",
                spec_from(kSpec, view.report()), rows(view)}};
}

}  // namespace

extern const Section s_utilization{
    "utilization", "Utilization over W",
    "The share of the lane slots of issued instructions in which a lane is active.", build};

}  // namespace lanescope
