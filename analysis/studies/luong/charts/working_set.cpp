// SPDX-License-Identifier: MIT
#include <algorithm>

#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/report/figures.h"
#include "analysis/studies/luong/charts/mp_columns.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

constexpr std::size_t kMostPoints = 120;      ///< Of a course, and of a histogram.
constexpr std::size_t kBarsForEachWidth = 8;  ///< Bars of a histogram between multiples of W.

/// A series of the runs of the view's scenes, added up place by place.
std::vector<std::uint64_t> summed(const ReportView& view, const Series& series, int width,
                                  std::string_view name) {
  std::vector<std::uint64_t> sum;
  for (const std::string& scene : view.scenes()) {
    const RunRecord* run = view.find(series, scene, width);
    const SeriesRecord* found = run ? run->find_series(name) : nullptr;
    if (!found) continue;
    sum.resize(std::max(sum.size(), found->values.size()));
    for (std::size_t i = 0; i < found->values.size(); ++i) sum[i] += found->values[i];
  }
  return sum;
}

/// Sums of `step` places of a list at a time.
std::vector<std::uint64_t> coarser(const std::vector<std::uint64_t>& values, std::size_t step) {
  std::vector<std::uint64_t> sums((values.size() + step - 1) / step);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i / step] += values[i];
  return sums;
}

DataFrame course(const ReportView& view) {
  DataFrame frame(mp_columns({{"bound", "Bound of its packet", ""},
                              {"alive", "Micropolygons alive", ".1f"},
                              {"multiple", "In units of W", ".2f"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : few_widths(view.widths(series))) {
      const auto packets = summed(view, series, width, "working_set_course_packets");
      const auto sums = summed(view, series, width, "working_set_course_sum");
      const std::size_t step = packets.size() / kMostPoints + 1;
      const auto alive = coarser(sums, step);
      const auto observed = coarser(packets, step);
      for (std::size_t i = 0; i < std::min(alive.size(), observed.size()); ++i)
        if (const auto mean = Ratio{alive[i], observed[i]}.value())
          frame.add({shown_kernel(series.kernel), plural(series.facet), width, i * step + 1, *mean,
                     *mean / width});
    }
  return frame;
}

DataFrame histogram(const ReportView& view) {
  DataFrame frame(mp_columns({{"from", "From, in units of W", ".3f"},
                              {"to", "Below", ".3f"},
                              {"share", "Invocations of Bound", ".2%"}}));
  for (const Series& series : series_of(view.report()))
    for (const int width : few_widths(view.widths(series))) {
      const auto all = summed(view, series, width, "working_set_histogram");
      const auto lanes = static_cast<std::size_t>(width);
      const std::size_t step = std::max<std::size_t>(1, lanes / kBarsForEachWidth);
      std::uint64_t invocations = 0;
      for (const std::uint64_t count : all) invocations += count;
      const auto counts = coarser(all, step);
      for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0)
          frame.add({shown_kernel(series.kernel), plural(series.facet), width,
                     static_cast<double>(i * step) / width,
                     static_cast<double>((i + 1) * step) / width,
                     *Ratio{counts[i], invocations}.value()});
    }
  return frame;
}

std::vector<SectionBlock> build(const ReportView& view) {
  constexpr std::string_view kCourse = R"json({
    "transform": [{"calculate": "'W = ' + datum.lanes", "as": "machine"}],
    "facet": {"field": "machine", "title": null, "sort": {"field": "lanes"}},
    "columns": 4,
    "resolve": {"scale": {"x": "independent"}},
    "spec": {
      "width": 175, "height": 150,
      "mark": {"type": "line", "stroke": "currentColor"},
      "encoding": {
        "x": {"field": "bound", "type": "quantitative", "title": "Bound of its packet",
              "axis": {"tickCount": 4, "format": "d"}},
        "y": {"field": "multiple", "type": "quantitative", "title": "Alive, in units of W"}}}
  })json";
  constexpr std::string_view kHistogram = R"json({
    "transform": [{"calculate": "'W = ' + datum.lanes", "as": "machine"}],
    "facet": {"field": "machine", "title": null, "sort": {"field": "lanes"}},
    "columns": 4,
    "spec": {
      "width": 175, "height": 150,
      "mark": {"type": "rect", "fill": "currentColor", "fillOpacity": 0.55},
      "encoding": {
        "x": {"field": "from", "type": "quantitative", "title": "Alive, in units of W",
              "scale": {"nice": false}, "axis": {"tickCount": 4}},
        "x2": {"field": "to"},
        "y": {"field": "share", "type": "quantitative", "title": "Invocations of Bound",
              "axis": {"format": "%"}},
        "y2": {"datum": 0}}}
  })json";
  const Report& report = view.report();
  return {
      Chart{"course",
            "Mean of the micropolygons that REPACK keeps just after the n-th Bound of a packet, "
            "in units of W; all packets of " +
                shown_scenes(view) + " together.",
            spec_from(kCourse, report),
            course(view),
            {pick_of_mp()}},
      Chart{"histogram",
            "Share of the invocations of Bound after which so many micropolygons were alive; "
            "all packets of " +
                shown_scenes(view) + " together.",
            spec_from(kHistogram, report),
            histogram(view),
            {pick_of_mp()}}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_working_set{
    "working-set", "Working set over time",
    "Micropolygons whose vertices the kernel still has to keep, which is what repacking costs in "
    "memory.",
    luong::build};

}  // namespace lanescope
