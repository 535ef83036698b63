// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/html/charts/answer_table.h"
#include "analysis/html/markup.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

/// Times are all that a run has that counted nothing.
Markup times(const ReportView& view) {
  const Report& report = view.report();
  std::string text =
      "<p class=\"finding\">These runs counted nothing (their mode is uncounted): they say only "
      "how "
      "long the kernels took.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\"><table>\n"
      "<caption>Time within the kernel, summed over threads</caption>\n"
      "<thead><tr><th scope=\"col\">Run</th><th scope=\"col\">W</th>"
      "<th scope=\"col\">Time [ms]</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const Configuration& c = report.runs[i].configuration;
    text += fmt::format("<tr><th scope=\"row\">{} on {}</th><td>{}</td><td>{:.1f}</td></tr>\n",
                        html_escaped(shown({c.kernel, facet_of(c)})), html_escaped(c.scene),
                        c.width, report.kernel_ms(i).value_or(0.0));
  }
  return {text + "</tbody>\n</table></div>\n"};
}

bool counts_nothing(const Report& report) {
  return std::all_of(report.runs.begin(), report.runs.end(),
                     [](const RunRecord& run) { return run.stages.empty(); });
}

std::vector<SectionBlock> build(const ReportView& view) {
  if (counts_nothing(view.report())) return {times(view)};
  Markup table =
      answer_table(view, {}, "Utilization is active lanes / (instructions x W); of all stages.");
  return {findings(ranking_sentences(view, {})), std::move(table)};
}

}  // namespace

extern const Section s_answer{"answer", "The answer", "", build};

}  // namespace lanescope
