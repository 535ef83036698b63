// SPDX-License-Identifier: MIT
#include "analysis/tables/means.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

std::vector<Row> rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows;
  if (!marks_overhead(view, series)) return rows;
  for (const std::string& stage : stages_of(view, series))
    rows.push_back(figure_row(view, series, stage, kPercent, [&](int width) {
      return mean_stage_overhead(view, series, stage, width);
    }));
  rows.push_back(figure_row(view, series, "Overall, all stages", kPercent,
                            [&](int width) { return mean_overhead(view, series, width); }));
  return rows;
}

TableData build(const ReportView& view) {
  TableData data =
      table_over_widths(view, "Overhead: share of the stage's own instructions", "Stage", rows);
  data.notes = {
      "Overhead is work that the baseline of a kernel does not have to do, marked in the kernel "
      "where it is issued. Kernels that mark nothing are left out."};
  return data;
}

}  // namespace

extern const Table t_overhead{"overhead", "instructions that kernels mark as overhead, by stage",
                              build};

}  // namespace lanescope
