// SPDX-License-Identifier: MIT
// Rows of figures over W, which tables of any run are made of.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/tables/table.h"

namespace lanescope {

/// In capitals, as papers write kernels.
std::string shown_kernel(std::string_view kernel);
/// `parameter = value`; empty if the kind of work has no facet.
std::string shown_facet(const Series& series);
/// `KERNEL, parameter = value`.
std::string shown(const Series& series);

/// The stages of a series, in the order of its kernel.
std::vector<std::string> stages_of(const ReportView& view, const Series& series);

/// What the instructions of a series are divided by, in short: `mp`.
std::string element_of(const ReportView& view, const Series& series);

/// A row with a cell for each width of the report; empty where the series was not run at it.
Row row_over(const ReportView& view, const Series& series, std::string label,
             const std::function<Cell(int width)>& cell);
/// The same with a figure in each cell.
Row figure_row(const ReportView& view, const Series& series, std::string label, const Unit& unit,
               const std::function<std::optional<double>(int width)>& figure);

/// Utilization of each stage, with its share of all instructions, then of all together. None if
/// nothing was counted, as for the other rows.
std::vector<Row> utilization_rows(const ReportView& view, const Series& series);
/// Instructions for each element: of all stages.
std::vector<Row> instruction_rows(const ReportView& view, const Series& series);
std::vector<Row> metric_rows(const ReportView& view, const Series& series);
std::vector<Row> counter_rows(const ReportView& view, const Series& series);
/// What was counted in the output.
std::vector<Row> output_rows(const ReportView& view, const Series& series);

/// A table with a column for each width and, for each series that has any, a heading and its rows.
TableData table_over_widths(
    const ReportView& view, std::string title, std::string row_header,
    const std::function<std::vector<Row>(const ReportView&, const Series&)>& rows);

}  // namespace lanescope
