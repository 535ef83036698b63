// SPDX-License-Identifier: MIT
// The figures that tables and charts show of a series: means over the scenes of a view of each
// scene's ratio. None where a scene lacks the run, the run lacks the stage, or nothing was counted.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/report/figures.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

std::optional<double> mean_stage_utilization(const ReportView& view, const Series& series,
                                             std::string_view stage, int width);
/// Instructions of a stage over those of all stages of `of`.
std::optional<double> mean_stage_share(const ReportView& view, const Series& series,
                                       std::string_view stage, int width, Stages of = {});
/// Of all those stages together.
std::optional<double> mean_utilization(const ReportView& view, const Series& series, int width,
                                       Stages stages = {});
/// Instructions for each element.
std::optional<double> mean_instructions(const ReportView& view, const Series& series, int width,
                                        Stages stages = {});
std::optional<double> mean_stage_instructions(const ReportView& view, const Series& series,
                                              std::string_view stage, int width);
/// Share of a stage's instructions that the kernel marks as overhead.
std::optional<double> mean_stage_overhead(const ReportView& view, const Series& series,
                                          std::string_view stage, int width);
std::optional<double> mean_overhead(const ReportView& view, const Series& series, int width);
std::optional<double> mean_counter_ratio(const ReportView& view, const Series& series, int width,
                                         std::string_view numerator, std::string_view denominator);

/// Whether the kernel of a series marks instructions as overhead.
bool marks_overhead(const ReportView& view, const Series& series);

/// What instructions are gathered by: their class, or their mnemonic.
using InstructionName = std::function<std::string(const InstructionRecord&)>;

/// The class of an instruction, from the dictionary of the report.
InstructionName class_in(const Report& report);

/// Instructions for each element, by name, of one stage.
std::map<std::string, double> mean_mix(const ReportView& view, const Series& series, int width,
                                       std::string_view stage, const InstructionName& name);

/// a / b; none where either is missing or b is 0.
std::optional<double> quotient(std::optional<double> a, std::optional<double> b);

}  // namespace lanescope
