// SPDX-License-Identifier: MIT
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/studies/luong/charts/mp_columns.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

/// All instructions of the stages of the thesis on the triangles of a scene.
std::optional<double> whole(const ReportView& view, std::string_view kernel,
                            const std::string& scene, int width) {
  const RunRecord* run = view.find({std::string(kernel), std::string(kTriangle)}, scene, width);
  if (!run) return std::nullopt;
  return static_cast<double>(total(*run, kAllButSetup).issued);
}

DataFrame rows(const ReportView& view) {
  DataFrame frame(mp_columns({{"scene", "Scene", ""},
                              {"stage", "Stage", ""},
                              {"place", "Place of the stage", ""},
                              {"millions", "Million instructions", ".2f"},
                              {"relative", "Of the triangles' total", ".3f"}}));
  const std::vector<std::string> stages = stages_of(view.report());
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series))
      for (const std::string& scene : scenes_of(view.report())) {
        const RunRecord* run = view.find(series, scene, width);
        for (std::size_t i = 0; run && i < stages.size(); ++i) {
          const StageRecord* stage = run->stage(stages[i]);
          if (!stage || stages[i] == kSetup) continue;
          const auto issued = static_cast<double>(stage->total().issued);
          // Without triangles there is nothing to compare with.
          if (const auto relative = quotient(issued, whole(view, series.kernel, scene, width)))
            frame.add({shown_kernel(series.kernel), plural(series.facet), width, scene, stages[i],
                       i, issued * 1e-6, *relative});
        }
      }
  return frame;
}

std::vector<SectionBlock> build(const ReportView& view) {
  constexpr std::string_view kSpec = R"json({
    "facet": {"field": "scene", "title": null, "sort": "@scenes"},
    "columns": 6,
    "spec": {
      "width": 110, "height": 260,
      "mark": "bar",
      "encoding": {
        "x": {"field": "micropolygon", "type": "nominal", "title": null,
              "sort": ["triangles", "quads"], "axis": {"labelAngle": 0}},
        "y": {"field": "relative", "type": "quantitative",
              "title": "Instructions, relative to triangles"},
        "order": {"field": "place"},
        "color": "@stage"}}
  })json";
  return {Chart{"scenes",
                "All instructions of each scene by stage, without Setup, relative to those of the "
                "scene's triangles: figure 4.2 of the thesis.",
                spec_from(kSpec, view.report()),
                rows(view),
                {pick_of_kernel(), pick_of_lanes(view.report())}}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_quads{"quads", "Triangles against quads",
                                   "One quad covers what two triangles do, for fewer instructions.",
                                   luong::build};

}  // namespace lanescope
