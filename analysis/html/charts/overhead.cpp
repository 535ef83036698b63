// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/base/json_text.h"
#include "analysis/html/charts/overhead_chart.h"
#include "analysis/html/spec.h"
#include "analysis/tables/means.h"

namespace lanescope {
namespace {

constexpr std::size_t kPanelPx = 125;

std::vector<DataColumn> columns(const std::optional<PaperOverhead>& paper) {
  std::vector<DataColumn> list{{"stage", "Stage", ""}, {"share", "Overhead", ".1%"}};
  if (paper) list.push_back({"paper", paper->title, ".0%"});
  return list;
}

DataFrame rows(const ReportView& view, const std::optional<PaperOverhead>& paper) {
  DataFrame frame(series_columns(columns(paper)));
  for (const Series& series : series_of(view.report())) {
    if (!marks_overhead(view, series)) continue;
    for (const int width : view.widths(series))
      for (const std::string& stage : stages_of(view.report()))
        if (const auto share = mean_stage_overhead(view, series, stage, width)) {
          std::vector<DataFrame::Json> row{shown_kernel(series.kernel), shown_facet(series), width,
                                           stage, *share};
          if (paper) row.push_back(number_or_null(paper->figure(series, stage)));
          frame.add(std::move(row));
        }
  }
  return frame;
}

bool has_paper(const DataFrame& shares, const std::optional<PaperOverhead>& paper) {
  return paper && std::any_of(shares.rows().begin(), shares.rows().end(),
                              [](const auto& row) { return !row.back().is_null(); });
}

std::vector<SectionBlock> build(const ReportView& view) { return overhead_chart(view); }

}  // namespace

std::vector<SectionBlock> overhead_chart(const ReportView& view,
                                         const std::optional<PaperOverhead>& paper) {
  constexpr std::string_view kSpec = R"json({
    "transform": [{"calculate": "datum.kernel + (datum.facet ? ', ' + datum.facet : '')",
                   "as": "series"}],
    "facet": {
      "column": {"field": "stage", "title": null, "sort": "@stages"},
      "row": {"field": "series", "title": null, "sort": [],
              "header": {"labelExpr": "split(datum.label, ', ')"}}},
    "spec": {
      "height": 160,
      "encoding": {
        "x": "@W",
        "y": {"type": "quantitative", "title": "Overhead", "axis": {"format": "%"}}},
      "layer": [
        {"mark": "bar",
         "encoding": {"y": {"field": "share", "type": "quantitative"}, "color": "@stage"}},
        {"transform": [{"filter": "isValid(datum.paper)"}],
         "mark": {"type": "tick", "color": "currentColor", "thickness": 2},
         "encoding": {"y": {"field": "paper", "type": "quantitative"}}}]}
  })json";
  DataFrame shares = rows(view, paper);
  auto spec = spec_from(kSpec, view.report());
  spec["spec"]["width"] = kPanelPx;
  if (has_paper(shares, paper))
    spec["spec"]["layer"][1]["mark"]["width"] =
        std::min<std::size_t>(26, kPanelPx / machine_widths_of(view.report()).size());
  else
    spec["spec"]["layer"].erase(1);
  auto& order = spec["facet"]["row"]["sort"];
  for (const Series& series : series_of(view.report())) order.push_back(shown(series));
  spec["spec"]["layer"][0]["encoding"]["color"]["legend"] = nullptr;  // The headings say it.
  return {Chart{"shares",
                fmt::format("Share of the instructions of each stage that the kernel marks as "
                            "overhead, {}.{}{} Kernels that mark nothing are left out.",
                            view.caption(), paper ? " " : "", paper ? paper->note : ""),
                std::move(spec), std::move(shares)}};
}

extern const Section s_overhead{"overhead", "Overhead",
                                "Work that the baseline of the kernel does not have to do.", build};

}  // namespace lanescope
