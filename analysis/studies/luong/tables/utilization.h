// SPDX-License-Identifier: MIT
// Tables 4.1, 4.2, 4.4 and 4.5 of the thesis are one table of four series.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/tables/report_view.h"
#include "analysis/tables/table.h"

namespace lanescope::luong {

/// One of the four: where the thesis has it, and the series that it shows.
struct UtilizationTable {
  std::string_view number;
  std::string_view thesis_key;  ///< Member of data/thesis-tables.json.
  Series series;
};

/// The four, in the order of the thesis.
const std::vector<UtilizationTable>& utilization_tables();

/// The one of that number. Requires that there is one.
const UtilizationTable& utilization_table(std::string_view number);

/// Rows: the stages, Overall, instructions per micropolygon; then Setup and the sums over all
/// stages. Columns: the widths. Cells: utilization, and the share of the instructions.
TableData build_utilization(const ReportView& view, const UtilizationTable& table);

/// Stages of the thesis's table.
std::vector<std::string_view> thesis_stages(const UtilizationTable& table);

/// Utilization of a stage at a width, or of "Overall", beside the thesis's.
Figure utilization_figure(const ReportView& view, const UtilizationTable& table,
                          std::string_view stage, int width);

/// A stage's share of the instructions at a width, beside the thesis's.
Figure share_figure(const ReportView& view, const UtilizationTable& table, std::string_view stage,
                    int width);

}  // namespace lanescope::luong
