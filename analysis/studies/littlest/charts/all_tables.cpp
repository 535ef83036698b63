// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/table_html.h"
#include "analysis/studies/littlest/study.h"

namespace lanescope {
namespace {

std::vector<SectionBlock> build(const ReportView& view) {
  std::string html;
  for (const Table* table : littlest_tables()) {
    const TableData data = build_table(*table, view);
    if (data.rows.empty()) continue;
    html += fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                        html_escaped(table->summary), table_html(data));
  }
  if (html.empty()) return {};
  return {Markup{html}};
}

}  // namespace

extern const Section littlest_s_all_tables{
    "littlest-tables", "All figures of the study",
    "What the programs cost, what the conversion takes and misses, and what the article says.",
    build};

}  // namespace lanescope
