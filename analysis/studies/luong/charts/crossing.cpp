// SPDX-License-Identifier: MIT
#include "analysis/tables/crossing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/studies/luong/charts/mp_columns.h"
#include "analysis/studies/luong/charts/pairs.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;

DataFrame stage_rows(const ReportView& view) {
  DataFrame frame(mp_columns({{"stage", "Stage", ""},
                              {"place", "Place of the stage", ""},
                              {"instructions", "Instructions/mp", ".3f"}}));
  const std::vector<std::string> stages = stages_of(view.report());
  for (const Pair& pair : pairs_of(view))
    for (const Series& series : {pair.lockstep, pair.repack})
      for (const int width : few_widths(widths_of(view, series)))
        for (std::size_t i = 0; i < stages.size(); ++i)
          if (const auto value = mean_stage_instructions(view, series, stages[i], width);
              value && stages[i] != kSetup)
            frame.add(
                {shown_kernel(series.kernel), plural(series.facet), width, stages[i], i, *value});
  return frame;
}

DataFrame ratio_rows(const ReportView& view) {
  DataFrame frame({{"micropolygon", "Micropolygons", ""},
                   {"lanes", "W", ""},
                   {"ratio", "REPACK / LOCKSTEP", ".3f"}});
  for (const Pair& pair : pairs_of(view))
    for (const CostRatio& at : ratios(view, pair))
      frame.add({plural(pair.lockstep.facet), at.width, at.ratio});
  return frame;
}

/// The place of a crossing on an axis of W.
using PlaceOf = std::function<double(double width)>;

/// A rule with a label at the crossing.
Json crossing_layers(const ReportView& view, const Pair& pair, const PlaceOf& place_of) {
  const auto width = crossing_point(ratios(view, pair));
  if (!width) return Json::array();
  Json layers = Json::parse(R"json([
    {"mark": {"type": "rule", "strokeDash": [4, 3], "stroke": "currentColor"}},
    {"mark": {"type": "text", "align": "left", "dx": 5, "y": 8, "fill": "currentColor"}}])json");
  for (Json& layer : layers) {
    layer["data"] = {{"values", Json::array({Json::object()})}};
    layer["encoding"]["x"] = {{"datum", place_of(*width)}};
  }
  layers[1]["encoding"]["text"] = {{"value", fmt::format("equal at W = {:.1f}", *width)}};
  return layers;
}

/// One panel for each kind of micropolygon, with its crossing marked.
Json panels(const ReportView& view, const Json& panel_spec, const PlaceOf& place_of) {
  Json all = Json::array();
  for (const Pair& pair : pairs_of(view)) {
    Json panel = panel_for(panel_spec, "micropolygon", plural(pair.lockstep.facet));
    for (Json& layer : crossing_layers(view, pair, place_of)) panel["layer"].push_back(layer);
    all.push_back(std::move(panel));
  }
  return {{"concat", std::move(all)}, {"columns", 2}, {"resolve", {{"scale", {{"y", "shared"}}}}}};
}

/// Widths at equal distances, whatever they are: a pair of bars has one unit of room.
double place_among(const std::vector<int>& widths, double width) {
  const auto above = std::upper_bound(widths.begin(), widths.end(), width);
  if (above == widths.begin() || above == widths.end())
    return above == widths.begin() ? 0.0 : static_cast<double>(widths.size() - 1);
  const double low = std::log2(*std::prev(above)), high = std::log2(*above);
  return static_cast<double>(above - widths.begin() - 1) + (std::log2(width) - low) / (high - low);
}

/// LOCKSTEP's bars stand left of the place of their W, REPACK's right of it.
Json stacked_panel(const Report& report) {
  constexpr std::string_view kStacked = R"json({
    "width": 400, "height": 280,
    "transform": [
      {"calculate": "indexof(widths, datum.lanes) + (datum.kernel == 'REPACK' ? 0.02 : -0.42)",
       "as": "left"},
      {"calculate": "datum.left + 0.4", "as": "right"},
      {"stack": "instructions", "groupby": ["kernel", "lanes"],
       "sort": [{"field": "place"}], "as": ["bottom", "top"]}],
    "layer": [
      {"mark": {"type": "rect", "stroke": "currentColor", "strokeWidth": 0.4},
       "encoding": {
         "x": {"field": "left", "type": "quantitative", "title": "W (lanes)",
               "scale": {"zero": false, "nice": false, "domain": null}, "axis": null},
         "x2": {"field": "right"},
         "y": {"field": "bottom", "type": "quantitative", "title": "Instructions per micropolygon"},
         "y2": {"field": "top"}, "color": "@stage"}},
      {"transform": [
         {"aggregate": [{"op": "max", "field": "top", "as": "total"},
                        {"op": "min", "field": "left", "as": "left"}],
          "groupby": ["kernel", "lanes"]},
         {"calculate": "datum.left + 0.2", "as": "middle"},
         {"calculate": "datum.total * 1.08", "as": "above"},
         {"calculate": "slice(datum.kernel, 0, 1)", "as": "letter"}],
       "encoding": {"x": {"field": "middle", "type": "quantitative"}},
       "layer": [
         {"mark": {"type": "text", "baseline": "bottom", "dy": -3, "fill": "currentColor"},
          "encoding": {"y": {"field": "total", "type": "quantitative"},
                       "text": {"field": "letter"}}},
         {"mark": {"type": "point", "opacity": 0},
          "encoding": {"y": {"field": "above", "type": "quantitative"}}}]}]
  })json";
  const std::vector<int> widths = few_widths(lanescope::widths_of(report));
  const std::string list = fmt::format("[{}]", fmt::join(widths, ", "));
  std::string text(kStacked);
  text.replace(text.find("widths,"), 6, list);
  Json panel = spec_from(text, report);
  Json places = Json::array();
  for (std::size_t i = 0; i < widths.size(); ++i) places.push_back(i);
  Json& x = panel["layer"][0]["encoding"]["x"];
  x["scale"]["domain"] = {-0.5, static_cast<double>(widths.size()) - 0.5};
  x["axis"] = {{"values", places}, {"labelExpr", list + "[datum.value]"}, {"grid", false}};
  return panel;
}

constexpr std::string_view kRatio = R"json({
  "width": 400, "height": 200,
  "layer": [
    {"mark": {"type": "line", "stroke": "currentColor",
              "point": "@ink_point"},
     "encoding": {
       "x": "@lanes",
       "y": {"field": "ratio", "type": "quantitative", "title": "REPACK / LOCKSTEP",
             "scale": {"zero": false, "padding": 20}}}},
    {"mark": {"type": "rule", "stroke": "currentColor", "opacity": 0.5},
     "encoding": {"y": {"datum": 1}}}]
})json";

std::vector<SectionBlock> build(const ReportView& view) {
  std::string sentences;
  for (const Pair& pair : pairs_of(view)) sentences += crossing_sentence(view, pair) + ' ';
  if (sentences.empty()) return {};
  const std::vector<int> widths = few_widths(lanescope::widths_of(view.report()));
  return {Markup{fmt::format("<p class=\"finding\">{}</p>\n", html_escaped(sentences))},
          Chart{"stages",
                "Instructions for each micropolygon by stage, without Setup, LOCKSTEP (L) beside "
                "REPACK (R), " +
                    view.caption() + ".",
                panels(view, stacked_panel(view.report()),
                       [&](double width) { return place_among(widths, width); }),
                stage_rows(view)},
          Chart{"ratio",
                "Instructions of REPACK over those of LOCKSTEP, " + view.caption() +
                    "; below 1, REPACK issues fewer. Between widths that were measured, the ratio "
                    "is interpolated linearly over log2 W.",
                panels(view, spec_from(kRatio, view.report()), [](double width) { return width; }),
                ratio_rows(view)}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_crossing{
    "crossing", "Where LOCKSTEP and REPACK cross",
    "What repacking saves in busy lanes it spends on buffers; from some width on it wins.",
    luong::build};

}  // namespace lanescope
