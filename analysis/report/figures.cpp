// SPDX-License-Identifier: MIT
#include "analysis/report/figures.h"

namespace lanescope {
namespace {

Ratio busy_lanes(const InstructionRecord& counts, int width) {
  return {counts.active, counts.issued * static_cast<std::uint64_t>(width)};
}

std::optional<double> per_element(const RunRecord& run, std::uint64_t issued) {
  const auto elements = run.elements();
  if (!elements) return std::nullopt;
  return Ratio{issued, *elements}.value();
}

}  // namespace

std::optional<double> Ratio::value() const {
  if (denominator == 0) return std::nullopt;
  return static_cast<double>(numerator) / static_cast<double>(denominator);
}

Ratio utilization(const StageRecord& stage, int width) { return busy_lanes(stage.total(), width); }

InstructionRecord total(const RunRecord& run, Stages stages) {
  InstructionRecord sum;
  for (const StageRecord& stage : run.stages)
    if (stages.has(stage.name)) sum += stage.total();
  return sum;
}

Ratio utilization(const RunRecord& run, Stages stages) {
  return busy_lanes(total(run, stages), run.configuration.width);
}

Ratio utilization(const RunRecord& run, std::initializer_list<std::string_view> stages) {
  InstructionRecord sum;
  for (const std::string_view name : stages)
    if (const StageRecord* stage = run.stage(name)) sum += stage->total();
  return busy_lanes(sum, run.configuration.width);
}

std::optional<double> instructions_per_element(const RunRecord& run, Stages stages) {
  if (run.stages.empty()) return std::nullopt;
  return per_element(run, total(run, stages).issued);
}

std::optional<double> instructions_per_element(const RunRecord& run, std::string_view stage) {
  const StageRecord* found = run.stage(stage);
  return found ? per_element(run, found->total().issued) : std::nullopt;
}

std::optional<double> counter_ratio(const RunRecord& run, std::string_view numerator,
                                    std::string_view denominator) {
  const auto above = run.counter(numerator);
  const auto below = run.counter(denominator);
  if (!above || !below) return std::nullopt;
  return Ratio{*above, *below}.value();
}

}  // namespace lanescope
