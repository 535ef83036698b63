// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/html/table_html.h"
#include "analysis/tables/thesis.h"
#include "analysis/tables/thesis_figures.h"
#include "analysis/tables/utilization.h"

namespace lanescope {
namespace {

/// The key of the thesis's table of a series, or empty.
std::string_view thesis_key(const Series& series) {
  for (const UtilizationTable& table : utilization_tables())
    if (table.series.kernel == series.kernel && table.series.shape == series.shape)
      return table.thesis_key;
  return {};
}

template <class MakeFigure>
Row row_over(std::string label, const ReportView& view, const Series& series,
             const MakeFigure& make_figure) {
  Row row{std::move(label), {}};
  const std::vector<int> own = view.widths(series);
  for (const int width : widths_of(view.report()))
    row.cells.push_back(std::find(own.begin(), own.end(), width) != own.end()
                            ? Cell{make_figure(width), {}, {}}
                            : Cell{});
  return row;
}

TableData headline(const ReportView& view) {
  TableData data;
  data.title = "Utilization of all stages together, and instructions for each micropolygon";
  data.caption = view.caption();
  data.row_header = "Kernel";
  for (const int width : widths_of(view.report()))
    data.columns.push_back(fmt::format("W = {}", width));
  for (const Series& series : series_of(view.report())) {
    const std::string_view key = thesis_key(series);
    data.rows.push_back(
        {fmt::format("{}, {}", shown_kernel(series.kernel), shown_shape(series.shape)), {}});
    data.rows.push_back(row_over("Utilization", view, series, [&](int width) {
      return Figure{overall_utilization(view, series, width),
                    thesis_value({key, "utilization", "Overall"}, width), &kPercent};
    }));
    data.rows.push_back(row_over("Instr./mp", view, series, [&](int width) {
      return Figure{instructions(view, series, width), thesis_value({key, "ops_per_mp"}, width),
                    &kInstructions};
    }));
  }
  data.notes = {
      "Utilization is active lanes / (instructions x W). Instructions are vector instructions, for "
      "each micropolygon (mp) that is rasterized, without Setup, as in the thesis."};
  return data;
}

std::vector<Block> build(const ReportView& view) {
  std::string html = table_html(headline(view));
  for (const Table* table : tables())
    html += fmt::format("<details><summary>All figures: {}</summary>\n{}</details>\n",
                        html_escaped(table->summary), table_html(build_table(*table, view)));
  return {Markup{html}};
}

}  // namespace

extern const Section s_headline{
    "headline", "How busy the lanes are",
    "Overall figures of each kernel beside those of the thesis; every table is below.", build};

}  // namespace lanescope
