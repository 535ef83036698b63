// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/annotation/annotation.h"
#include "analysis/html/markup.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/html/table_html.h"

namespace lanescope {
namespace {

constexpr std::size_t kLines = 200;

std::vector<Block> build(const ReportView& view) {
  const std::vector<int> widths = few_widths(widths_of(view.report()));
  std::string html;
  for (const Annotation& annotation : annotate(view.report())) {
    if (std::find(widths.begin(), widths.end(), annotation.width) == widths.end()) continue;
    html += fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                        html_escaped(annotation.title()),
                        table_html(hottest_lines(annotation, kLines)));
  }
  if (html.empty()) return {};
  return {Markup{html}};
}

}  // namespace

extern const Section s_hot_lines{
    "hot-lines", "Hottest lines of source",
    "The lines of the kernels that issue most, over the pieces of work that were observed.", build};

}  // namespace lanescope
