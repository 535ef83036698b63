// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/studies/luong/charts/crossing_point.h"
#include "analysis/studies/luong/charts/mp_columns.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;

/// LOCKSTEP and REPACK on one kind of micropolygon.
struct Pair {
  Series lockstep, repack;
};
std::vector<CostRatio> ratios(const ReportView& view, const Pair& pair) {
  std::vector<CostRatio> list;
  for (const int width : widths_of(view, pair.lockstep))
    if (const auto ratio = quotient(instructions(view, pair.repack, width),
                                    instructions(view, pair.lockstep, width)))
      list.push_back({width, *ratio});
  return list;
}

std::vector<Pair> pairs_of(const ReportView& view) {
  std::vector<Pair> pairs;
  for (const Pair& pair :
       {Pair{kLockstepTriangle, kRepackTriangle}, Pair{kLockstepQuad, kRepackQuad}})
    if (!ratios(view, pair).empty()) pairs.push_back(pair);
  return pairs;
}

/// `LOCKSTEP and REPACK cost the same on triangles at W = 23.4.`
std::string sentence(const ReportView& view, const Pair& pair) {
  const std::vector<CostRatio> list = ratios(view, pair);
  const std::string shape = plural(pair.lockstep.facet);
  if (const auto width = crossing_point(list)) {
    const bool wins_above = list.front().ratio > 1.0;
    return fmt::format(
        "On {}, the two cross at W = {:.1f}: REPACK issues fewer instructions {} it.", shape,
        *width, wins_above ? "above" : "below");
  }
  return fmt::format("On {}, they do not cross: REPACK issues {} instructions at every W measured.",
                     shape, list.front().ratio > 1.0 ? "more" : "fewer");
}

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

/// A rule with a label at the crossing, on the axis of W or of its logarithm.
Json crossing_layers(const ReportView& view, const Pair& pair, bool logarithm) {
  const auto width = crossing_point(ratios(view, pair));
  if (!width) return Json::array();
  Json layers = Json::parse(R"json([
    {"mark": {"type": "rule", "strokeDash": [4, 3], "stroke": "currentColor"}},
    {"mark": {"type": "text", "align": "left", "dx": 5, "y": 8, "fill": "currentColor"}}])json");
  const Json x = {{"datum", logarithm ? std::log2(*width) : *width}};
  for (Json& layer : layers) {
    layer["data"] = {{"values", Json::array({Json::object()})}};
    layer["encoding"]["x"] = x;
  }
  layers[1]["encoding"]["text"] = {{"value", fmt::format("equal at W = {:.1f}", *width)}};
  return layers;
}

/// One panel for each kind of micropolygon, with its crossing marked.
Json panels(const ReportView& view, std::string_view panel_text, bool logarithm) {
  Json all = Json::array();
  for (const Pair& pair : pairs_of(view)) {
    Json panel = panel_for(spec_from(panel_text, view.report()), "micropolygon",
                           plural(pair.lockstep.facet));
    for (Json& layer : crossing_layers(view, pair, logarithm)) panel["layer"].push_back(layer);
    all.push_back(std::move(panel));
  }
  return {{"hconcat", std::move(all)}, {"resolve", {{"scale", {{"y", "shared"}}}}}};
}

constexpr std::string_view kStacked = R"json({
  "width": 380, "height": 280,
  "transform": [
    {"calculate": "log(datum.lanes) / LN2 + (datum.kernel == 'REPACK' ? 0.03 : -0.35)",
     "as": "left"},
    {"calculate": "datum.left + 0.32", "as": "right"},
    {"stack": "instructions", "groupby": ["kernel", "lanes"],
     "sort": [{"field": "place"}], "as": ["bottom", "top"]}],
  "layer": [
    {"mark": {"type": "rect", "stroke": "currentColor", "strokeWidth": 0.4},
     "encoding": {
       "x": {"field": "left", "type": "quantitative", "title": "W (lanes)",
             "scale": {"zero": false, "nice": false, "padding": 4},
             "axis": {"tickMinStep": 1, "labelExpr": "pow(2, datum.value)", "grid": false}},
       "x2": {"field": "right"},
       "y": {"field": "bottom", "type": "quantitative", "title": "Instructions per micropolygon"},
       "y2": {"field": "top"}, "color": "@stage"}},
    {"transform": [
       {"aggregate": [{"op": "max", "field": "top", "as": "total"},
                      {"op": "min", "field": "left", "as": "left"}],
        "groupby": ["kernel", "lanes"]},
       {"calculate": "datum.left + 0.16", "as": "middle"},
       {"calculate": "datum.total * 1.06", "as": "above"},
       {"calculate": "slice(datum.kernel, 0, 1)", "as": "letter"}],
     "mark": {"type": "text", "baseline": "bottom", "fill": "currentColor"},
     "encoding": {"x": {"field": "middle", "type": "quantitative"},
                  "y": {"field": "above", "type": "quantitative"},
                  "text": {"field": "letter"}}}]
})json";

constexpr std::string_view kRatio = R"json({
  "width": 380, "height": 200,
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

std::vector<Block> build(const ReportView& view) {
  std::string sentences;
  for (const Pair& pair : pairs_of(view)) sentences += sentence(view, pair) + ' ';
  if (sentences.empty()) return {};
  return {Markup{fmt::format("<p class=\"finding\">{}</p>\n", html_escaped(sentences))},
          Chart{"stages",
                "Instructions for each micropolygon by stage, without Setup, LOCKSTEP (L) beside "
                "REPACK (R), " +
                    view.caption() + ".",
                panels(view, kStacked, true), stage_rows(view)},
          Chart{"ratio",
                "Instructions of REPACK over those of LOCKSTEP, " + view.caption() +
                    "; below 1, REPACK issues fewer. Between widths that were measured, the ratio "
                    "is interpolated linearly over log2 W.",
                panels(view, kRatio, false), ratio_rows(view)}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_crossing{
    "crossing", "Where LOCKSTEP and REPACK cross",
    "What repacking saves in busy lanes it spends on buffers; from some width on it wins.",
    luong::build};

}  // namespace lanescope
