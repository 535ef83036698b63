// SPDX-License-Identifier: MIT
#include "analysis/tables/thesis_figures.h"

#include <algorithm>

namespace lanescope {
namespace {

/// Figure of a stage; none for runs that do not have the stage.
template <class StageFigure>
std::optional<double> stage_mean(const ReportView& view, const Series& series,
                                 std::string_view stage, int width, const StageFigure& figure) {
  return view.mean(series, width, [&](const RunRecord& run) -> std::optional<double> {
    const StageRecord* found = run.stage(stage);
    return found ? figure(run, *found) : std::nullopt;
  });
}

std::optional<double> counter_mean(const ReportView& view, const Series& series, int width,
                                   std::string_view numerator, std::string_view denominator) {
  return view.mean(series, width, [&](const RunRecord& run) {
    return counter_ratio(run, numerator, denominator);
  });
}

}  // namespace

std::optional<double> quotient(std::optional<double> a, std::optional<double> b) {
  if (!a || !b || *b == 0.0) return std::nullopt;
  return *a / *b;
}

std::optional<double> stage_utilization(const ReportView& view, const Series& series,
                                        std::string_view stage, int width) {
  return stage_mean(view, series, stage, width, [&](const RunRecord&, const StageRecord& found) {
    return utilization(found, width).value();
  });
}

std::optional<double> stage_share(const ReportView& view, const Series& series,
                                  std::string_view stage, int width, Stages of) {
  return stage_mean(view, series, stage, width,
                    [&](const RunRecord& run, const StageRecord& found) {
                      return Ratio{found.total().issued, total(run, of).issued}.value();
                    });
}

std::optional<double> overall_utilization(const ReportView& view, const Series& series, int width,
                                          Stages stages) {
  return view.mean(series, width,
                   [&](const RunRecord& run) { return utilization(run, stages).value(); });
}

std::optional<double> instructions(const ReportView& view, const Series& series, int width,
                                   Stages stages) {
  return view.mean(series, width, [&](const RunRecord& run) {
    return instructions_per_micropolygon(run, stages);
  });
}

std::optional<double> stage_instructions(const ReportView& view, const Series& series,
                                         std::string_view stage, int width) {
  return view.mean(series, width,
                   [&](const RunRecord& run) { return instructions_per_micropolygon(run, stage); });
}

std::optional<double> overhead_share(const ReportView& view, const Series& series,
                                     std::string_view stage, int width) {
  return stage_mean(view, series, stage, width, [](const RunRecord&, const StageRecord& found) {
    const InstructionRecord sum = found.total();
    return Ratio{sum.overhead_issued, sum.issued}.value();
  });
}

std::optional<double> mean_overhead_share(const ReportView& view, const Series& series,
                                          std::string_view stage) {
  const std::vector<int> widths = view.widths(series);
  double sum = 0.0;
  for (const int width : widths) {
    const auto share = overhead_share(view, series, stage, width);
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

std::optional<double> sample_test_efficiency(const ReportView& view, Micropolygon shape) {
  return view.mean(shape, [](const RunRecord& run) { return counter_ratio(run, "hits", "tests"); });
}

std::optional<double> micropolygons_rasterized(const ReportView& view, Micropolygon shape) {
  return view.mean(shape, [](const RunRecord& run) -> std::optional<double> {
    const auto count = run.counter("micropolygons_rasterized");
    if (!count) return std::nullopt;
    return static_cast<double>(*count);
  });
}

std::optional<double> saved_by_quads(const ReportView& view, std::string_view kernel, int width) {
  const Series triangles{kernel, Micropolygon::kTriangle};
  const Series quads{kernel, Micropolygon::kQuad};
  const auto left = view.mean(quads, width, [&](const RunRecord& run) -> std::optional<double> {
    const RunRecord* other = view.find(triangles, run.configuration.scene, width);
    if (!other) return std::nullopt;
    return Ratio{total(run, Stages::kThesis).issued, total(*other, Stages::kThesis).issued}.value();
  });
  if (!left) return std::nullopt;
  return 1.0 - *left;
}

std::optional<double> average_working_set(const ReportView& view, const Series& series, int width) {
  return quotient(counter_mean(view, series, width, "working_set_sum", "working_set_observations"),
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
  return counter_mean(view, series, width, "conflict_invocations", "process_issued");
}

std::optional<double> conflicting_hits(const ReportView& view, const Series& series, int width) {
  return counter_mean(view, series, width, "conflict_hits", "hits");
}

std::optional<double> instructions_per_second(const ReportView& view, Micropolygon shape,
                                              bool before_culling) {
  constexpr double kFramesPerSecond = 60.0;
  const Series series{"lockstep", shape};
  return view.mean(series, kClaimWidth, [&](const RunRecord& run) -> std::optional<double> {
    const auto each = instructions_per_micropolygon(run, Stages::kThesis);
    const auto count =
        run.counter(before_culling ? "micropolygons_seen" : "micropolygons_rasterized");
    if (!each || !count) return std::nullopt;
    return *each * static_cast<double>(*count) * kFramesPerSecond;
  });
}

}  // namespace lanescope
