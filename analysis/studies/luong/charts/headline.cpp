// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/table_html.h"
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/study.h"
#include "analysis/studies/luong/tables/utilization.h"
#include "analysis/studies/luong/thesis.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::luong {
namespace {

/// The key of the thesis's table of a series, or empty.
std::string_view thesis_key(const Series& series) {
  for (const UtilizationTable& table : utilization_tables())
    if (table.series == series) return table.thesis_key;
  return {};
}

TableData headline(const ReportView& view) {
  TableData data;
  data.title = "Utilization of the stages together, and instructions for each micropolygon";
  data.caption = view.caption();
  data.setting = view.setting();
  data.row_header = "Kernel";
  data.columns = width_headers(lanescope::widths_of(view.report()));
  for (const Series& series : series_of(view.report())) {
    const std::string_view key = thesis_key(series);
    data.rows.push_back(
        {fmt::format("{}, {}", shown_kernel(series.kernel), plural(series.facet)), {}});
    data.rows.push_back(row_over(view, series, "Utilization, without Setup", [&](int width) {
      return Cell{Figure{overall_utilization(view, series, width),
                         thesis_value({key, "utilization", "Overall"}, width), &kPercent},
                  {},
                  {}};
    }));
    data.rows.push_back(row_over(view, series, "Instr./mp, without Setup", [&](int width) {
      return Cell{Figure{instructions(view, series, width),
                         thesis_value({key, "ops_per_mp"}, width), &kInstructionsPerMp},
                  {},
                  {}};
    }));
  }
  data.notes = {
      "Utilization is active lanes / (instructions x W). Instructions are vector instructions, for "
      "each micropolygon (mp) that is rasterized, without Setup, as in the thesis."};
  return data;
}

std::vector<SectionBlock> build(const ReportView& view) {
  std::string html = table_html(compared<headline>(view));
  for (const Table* table : luong_tables())
    html += fmt::format("<details><summary>All figures: {}</summary>\n{}</details>\n",
                        html_escaped(table->summary), table_html(build_table(*table, view)));
  return {Markup{html}};
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Section luong_s_headline{
    "headline", "How busy the lanes are",
    "Overall figures of each kernel beside those of the thesis; every table is below.",
    luong::build};

}  // namespace lanescope
