// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/html/markup.h"
#include "analysis/html/spec.h"
#include "analysis/studies/littlest/figures.h"

namespace lanescope::littlest {
namespace {

/// The world, W, the program that wins, and what it needs.
DataFrame winners(const ReportView& view) {
  DataFrame frame({{"facet", "Projection", ""},
                   {"scene", "World", ""},
                   {"place", "Place of the world", ""},
                   {"lanes", "W", ""},
                   {"kernel", "Fewest instructions", ""},
                   {"cost", "Instr./octant", ".1f"}});
  const Report& report = view.report();
  const std::vector<std::string> scenes = scenes_and_filled(view);
  for (const std::string_view projection : {kFaces, kDirections})
    for (std::size_t i = 0; i < scenes.size(); ++i)
      for (const int width : machine_widths_of(report))
        if (const auto best = winner(ReportView(report, scenes[i]), projection, width))
          frame.add({shown_facet(best->series), scenes[i], i, width,
                     shown_kernel(best->series.kernel), best->per_octant});
  return frame;
}

/// Programs have the same colours in both charts (Okabe and Ito 2008).
nlohmann::ordered_json colours_of_programs(const Report& report) {
  constexpr std::string_view kColours[] = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                           "#cc79a7", "#56b4e9", "#888888"};
  auto scale = nlohmann::ordered_json{{"domain", kernels_of(report)},
                                      {"range", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < scale["domain"].size(); ++i)
    scale["range"].push_back(kColours[i % std::size(kColours)]);
  return scale;
}

constexpr std::string_view kWinners = R"json({
  "width": 560, "height": {"step": 34},
  "encoding": {
    "x": {"field": "lanes", "type": "ordinal", "title": "W (lanes)", "axis": {"labelAngle": 0}},
    "y": {"field": "scene", "type": "ordinal", "title": null, "sort": {"field": "place"}}},
  "layer": [
    {"mark": {"type": "rect", "stroke": "white", "opacity": 0.55},
     "encoding": {"color": {"field": "kernel", "type": "nominal", "title": "Fewest instructions",
                            "sort": "@kernels"}}},
    {"mark": {"type": "text", "fill": "currentColor"},
     "encoding": {"text": {"field": "cost", "type": "quantitative", "format": ".1f"}}}]
})json";

DataFrame costs_over_fill(const ReportView& view) {
  DataFrame frame(series_columns({{"filled", "Filled", ".0%"}, {"cost", "Instr./octant", ".1f"}}));
  const Report& report = view.report();
  for (const Series& series : programs_of(report))
    for (const int width : machine_widths_of(report))
      for (const Filled& filled : filled_scenes(report))
        if (const auto cost = per_octant(ReportView(report, filled.scene), series, width))
          frame.add({shown_kernel(series.kernel), shown_facet(series), width, filled.share, *cost});
  return frame;
}

constexpr std::string_view kOverFill = R"json({
  "width": 560, "height": 300,
  "mark": {"type": "line", "point": true},
  "encoding": {
    "x": {"field": "filled", "type": "quantitative", "title": "Share of the cubes that is filled",
          "scale": {"type": "log"}, "axis": {"format": "%", "values": [0.01, 0.05, 0.2, 0.4, 0.6]}},
    "y": {"field": "cost", "type": "quantitative", "title": "Instructions for each octant"},
    "color": {"field": "kernel", "type": "nominal", "title": null, "sort": "@kernels"}}
})json";

std::vector<SectionBlock> build(const ReportView& view) {
  const Report& report = view.report();
  if (programs_of(report).empty()) return {};
  auto winners_spec = spec_from(kWinners, report), fill_spec = spec_from(kOverFill, report);
  winners_spec["layer"][0]["encoding"]["color"]["scale"] = colours_of_programs(report);
  fill_spec["encoding"]["color"]["scale"] = colours_of_programs(report);
  return {Chart{"winners",
                "The program that needs the fewest instructions for an octant, and how many.",
                std::move(winners_spec),
                winners(view),
                {pick_of_facet()}},
          Chart{"fill",
                "Instructions for each octant over how full the world is; scattered cubes.",
                std::move(fill_spec),
                costs_over_fill(view),
                {pick_of_facet(), pick_of_lanes(report)}}};
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Section littlest_s_forms{
    "forms", "Which form wins where",
    "The same images from four programs: what a lane is decides what they cost.", littlest::build};

}  // namespace lanescope
