// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/figures.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::littlest {
namespace {

std::vector<Row> rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows = utilization_rows(view, series);
  if (rows.empty()) return rows;
  for (Row& row : instruction_rows(view, series)) rows.push_back(std::move(row));
  rows.push_back(figure_row(view, series, "Instr./octant, all stages", kPerOctant,
                            [&](int width) { return per_octant(view, series, width); }));
  return rows;
}

TableData build(const ReportView& view) {
  TableData data = table_over_widths(
      view, "Utilization of each stage (share of the instructions), and instructions", "Stage",
      rows);
  data.notes = {
      "Utilization is active lanes / (instructions x W). A probe is a corner with its eight "
      "octants; instructions for an octant are over those rendered, which no cube at the corner "
      "blocks."};
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_utilization{
    "utilization", "utilization and instructions of each program, by stage and width",
    littlest::build};

}  // namespace lanescope
