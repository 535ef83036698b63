// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/figures.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::littlest {
namespace {

std::vector<Row> rows(const ReportView& view, const Series& series) {
  if (stages_of(view, series).empty()) return {};
  return {figure_row(view, series, "Project, instr./octant", kPerOctant,
                     [&](int width) { return stage_per_octant(view, series, kProject, width); }),
          figure_row(view, series, "Project, share of all", kPercent,
                     [&](int width) { return mean_stage_share(view, series, kProject, width); })};
}

TableData build(const ReportView& view) {
  TableData data =
      table_over_widths(view, "What the conversion to spherical harmonics takes", "Figure", rows);
  data.notes = {
      "With faces, each of 768 pixels selects what it is worth to four harmonics, and adds it up, "
      "as in the article; with directions, the 256 samples are counted."};
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_project{"project", "instructions of the conversion, and its share",
                                      littlest::build};

}  // namespace lanescope
