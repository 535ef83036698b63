// SPDX-License-Identifier: MIT
#include "analysis/html/charts/lane_chart.h"

#include "analysis/html/spec.h"
#include "analysis/report/figures.h"

namespace lanescope {
namespace {

constexpr const char* kShareTitle = "Instructions";

DataFrame rows(const Report& report, const LaneChart& chart) {
  DataFrame frame(series_columns({{"scene", "Scene", ""},
                                  {"stage", "Stage", ""},
                                  {"place", chart.place_title, ""},
                                  {"share", kShareTitle, ".2%"}}));
  for (const RunRecord& run : report.runs) {
    const Configuration& c = run.configuration;
    const std::string facet = shown_facet({c.kernel, facet_of(c)});
    for (const StageRecord& stage : run.stages) {
      const std::uint64_t issued = stage.total().issued;
      const std::vector<std::uint64_t>& counts = chart.counts(stage);
      for (std::size_t place = 0; place < counts.size(); ++place)
        if (const auto share = Ratio{counts[place], issued}.value())
          frame.add({shown_kernel(c.kernel), facet, c.width, c.scene, stage.name, place, *share});
    }
  }
  return frame;
}

}  // namespace

std::vector<SectionBlock> lane_chart(const ReportView& view, const LaneChart& chart) {
  constexpr std::string_view kSpec = R"json({
    "transform": [
      {"calculate": "datum.place - 0.5", "as": "left"},
      {"calculate": "datum.place + 0.5", "as": "right"}],
    "facet": {
      "column": {"field": "stage", "title": null, "sort": "@stages"},
      "row": {"field": "kernel", "title": null, "sort": "@kernels"}},
    "spec": {
      "width": 140, "height": 140,
      "mark": {"type": "rect"},
      "encoding": {
        "x": {"field": "left", "type": "quantitative", "scale": {"nice": false, "zero": false},
              "axis": {"format": "d", "tickMinStep": 1, "tickCount": 4, "grid": false}},
        "x2": {"field": "right"},
        "y": {"field": "share", "type": "quantitative", "axis": {"format": "%", "tickCount": 4}},
        "y2": {"datum": 0},
        "color": "@stage"}}
  })json";
  const Report& report = view.report();
  auto spec = spec_from(kSpec, report);
  auto& encoding = spec["spec"]["encoding"];
  encoding["x"]["title"] = chart.place_title;
  encoding["y"]["title"] = kShareTitle;
  encoding["color"]["legend"] = nullptr;  // The headings say it.
  return {Chart{"panels",
                chart.caption,
                std::move(spec),
                rows(report, chart),
                {{"scene", view.scenes().front()}, pick_of_facet(), pick_of_lanes(report)}}};
}

}  // namespace lanescope
