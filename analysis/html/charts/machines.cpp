// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/base/json_text.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/html/table_html.h"
#include "analysis/machines/crossover_tables.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// The slots of the second kernel over those of the first, on each machine.
DataFrame ratio_rows(const std::vector<MachineCrossover>& all) {
  DataFrame frame({{"machine", "Machine", ""},
                   {"facet", "Kind of work", ""},
                   {"lanes", "W", ""},
                   {"first", "Slots/element of the first", ".2f"},
                   {"second", "Slots/element of the second", ".2f"},
                   {"ratio", "Ratio", ".3f"}});
  for (const MachineCrossover& one : all)
    for (const SlotsAtWidth& at : one.crossover.widths)
      frame.add({one.machine.name, shown_facet(one.pair.first), at.width, at.first, at.second,
                 at.ratio()});
  return frame;
}

/// The crossings that lie between widths that were measured.
DataFrame crossing_rows(const std::vector<MachineCrossover>& all) {
  DataFrame frame({{"machine", "Machine", ""},
                   {"facet", "Kind of work", ""},
                   {"crossing", "Crossing (W)", ".1f"},
                   {"halved", "With half the cost", ".1f"},
                   {"doubled", "With double the cost", ".1f"},
                   {"mnemonic", "of", ""}});
  for (const MachineCrossover& one : all) {
    if (!one.crossover.crossing || one.sensitivities.empty()) continue;
    const Sensitivity& most = one.sensitivities.front();
    frame.add({one.machine.name, shown_facet(one.pair.first), *one.crossover.crossing,
               number_or_null(most.halved.crossing), number_or_null(most.doubled.crossing),
               most.mnemonic});
  }
  return frame;
}

constexpr std::string_view kRatios = R"json({
  "facet": {"column": {"field": "facet", "title": null, "sort": "@facets"}},
  "spec": {
    "width": 380, "height": 260,
    "layer": [
      {"mark": {"type": "line", "point": "@point"},
       "encoding": {
         "x": "@lanes",
         "y": {"field": "ratio", "type": "quantitative", "title": "Slots, second / first",
               "scale": {"type": "log", "nice": false, "padding": 10},
               "axis": {"tickCount": 5}},
         "color": {"field": "machine", "type": "nominal", "title": "Machine", "sort": [],
                   "scale": {"scheme": "tableau20"}}}},
      {"mark": {"type": "rule", "stroke": "currentColor", "opacity": 0.5},
       "encoding": {"y": {"datum": 1}}}]}
})json";

/// The line is a point where its ends are not known: a layer without a datum has a scale without an
/// end.
constexpr std::string_view kCrossings = R"json({
  "facet": {"column": {"field": "facet", "title": null, "sort": "@facets"}},
  "spec": {
    "width": 300, "height": {"step": 22},
    "encoding": {"y": {"field": "machine", "type": "nominal", "title": null, "sort": []}},
    "layer": [
      {"transform": [
         {"calculate": "isValid(datum.halved) && isValid(datum.doubled)", "as": "is_known"},
         {"calculate": "datum.is_known ? datum.halved : datum.crossing", "as": "from"},
         {"calculate": "datum.is_known ? datum.doubled : datum.crossing", "as": "to"}],
       "mark": {"type": "rule", "stroke": "currentColor", "opacity": 0.6},
       "encoding": {"x": {"field": "from", "type": "quantitative"}, "x2": {"field": "to"}}},
      {"mark": {"type": "point", "filled": true, "size": 60, "fill": "currentColor"},
       "encoding": {"x": {"field": "crossing", "type": "quantitative", "title": "Crossing (W)",
                          "scale": {"type": "log", "base": 2, "nice": false, "padding": 20}}}},
      {"mark": {"type": "text", "align": "left", "dx": 8, "dy": -7, "fontSize": 9,
                "fill": "currentColor"},
       "encoding": {"x": {"field": "crossing", "type": "quantitative"},
                    "text": {"field": "mnemonic"}}}]}
})json";

std::vector<SectionBlock> build(const ReportView& view) {
  const std::vector<std::string> kernels = vector_kernels(view.report());
  if (kernels.size() < 2) return {};
  const auto all = crossovers(view, kernels[0], kernels[1], shipped_machines());
  DataFrame ratios = ratio_rows(all);
  if (ratios.empty()) return {};
  const std::string pair =
      fmt::format("{} over those of {}", shown_kernel(kernels[1]), shown_kernel(kernels[0]));
  std::vector<SectionBlock> blocks{
      Markup{table_html(crossover_table(view, all))},
      Chart{"ratios",
            fmt::format("Issue slots of {}, for each element, of all stages, {}; below 1, {} takes "
                        "fewer.",
                        pair, view.caption(), shown_kernel(kernels[1])),
            spec_from(kRatios, view.report()), std::move(ratios)}};
  if (DataFrame crossings = crossing_rows(all); !crossings.empty())
    blocks.push_back(
        Chart{"crossings",
              "The W at which both take the same, where it lies between widths that were run. The "
              "line is from the crossing with half the cost of the instruction named, which moves "
              "it most, to that with double the cost.",
              spec_from(kCrossings, view.report()), std::move(crossings)});
  return blocks;
}

}  // namespace

extern const Section s_machines{
    "machines", "On real machines",
    "What the same counts take where instructions differ in cost, in slots of one addition.",
    build};

}  // namespace lanescope
