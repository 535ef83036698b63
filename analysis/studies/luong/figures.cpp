// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/figures.h"

#include <algorithm>

#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {

std::string plural(std::string_view facet) { return std::string(facet) + 's'; }

std::vector<int> widths_of(const ReportView& view, const Series& series) {
  const std::vector<int> widths = view.widths(series);
  if (widths.empty()) return {kThesisWidths.begin(), kThesisWidths.end()};
  return widths;
}

std::optional<double> stage_share(const ReportView& view, const Series& series,
                                  std::string_view stage, int width, Stages of) {
  return mean_stage_share(view, series, stage, width, of);
}

std::optional<double> overall_utilization(const ReportView& view, const Series& series, int width,
                                          Stages stages) {
  return mean_utilization(view, series, width, stages);
}

std::optional<double> instructions(const ReportView& view, const Series& series, int width,
                                   Stages stages) {
  return mean_instructions(view, series, width, stages);
}

std::optional<double> overhead_over_widths(const ReportView& view, const Series& series,
                                           std::string_view stage) {
  const std::vector<int> widths = widths_of(view, series);
  double sum = 0.0;
  for (const int width : widths) {
    const auto share = mean_stage_overhead(view, series, stage, width);
    if (!share) return std::nullopt;
    sum += *share;
  }
  return sum / static_cast<double>(widths.size());
}

std::optional<double> test_and_load_utilization(const ReportView& view, const Series& series,
                                                int width) {
  return view.mean(series, width, [](const RunRecord& run) {
    return utilization(run, {"Test Stream-load", "Test"}).value();
  });
}

std::optional<double> mean_of_any(const ReportView& view, std::string_view facet,
                                  const RunFigure& figure) {
  std::vector<const RunRecord*> runs;
  for (const std::string& scene : view.scenes()) {
    runs.push_back(view.find_any(facet, scene));
    if (!runs.back()) return std::nullopt;
  }
  return mean_over(runs, figure);
}

std::optional<double> sample_test_efficiency(const ReportView& view, std::string_view facet) {
  return mean_of_any(view, facet,
                     [](const RunRecord& run) { return counter_ratio(run, "hits", "tests"); });
}

std::optional<double> micropolygons_rasterized(const ReportView& view, std::string_view facet) {
  return mean_of_any(view, facet, [](const RunRecord& run) -> std::optional<double> {
    const auto count = run.counter("micropolygons_rasterized");
    if (!count) return std::nullopt;
    return static_cast<double>(*count);
  });
}

std::optional<double> saved_by_quads(const ReportView& view, std::string_view kernel, int width) {
  const Series triangles{std::string(kernel), std::string(kTriangle)};
  const Series quads{std::string(kernel), std::string(kQuad)};
  const auto left = view.mean(quads, width, [&](const RunRecord& run) -> std::optional<double> {
    const RunRecord* other = view.find(triangles, run.configuration.scene, width);
    if (!other) return std::nullopt;
    return Ratio{total(run, kAllButSetup).issued, total(*other, kAllButSetup).issued}.value();
  });
  if (!left) return std::nullopt;
  return 1.0 - *left;
}

std::optional<double> average_working_set(const ReportView& view, const Series& series, int width) {
  return quotient(
      mean_counter_ratio(view, series, width, "working_set_sum", "working_set_observations"),
      width);
}

std::optional<double> largest_working_set(const ReportView& view, const Series& series, int width) {
  std::optional<double> largest;
  for (const std::string& scene : view.scenes()) {
    const RunRecord* run = view.find(series, scene, width);
    const auto alive = run ? run->counter("working_set_maximum") : std::nullopt;
    if (!alive) return std::nullopt;
    largest = std::max(largest.value_or(0.0), static_cast<double>(*alive) / width);
  }
  return largest;
}

std::optional<double> conflicting_invocations(const ReportView& view, const Series& series,
                                              int width) {
  return mean_counter_ratio(view, series, width, "conflict_invocations", "process_issued");
}

std::optional<double> conflicting_hits(const ReportView& view, const Series& series, int width) {
  return mean_counter_ratio(view, series, width, "conflict_hits", "hits");
}

std::optional<double> instructions_per_second(const ReportView& view, const Series& series,
                                              bool before_culling) {
  return view.mean(series, kClaimWidth, [&](const RunRecord& run) -> std::optional<double> {
    const auto each = instructions_per_element(run, kAllButSetup);
    const auto count =
        run.counter(before_culling ? "micropolygons_seen" : "micropolygons_rasterized");
    if (!each || !count) return std::nullopt;
    return *each * static_cast<double>(*count) * kFramesPerSecond;
  });
}

std::optional<double> instructions_of_a_unit() {
  return quotient(thesis_value({"text_claims", "larrabee_units_at_60fps", "vector_ops_per_second"}),
                  thesis_value({"text_claims", "larrabee_units_at_60fps", "triangles"}));
}

}  // namespace lanescope::luong
