// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/report/figures.h"

namespace lanescope {
namespace {

/// A memory instruction of a stage.
struct Place {
  std::string stage;
  std::string mnemonic;
  std::string name() const { return stage + ": " + mnemonic; }
};

const MemoryRecord* find(const RunRecord& run, const Place& place) {
  const StageRecord* stage = run.stage(place.stage);
  if (!stage) return nullptr;
  const auto found = std::find_if(stage->memory.begin(), stage->memory.end(),
                                  [&](const auto& m) { return m.mnemonic == place.mnemonic; });
  return found == stage->memory.end() ? nullptr : &*found;
}

/// In the order of stages, then of mnemonics.
std::vector<Place> places_of(const Report& report) {
  std::vector<Place> places;
  for (const std::string& stage : stages_of(report)) {
    std::set<std::string> mnemonics;
    for (const RunRecord& run : report.runs)
      if (const StageRecord* found = run.stage(stage))
        for (const MemoryRecord& memory : found->memory) mnemonics.insert(memory.mnemonic);
    for (const std::string& mnemonic : mnemonics) places.push_back({stage, mnemonic});
  }
  return places;
}

/// A quotient of two counts of a memory instruction, as a mean over the scenes.
template <class Above, class Below>
std::optional<double> mean(const ReportView& view, const Series& series, int width,
                           const Place& place, const Above& above, const Below& below) {
  return view.mean(series, width, [&](const RunRecord& run) {
    const MemoryRecord* memory = find(run, place);
    return memory ? Ratio{above(*memory), below(*memory)}.value() : std::nullopt;
  });
}

std::uint64_t issued(const MemoryRecord& memory) { return memory.issued; }
std::uint64_t active(const MemoryRecord& memory) { return memory.active; }
std::uint64_t lines(const MemoryRecord& memory) { return memory.lines; }
std::uint64_t conflicts(const MemoryRecord& memory) { return memory.conflicts; }

std::vector<DataColumn> columns(std::vector<DataColumn> others) {
  std::vector<DataColumn> all =
      series_columns({{"stage", "Stage", ""}, {"mnemonic", "Instruction", ""}});
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

template <class Add>
void for_each_place(const ReportView& view, const Add& add) {
  const std::vector<Place> places = places_of(view.report());
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series))
      for (const Place& place : places) add(series, width, place);
}

DataFrame means(const ReportView& view) {
  DataFrame frame(columns({{"lines", "Lines/execution", ".2f"},
                           {"active", "Lanes on/execution", ".2f"},
                           {"conflicts", "Conflicts/lane", ".3%"}}));
  for_each_place(view, [&](const Series& series, int width, const Place& place) {
    const auto touched = mean(view, series, width, place, lines, issued);
    if (!touched) return;
    frame.add({shown_kernel(series.kernel), shown_shape(series.shape), width, place.stage,
               place.mnemonic, *touched,
               number_or_null(mean(view, series, width, place, active, issued)),
               number_or_null(mean(view, series, width, place, conflicts, active))});
  });
  return frame;
}

DataFrame histograms(const ReportView& view) {
  DataFrame frame(columns({{"lines", "Lines", ""}, {"share", "Executions", ".2%"}}));
  for_each_place(view, [&](const Series& series, int width, const Place& place) {
    for (std::size_t k = 0; k <= static_cast<std::size_t>(width); ++k) {
      const auto share = mean(
          view, series, width, place,
          [&](const MemoryRecord& memory) {
            return k < memory.lines_histogram.size() ? memory.lines_histogram[k] : 0;
          },
          issued);
      if (share.value_or(0.0) > 0.0)
        frame.add({shown_kernel(series.kernel), shown_shape(series.shape), width, place.stage,
                   place.mnemonic, k, *share});
    }
  });
  return frame;
}

std::string observed_note(const Report& report) {
  std::uint64_t packets = 0, observed = 0;
  for (const RunRecord& run : report.runs) {
    packets += run.observation.packets;
    observed += run.observation.packets_observed;
  }
  return fmt::format(
      "<p class=\"note\">Seen in {} of {} packets, which were observed (observe_every); the other "
      "sections count all packets. A line has 64 bytes. A conflict is a lane that stores to an "
      "element that an earlier lane of the same execution stored to.</p>\n",
      observed, packets);
}

std::vector<Block> build(const ReportView& view) {
  constexpr std::string_view kMeans = R"json({
    "transform": [
      {"filter": "datum.micropolygon == pick_shape"},
      {"calculate": "datum.stage + ': ' + datum.mnemonic", "as": "place"}],
    "facet": {"field": "place", "title": null},
    "columns": 4,
    "resolve": {"axis": {"x": "independent"}},
    "spec": {
      "width": 165, "height": 120,
      "mark": {"type": "line", "point": {"size": 45}},
      "encoding": {
        "x": "@lanes",
        "y": {"field": "lines", "type": "quantitative", "title": "Lines/execution"},
        "strokeDash": {"field": "kernel", "title": "Kernel", "sort": null},
        "shape": {"field": "kernel", "title": "Kernel", "sort": null},
        "color": "@stage"}}
  })json";
  constexpr std::string_view kHistograms = R"json({
    "transform": [
      {"filter": "datum.kernel == pick_kernel && datum.micropolygon == pick_shape"},
      {"filter": "datum.lanes == pick_lanes"},
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
  std::vector<std::string> names;
  for (const Place& place : places_of(report)) names.push_back(place.name());
  auto means_spec = spec_from(kMeans, report);
  means_spec["params"] = {choice_of_shape(report)};
  auto histogram_spec = spec_from(kHistograms, report);
  histogram_spec["params"] = {choice_of_kernel(report), choice_of_shape(report),
                              choice_of_lanes(report)};
  means_spec["facet"]["sort"] = histogram_spec["facet"]["sort"] = names;
  return {Markup{observed_note(report)},
          Chart{"means",
                "Distinct lines that one execution of a memory instruction touches, " +
                    view.caption() + ". The table has conflicts of scatters, too.",
                std::move(means_spec), means(view)},
          Chart{"histograms",
                "Share of the executions that touched so many lines, " + view.caption() + ".",
                std::move(histogram_spec), histograms(view)}};
}

}  // namespace

extern const Section s_memory{
    "memory", "Memory divergence",
    "A gather or scatter costs a real machine as many accesses as it touches lines.", build};

}  // namespace lanescope
