// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/table_html.h"
#include "analysis/tables/means.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

std::vector<Row> rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows = instruction_rows(view, series);
  if (!rows.empty())
    rows.insert(rows.begin(),
                figure_row(view, series, "Utilization, all stages", kPercent,
                           [&](int width) { return mean_utilization(view, series, width); }));
  return rows;
}

TableData headline(const ReportView& view) {
  TableData data = table_over_widths(
      view, "Utilization of all stages together, and instructions for each element", "Kernel",
      rows);
  data.caption = view.caption();
  data.setting = view.setting();
  data.notes = {
      "Utilization is active lanes / (instructions x W). Instructions are vector instructions."};
  return data;
}

std::vector<SectionBlock> build(const ReportView& view) {
  const TableData data = headline(view);
  if (data.rows.empty()) return {};
  std::string html = table_html(data);
  for (const Table* table : tables())
    if (const TableData all = build_table(*table, view); !all.rows.empty())
      html += fmt::format("<details><summary>All figures: {}</summary>\n{}</details>\n",
                          html_escaped(table->summary), table_html(all));
  return {Markup{html}};
}

}  // namespace

extern const Section s_headline{"headline", "How busy the lanes are",
                                "Overall figures of each kernel; every table is below.", build};

}  // namespace lanescope
