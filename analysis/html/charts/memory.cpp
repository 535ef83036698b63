// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "analysis/base/json_text.h"
#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/tables/memory_places.h"

namespace lanescope {
namespace {

std::vector<MemoryPlace> places_of(const Report& report) {
  std::vector<const RunRecord*> runs;
  for (const RunRecord& run : report.runs) runs.push_back(&run);
  return memory_places(runs, stages_of(report));
}

std::vector<DataColumn> columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> all =
      series_columns({{"stage", "Stage", ""}, {"mnemonic", "Instruction", ""}});
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

template <class Add>
void for_each_place(const ReportView& view, const Add& add) {
  const std::vector<MemoryPlace> places = places_of(view.report());
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series))
      for (const MemoryPlace& place : places) add(series, width, place);
}

DataFrame means(const ReportView& view) {
  DataFrame frame(columns({{"lines", "Lines/execution", ".2f"},
                           {"active", "Lanes on/execution", ".2f"},
                           {"conflicts", "Conflicts/lane", ".3%"}}));
  for_each_place(view, [&](const Series& series, int width, const MemoryPlace& place) {
    const auto touched = mean_lines(view, series, width, place);
    if (!touched) return;
    frame.add({shown_kernel(series.kernel), shown_facet(series), width, place.stage, place.mnemonic,
               *touched, number_or_null(mean_lanes_on(view, series, width, place)),
               number_or_null(mean_conflicts(view, series, width, place))});
  });
  return frame;
}

DataFrame histograms(const ReportView& view) {
  DataFrame frame(columns({{"lines", "Lines", ""}, {"share", "Executions", ".2%"}}));
  for_each_place(view, [&](const Series& series, int width, const MemoryPlace& place) {
    for (std::size_t k = 0; k <= static_cast<std::size_t>(width); ++k) {
      const auto share = mean_share_of_lines(view, series, width, place, k);
      if (share.value_or(0.0) > 0.0)
        frame.add({shown_kernel(series.kernel), shown_facet(series), width, place.stage,
                   place.mnemonic, k, *share});
    }
  });
  return frame;
}

/// Of the scenes of the view, each piece of work once: runs of a scene have the same.
std::string observed_note(const ReportView& view) {
  std::map<std::uint64_t, const SourceRecord*> sources;
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series))
      for (const RunRecord* run : view.runs(series, width))
        sources.emplace(run->source.hash, &run->source);
  std::uint64_t pieces = 0, observed = 0;
  for (const auto& [_, source] : sources) {
    pieces += source->pieces;
    observed += source->pieces_observed;
  }
  return fmt::format(
      "<p class=\"note\">Observed in {} of the {} pieces of work of {} (observe_every); the other "
      "sections count all of them. A line has 64 bytes. A conflict is a lane that stores to an "
      "element that an earlier lane of the same execution stored to.</p>\n",
      observed, pieces, html_escaped(shown_scenes(view)));
}

std::vector<SectionBlock> build(const ReportView& view) {
  constexpr std::string_view kMeans = R"json({
    "transform": [
      {"calculate": "datum.stage + ': ' + datum.mnemonic", "as": "place"}],
    "facet": {"field": "place", "title": null},
    "columns": 4,
    "resolve": {"axis": {"x": "independent"}},
    "spec": {
      "width": 165, "height": 120,
      "mark": {"type": "line", "point": "@point"},
      "encoding": {
        "x": "@lanes",
        "y": {"field": "lines", "type": "quantitative", "title": "Lines/execution"},
        "strokeDash": {"field": "kernel", "title": "Kernel", "sort": null},
        "shape": {"field": "kernel", "title": "Kernel", "sort": null},
        "color": "@stage"}}
  })json";
  constexpr std::string_view kHistograms = R"json({
    "transform": [
      {"calculate": "datum.stage + ': ' + datum.mnemonic", "as": "place"},
      {"calculate": "datum.lines - 0.5", "as": "left"},
      {"calculate": "datum.lines + 0.5", "as": "right"}],
    "facet": {"field": "place", "title": null},
    "columns": 4,
    "resolve": {"axis": {"x": "independent"}},
    "spec": {
      "width": 165, "height": 100,
      "mark": "rect",
      "encoding": {
        "x": {"field": "left", "type": "quantitative", "title": "Lines",
              "scale": {"nice": false, "zero": false},
              "axis": {"format": "d", "tickMinStep": 1, "tickCount": 5, "grid": false}},
        "x2": {"field": "right"},
        "y": {"field": "share", "type": "quantitative", "title": "Executions",
              "axis": {"format": "%", "tickCount": 4}},
        "y2": {"datum": 0},
        "color": "@stage"}}
  })json";
  const Report& report = view.report();
  DataFrame mean_rows = means(view);
  if (mean_rows.empty()) return {};
  std::vector<std::string> names;
  for (const MemoryPlace& place : places_of(report)) names.push_back(place.name());
  auto means_spec = spec_from(kMeans, report);
  if (auto& line = means_spec["spec"]; line["mark"]["point"] == false)
    line["encoding"].erase("shape");
  auto histogram_spec = spec_from(kHistograms, report);
  means_spec["facet"]["sort"] = histogram_spec["facet"]["sort"] = names;
  return {Markup{observed_note(view)},
          Chart{"means",
                "Distinct lines that one execution of a memory instruction touches, " +
                    view.caption() + ". The table has conflicts of scatters, too.",
                std::move(means_spec),
                std::move(mean_rows),
                {pick_of_facet()}},
          Chart{"histograms",
                "Share of the executions that touched so many lines, " + view.caption() + ".",
                std::move(histogram_spec),
                histograms(view),
                {pick_of_kernel(), pick_of_facet(), pick_of_lanes(report)}}};
}

}  // namespace

extern const Section s_memory{
    "memory", "Memory divergence",
    "A gather or scatter costs a real machine as many accesses as it touches lines.", build};

}  // namespace lanescope
