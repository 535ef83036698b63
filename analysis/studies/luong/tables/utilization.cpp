// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/tables/utilization.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"
#include "analysis/tables/series_rows.h"
#include "simulator/base/error.h"

namespace lanescope::luong {
namespace {

constexpr std::string_view kOverall = "Overall";

/// A row with a cell for each width.
template <class MakeCell>
Row width_row(const std::string& label, const std::vector<int>& widths, const MakeCell& make_cell) {
  Row row{label, {}};
  for (const int width : widths) row.cells.push_back(make_cell(width));
  return row;
}

Row stage_row(const ReportView& view, const UtilizationTable& table, std::string_view stage) {
  return width_row(std::string(stage), widths_of(view, table.series), [&](int width) {
    return Cell{
        utilization_figure(view, table, stage, width), share_figure(view, table, stage, width), {}};
  });
}

Row setup_row(const ReportView& view, const Series& series) {
  return width_row("Setup *", widths_of(view, series), [&](int width) {
    const Figure busy{mean_stage_utilization(view, series, kSetup, width), {}, &kPercent};
    const Figure share{stage_share(view, series, kSetup, width, Stages{}), {}, &kShare};
    return Cell{busy, share, {}};
  });
}

void add_rows_with_setup(TableData& data, const ReportView& view, const Series& series) {
  const std::vector<int> widths = widths_of(view, series);
  data.rows.push_back(setup_row(view, series));
  data.rows.push_back(width_row("Overall, all stages", widths, [&](int width) {
    return Cell{Figure{overall_utilization(view, series, width, Stages{}), {}, &kPercent}, {}, {}};
  }));
  data.rows.push_back(width_row("Instr./mp, all stages", widths, [&](int width) {
    return Cell{
        Figure{instructions(view, series, width, Stages{}), {}, &kInstructionsPerMp}, {}, {}};
  }));
}

}  // namespace

const std::vector<UtilizationTable>& utilization_tables() {
  static const std::vector<UtilizationTable> all{{"4.1", "table_4_1", kLockstepTriangle},
                                                 {"4.2", "table_4_2", kRepackTriangle},
                                                 {"4.4", "table_4_4", kLockstepQuad},
                                                 {"4.5", "table_4_5", kRepackQuad}};
  return all;
}

const UtilizationTable& utilization_table(std::string_view number) {
  const auto& all = utilization_tables();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& t) { return t.number == number; });
  LANESCOPE_CHECK(found != all.end(), "table {}", number);
  return *found;
}

std::vector<std::string_view> thesis_stages(const UtilizationTable& table) {
  std::vector<std::string_view> stages;
  for (const std::string_view stage : kThesisStages)
    if (thesis_value({table.thesis_key, "utilization", stage}, kThesisWidths.front()))
      stages.push_back(stage);
  return stages;
}

Figure utilization_figure(const ReportView& view, const UtilizationTable& table,
                          std::string_view stage, int width) {
  const auto ours = stage == kOverall ? overall_utilization(view, table.series, width)
                                      : mean_stage_utilization(view, table.series, stage, width);
  return {ours, thesis_value({table.thesis_key, "utilization", stage}, width), &kPercent};
}

Figure share_figure(const ReportView& view, const UtilizationTable& table, std::string_view stage,
                    int width) {
  return {stage_share(view, table.series, stage, width),
          thesis_value({table.thesis_key, "fraction_of_time", stage}, width), &kShare};
}

TableData build_utilization(const ReportView& view, const UtilizationTable& table) {
  const Series& series = table.series;
  const std::vector<int> widths = widths_of(view, series);
  TableData data;
  data.title =
      fmt::format("Table {}: {}, {}: utilization (share of the instructions, without Setup)",
                  table.number, shown_kernel(series.kernel), plural(series.facet));
  data.row_header = "Stage";
  data.columns = width_headers(widths);
  for (const std::string_view stage : thesis_stages(table))
    data.rows.push_back(stage_row(view, table, stage));
  data.rows.push_back(width_row("Overall, without Setup", widths, [&](int width) {
    return Cell{utilization_figure(view, table, kOverall, width), {}, {}};
  }));
  data.rows.push_back(width_row("Instr./mp, without Setup", widths, [&](int width) {
    return Cell{Figure{instructions(view, series, width),
                       thesis_value({table.thesis_key, "ops_per_mp"}, width), &kInstructionsPerMp},
                {},
                {}};
  }));
  add_rows_with_setup(data, view, series);
  data.notes = {
      "Utilization is active lanes / (instructions x W); instructions are vector instructions, for "
      "each micropolygon (mp) that is rasterized.",
      "A difference is ours minus the paper's: of utilizations and, in parentheses, of shares in "
      "points, of instructions in percent.",
      "* The thesis leaves Setup out of its tables, and so do all other shares here; that of Setup "
      "is of all stages."};
  return data;
}

}  // namespace lanescope::luong
