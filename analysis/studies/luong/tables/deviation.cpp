// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/tables/deviation.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/tables/utilization.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

using CellFigure = Figure (*)(const ReportView&, const UtilizationTable&, std::string_view, int);

/// Adds the cells of some rows of a table.
void add_cells(Deviation& deviation, const ReportView& view, const UtilizationTable& table,
               const std::vector<std::string_view>& rows, CellFigure figure_of) {
  for (const std::string_view row : rows)
    for (const int width : kThesisWidths)
      deviation.add(figure_of(view, table, row, width),
                    fmt::format("{} at W = {} of {}", row, width, table.number));
}

Deviation facet_deviation(const ReportView& view, std::string_view facet, CellFigure figure_of) {
  Deviation deviation;
  for (const UtilizationTable& table : utilization_tables())
    if (table.series.facet == facet)
      add_cells(deviation, view, table, thesis_stages(table), figure_of);
  return deviation;
}

Row deviation_row(const std::string& label, const Deviation& deviation) {
  const auto points = [&](std::optional<double> value) {
    return Cell{Figure{value, {}, &kPoints}, {}, {}};
  };
  const auto largest =
      deviation.cells > 0 ? std::optional(std::abs(deviation.largest)) : std::nullopt;
  return {
      label,
      {Cell{Figure{deviation.cells, {}, &kCount}, {}, {}}, points(largest),
       points(deviation.root_mean_square(deviation.rounded_squares)),
       points(deviation.root_mean_square(deviation.exact_squares)), Cell{{}, {}, deviation.where}}};
}

/// Adds a row for the stages of each of the four tables, and for those of triangles and of quads.
void add_stages(TableData& data, const ReportView& view, std::string_view what,
                CellFigure figure_of) {
  Deviation triangles, quads;
  for (const UtilizationTable& table : utilization_tables()) {
    Deviation alone;
    add_cells(alone, view, table, thesis_stages(table), figure_of);
    add_cells(table.series.facet == kTriangle ? triangles : quads, view, table,
              thesis_stages(table), figure_of);
    data.rows.push_back(deviation_row(fmt::format("{} of {}", what, table.number), alone));
  }
  data.rows.push_back(deviation_row(fmt::format("{}, triangles", what), triangles));
  data.rows.push_back(deviation_row(fmt::format("{}, quads", what), quads));
}

TableData of_thesis_cells(const ReportView& view) {
  TableData data;
  data.title = "Deviation from the thesis's utilization and shares of the instructions, in points";
  data.row_header = "Cells";
  data.columns = {"Cells", "Largest", "RMS", "RMS, unrounded", "Largest at"};
  add_stages(data, view, "Stages", utilization_figure);
  Deviation overall;
  for (const UtilizationTable& table : utilization_tables())
    add_cells(overall, view, table, {"Overall"}, utilization_figure);
  data.rows.push_back(deviation_row("Overall, all four", overall));
  add_stages(data, view, "Shares", share_figure);
  data.notes = {
      "Stages and Overall are of utilization, Shares of the instructions of a stage over those of "
      "all; all without Setup. Both numbers are rounded to whole percents first, as the thesis "
      "rounds, unless said otherwise."};
  return data;
}

/// Figures of something else deviate from nothing.
TableData build(const ReportView& view) {
  TableData data = of_thesis_cells(view);
  if (differences_from_thesis(view).empty()) return data;
  for (Row& row : data.rows) {
    row.cells.assign(data.columns.size(), Cell{});
    row.cells.back().words = kNotComparable;
  }
  return data;
}

}  // namespace

void Deviation::add(const Figure& figure, const std::string& place) {
  if (!has_difference(figure)) return;
  const double rounded = *rounded_difference(figure) * kPercent.scale / figure.unit->scale;
  const double exact = kPercent.scale * (*figure.ours - *figure.paper);
  ++cells;
  rounded_squares += rounded * rounded;
  exact_squares += exact * exact;
  if (std::abs(rounded) <= std::abs(largest)) return;
  largest = rounded;
  where = place;
}

std::optional<double> Deviation::root_mean_square(double squares) const {
  if (cells == 0) return std::nullopt;
  return std::sqrt(squares / cells);
}

Deviation stage_deviation(const ReportView& view, std::string_view facet) {
  return facet_deviation(view, facet, utilization_figure);
}

Deviation share_deviation(const ReportView& view, std::string_view facet) {
  return facet_deviation(view, facet, share_figure);
}

}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_deviation{"deviation", "how far utilization is from the thesis's tables",
                                     luong::compared<luong::build>};

}  // namespace lanescope
