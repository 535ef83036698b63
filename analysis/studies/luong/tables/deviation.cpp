// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/tables/utilization.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

/// Differences in points of utilization, gathered cell by cell.
struct Deviation {
  int cells = 0;
  double largest = 0.0;
  std::string where = "-";
  double rounded_squares = 0.0;
  double exact_squares = 0.0;

  void add(const Figure& figure, const std::string& place) {
    if (!figure.ours || !figure.paper) return;
    const double rounded = *rounded_difference(figure);
    const double exact = 100.0 * (*figure.ours - *figure.paper);
    ++cells;
    rounded_squares += rounded * rounded;
    exact_squares += exact * exact;
    if (std::abs(rounded) <= std::abs(largest)) return;
    largest = rounded;
    where = place;
  }

  std::optional<double> root_mean_square(double squares) const {
    if (cells == 0) return std::nullopt;
    return std::sqrt(squares / cells);
  }
};

void add_table(Deviation& deviation, const ReportView& view, const UtilizationTable& table,
               bool overall) {
  std::vector<std::string_view> rows = thesis_stages(table);
  if (overall) rows = {"Overall"};
  for (const std::string_view row : rows)
    for (const int width : kThesisWidths)
      deviation.add(utilization_figure(view, table, row, width),
                    fmt::format("{} at W = {} of {}", row, width, table.number));
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

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Deviation from the thesis's utilization, in points";
  data.row_header = "Cells";
  data.columns = {"Cells", "Largest", "RMS", "RMS, unrounded", "Largest at"};
  Deviation triangles, quads, overall;
  for (const UtilizationTable& table : utilization_tables()) {
    Deviation alone;
    add_table(alone, view, table, false);
    add_table(table.series.facet == kTriangle ? triangles : quads, view, table, false);
    add_table(overall, view, table, true);
    data.rows.push_back(deviation_row(fmt::format("Stages of {}", table.number), alone));
  }
  data.rows.push_back(deviation_row("Stages, triangles", triangles));
  data.rows.push_back(deviation_row("Stages, quads", quads));
  data.rows.push_back(deviation_row("Overall, all four", overall));
  data.notes = {
      "Both numbers are rounded to whole percents first, as the thesis rounds, unless said "
      "otherwise."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_deviation{"deviation", "how far utilization is from the thesis's tables",
                                     luong::build};

}  // namespace lanescope
