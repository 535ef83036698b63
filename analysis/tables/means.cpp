// SPDX-License-Identifier: MIT
#include "analysis/tables/means.h"

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

std::optional<double> overhead(const InstructionRecord& counts) {
  return Ratio{counts.overhead_issued, counts.issued}.value();
}

}  // namespace

std::optional<double> mean_stage_utilization(const ReportView& view, const Series& series,
                                             std::string_view stage, int width) {
  return stage_mean(view, series, stage, width, [&](const RunRecord&, const StageRecord& found) {
    return utilization(found, width).value();
  });
}

std::optional<double> mean_stage_share(const ReportView& view, const Series& series,
                                       std::string_view stage, int width, Stages of) {
  return stage_mean(view, series, stage, width,
                    [&](const RunRecord& run, const StageRecord& found) {
                      return Ratio{found.total().issued, total(run, of).issued}.value();
                    });
}

std::optional<double> mean_utilization(const ReportView& view, const Series& series, int width,
                                       Stages stages) {
  return view.mean(series, width,
                   [&](const RunRecord& run) { return utilization(run, stages).value(); });
}

std::optional<double> mean_instructions(const ReportView& view, const Series& series, int width,
                                        Stages stages) {
  return view.mean(series, width,
                   [&](const RunRecord& run) { return instructions_per_element(run, stages); });
}

std::optional<double> mean_stage_instructions(const ReportView& view, const Series& series,
                                              std::string_view stage, int width) {
  return view.mean(series, width,
                   [&](const RunRecord& run) { return instructions_per_element(run, stage); });
}

std::optional<double> mean_stage_overhead(const ReportView& view, const Series& series,
                                          std::string_view stage, int width) {
  return stage_mean(view, series, stage, width, [](const RunRecord&, const StageRecord& found) {
    return overhead(found.total());
  });
}

std::optional<double> mean_overhead(const ReportView& view, const Series& series, int width) {
  return view.mean(series, width, [](const RunRecord& run) { return overhead(total(run)); });
}

std::optional<double> mean_counter_ratio(const ReportView& view, const Series& series, int width,
                                         std::string_view numerator, std::string_view denominator) {
  return view.mean(series, width, [&](const RunRecord& run) {
    return counter_ratio(run, numerator, denominator);
  });
}

bool marks_overhead(const ReportView& view, const Series& series) {
  const std::vector<int> widths = view.widths(series);
  return std::any_of(widths.begin(), widths.end(), [&](int width) {
    return mean_overhead(view, series, width).value_or(0.0) > 0.0;
  });
}

InstructionName class_in(const Report& report) {
  std::map<std::string, std::string> classes;
  for (const InstructionEntry& entry : report.instructions)
    classes[entry.mnemonic] = entry.instruction_class;
  return [classes](const InstructionRecord& counts) {
    const auto found = classes.find(counts.mnemonic);
    return found == classes.end() ? std::string() : found->second;
  };
}

std::map<std::string, double> mean_mix(const ReportView& view, const Series& series, int width,
                                       std::string_view stage, const InstructionName& name) {
  std::map<std::string, double> means;
  const std::vector<const RunRecord*> runs = view.runs(series, width);
  for (const RunRecord* run : runs) {
    const StageRecord* found = run->stage(stage);
    const auto elements = run->elements();
    if (!found || !elements) continue;
    for (const InstructionRecord& counts : found->instructions)
      means[name(counts)] +=
          Ratio{counts.issued, *elements}.value().value_or(0.0) / static_cast<double>(runs.size());
  }
  return means;
}

std::optional<double> quotient(std::optional<double> a, std::optional<double> b) {
  if (!a || !b || *b == 0.0) return std::nullopt;
  return *a / *b;
}

}  // namespace lanescope
