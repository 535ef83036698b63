// SPDX-License-Identifier: MIT

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

Row stage_row(const ReportView& view, std::string_view stage) {
  Row row{std::string(stage), {}};
  for (const int width : widths_of(view, kRepackTriangle)) {
    const auto share = mean_stage_overhead(view, kRepackTriangle, stage, width);
    row.cells.push_back({Figure{share, {}, &kPercent}, {}, {}});
  }
  row.cells.push_back({Figure{overhead_over_widths(view, kRepackTriangle, stage),
                              thesis_value({"table_4_3", "overhead", stage}), &kPercent},
                       {},
                       {}});
  return row;
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Table 4.3: REPACK, triangles: overhead of each stage";
  data.row_header = "Stage";
  data.columns = width_headers(widths_of(view, kRepackTriangle));
  data.columns.push_back("Mean over W");
  for (const std::string_view stage : kThesisStages) data.rows.push_back(stage_row(view, stage));
  data.notes = {
      "The share of the stage's own instructions that REPACK spends and LOCKSTEP does not: loading "
      "from, compacting into and scheduling of buffers, marked in the kernel where it is issued.",
      "The thesis gives one figure for each stage and does not say at which width."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_overhead{"overhead",
                                    "table 4.3: what REPACK spends on its buffers, by stage",
                                    luong::compared<luong::build>};

}  // namespace lanescope
