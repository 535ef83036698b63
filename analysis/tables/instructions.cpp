// SPDX-License-Identifier: MIT
#include "analysis/tables/means.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

/// Of each stage, then of all.
std::vector<Row> rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows;
  for (const std::string& stage : stages_of(view, series))
    rows.push_back(figure_row(view, series, stage, kInstructions, [&](int width) {
      return mean_stage_instructions(view, series, stage, width);
    }));
  for (Row& all : instruction_rows(view, series)) rows.push_back(std::move(all));
  return rows;
}

TableData build(const ReportView& view) {
  return table_over_widths(view, "Instructions for each element", "Stage", rows);
}

}  // namespace

extern const Table t_instructions{"instructions", "instructions for each element, by stage", build};

}  // namespace lanescope
