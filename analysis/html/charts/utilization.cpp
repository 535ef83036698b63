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

std::vector<SectionBlock> build(const ReportView& view) {
  return utilization_chart(view, {{}, "All stages", ""});
}

}  // namespace

std::vector<SectionBlock> utilization_chart(const ReportView& view, const Together& together) {
  constexpr std::string_view kSpec = R"json({
    "facet": {
      "column": {"field": "kernel", "title": null, "sort": "@kernels"},
      "row": {"field": "facet", "title": null, "sort": "@facets"}},
    "spec": {
      "width": 330, "height": 230,
      "mark": {"type": "line", "point": "@point"},
      "encoding": {
        "x": "@lanes",
        "y": {"field": "utilization", "type": "quantitative", "title": "Utilization",
              "scale": {"domain": [0, 1]}, "axis": {"format": "%"}},
        "color": "@stage",
        "strokeDash": {"field": "stage", "type": "nominal", "title": "Stage"}}}
  })json";
  auto spec = spec_from(kSpec, view.report());
  auto& encoding = spec["spec"]["encoding"];
  auto& colours = encoding["color"]["scale"];
  auto dashes = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < colours["domain"].size(); ++i) dashes.push_back({1, 0});
  colours["domain"].push_back(together.name);
  colours["range"].push_back("currentColor");
  dashes.push_back({6, 4});
  encoding["strokeDash"]["scale"] = {{"domain", colours["domain"]}, {"range", std::move(dashes)}};
  // A line says more of a dash than a point does.
  for (const char* channel : {"color", "strokeDash"})
    encoding[channel]["legend"] = {{"symbolType", "stroke"}, {"symbolSize", 400}};
  return {
      Chart{"lines",
            fmt::format("Utilization of each stage over W, {}.{}", view.caption(), together.note),
            std::move(spec), rows(view, together)}};
}

extern const Section s_utilization{
    "utilization", "Utilization over W",
    "The share of the lane slots of issued instructions in which a lane is active.", build};

}  // namespace lanescope
