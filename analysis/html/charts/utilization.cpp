// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/html/charts/utilization_chart.h"
#include "analysis/html/spec.h"
#include "analysis/tables/means.h"

namespace lanescope {
namespace {

DataFrame rows(const ReportView& view, const Together& together) {
  DataFrame frame(series_columns({{"stage", "Stage", ""}, {"utilization", "Utilization", ".1%"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series)) {
      const auto add = [&](const std::string& stage, std::optional<double> value) {
        if (value)
          frame.add({shown_kernel(series.kernel), shown_facet(series), width, stage, *value});
      };
      for (const std::string& stage : stages_of(view.report()))
        add(stage, mean_stage_utilization(view, series, stage, width));
      add(together.name, mean_utilization(view, series, width, together.stages));
    }
  return frame;
}

std::vector<Block> build(const ReportView& view) {
  return utilization_chart(view, {{}, "All stages", "Dashed: all stages together."});
}

}  // namespace

std::vector<Block> utilization_chart(const ReportView& view, const Together& together) {
  constexpr std::string_view kSpec = R"json({
    "facet": {
      "column": {"field": "kernel", "title": null, "sort": "@kernels"},
      "row": {"field": "facet", "title": null, "sort": "@facets"}},
    "spec": {
      "width": 330, "height": 230,
      "encoding": {
        "x": "@lanes",
        "y": {"field": "utilization", "type": "quantitative", "title": "Utilization",
              "scale": {"domain": [0, 1]}, "axis": {"format": "%"}}},
      "layer": [
        {"mark": {"type": "line", "point": "@point"}, "encoding": {"color": "@stage"}},
        {"mark": {"type": "line", "stroke": "currentColor", "strokeDash": [6, 4],
                  "point": "@ink_point"}}
      ]}
  })json";
  auto spec = spec_from(kSpec, view.report());
  auto& layers = spec["spec"]["layer"];
  for (const auto& [layer, comparison] : {std::pair(0, "!="), std::pair(1, "==")})
    layers[layer]["transform"] = {
        {{"filter", fmt::format("datum.stage {} '{}'", comparison, together.name)}}};
  if (auto& point = layers[1]["mark"]["point"]; point.is_object()) point["shape"] = "diamond";
  return {
      Chart{"lines",
            fmt::format("Utilization of each stage over W, {}. {}", view.caption(), together.note),
            std::move(spec), rows(view, together)}};
}

extern const Section s_utilization{
    "utilization", "Utilization over W",
    "The share of the lane slots of issued instructions in which a lane is active.", build};

}  // namespace lanescope
