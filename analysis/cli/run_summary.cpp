// SPDX-License-Identifier: MIT
#include "analysis/cli/run_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/figures.h"

namespace lanescope {
namespace {

using Runs = std::vector<const RunRecord*>;

bool same_series(const RunRecord& a, const RunRecord& b) {
  return a.configuration.kernel == b.configuration.kernel &&
         a.configuration.scene == b.configuration.scene &&
         a.configuration.shape() == b.configuration.shape();
}

/// Runs that differ in nothing but the width.
std::vector<Runs> by_series(const Report& report) {
  std::vector<Runs> all;
  for (const RunRecord& run : report.runs) {
    auto place = std::find_if(all.begin(), all.end(),
                              [&](const Runs& runs) { return same_series(*runs.front(), run); });
    if (place == all.end()) place = all.insert(all.end(), Runs{});
    place->push_back(&run);
  }
  return all;
}

Row figure_row(std::string label, const Runs& runs, const RunFigure& figure, const Unit& unit) {
  Row row{std::move(label), {}};
  for (const RunRecord* run : runs) row.cells.push_back({Figure{figure(*run), {}, &unit}, {}, {}});
  return row;
}

/// Utilization of a stage, with its share of all instructions.
Row stage_row(std::size_t stage, const Runs& runs) {
  Row row{runs.front()->stages[stage].name, {}};
  for (const RunRecord* run : runs) {
    const StageRecord& record = run->stages[stage];
    const Ratio share{record.total().issued, total(*run, Stages::kAll).issued};
    row.cells.push_back(
        {Figure{utilization(record, run->configuration.width).value(), {}, &kPercent},
         Figure{share.value(), {}, &kShare},
         {}});
  }
  return row;
}

void add_instruction_rows(TableData& data, const Runs& runs) {
  for (std::size_t stage = 0; stage < runs.front()->stages.size(); ++stage)
    data.rows.push_back(stage_row(stage, runs));
  if (runs.front()->stages.empty()) return;
  data.rows.push_back(figure_row(
      "Overall", runs, [](const RunRecord& run) { return utilization(run, Stages::kAll).value(); },
      kPercent));
  data.rows.push_back(figure_row(
      "Instr./mp", runs,
      [](const RunRecord& run) { return instructions_per_micropolygon(run, Stages::kAll); },
      kInstructions));
}

void add_metric_rows(TableData& data, const Runs& runs) {
  for (const MetricRecord& metric : runs.front()->metrics)
    data.rows.push_back(figure_row(
        metric.name, runs,
        [&](const RunRecord& run) {
          return counter_ratio(run, metric.numerator, metric.denominator);
        },
        kMeasure));
}

void add_counter_rows(TableData& data, const Runs& runs) {
  for (const CounterRecord& counter : runs.front()->counters)
    data.rows.push_back(figure_row(
        counter.name, runs,
        [&](const RunRecord& run) -> std::optional<double> {
          const auto value = run.counter(counter.name);
          if (!value) return std::nullopt;
          return static_cast<double>(*value);
        },
        kCount));
}

TableData summary(const Runs& runs) {
  const Configuration& c = runs.front()->configuration;
  TableData data;
  data.name = "run";
  data.caption =
      fmt::format("frame {}, {}x{}, {} samples a pixel", c.frame, c.tessellation.width_px,
                  c.tessellation.height_px, c.samples_per_pixel);
  data.title = fmt::format("{} on {}, {}s", c.kernel, c.scene, to_string(c.shape()));
  data.row_header = "Utilization (share of the instructions)";
  for (const RunRecord* run : runs)
    data.columns.push_back(fmt::format("W = {}", run->configuration.width));
  add_instruction_rows(data, runs);
  data.rows.push_back({"Metrics", {}});
  add_metric_rows(data, runs);
  data.rows.push_back({"Counts", {}});
  add_counter_rows(data, runs);
  return data;
}

}  // namespace

std::vector<TableData> run_summaries(const Report& report) {
  std::vector<TableData> tables;
  for (const Runs& runs : by_series(report)) tables.push_back(summary(runs));
  return tables;
}

}  // namespace lanescope
