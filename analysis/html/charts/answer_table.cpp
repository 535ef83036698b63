// SPDX-License-Identifier: MIT
#include "analysis/html/charts/answer_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/html/markup.h"
#include "analysis/html/spec.h"
#include "analysis/tables/means.h"

namespace lanescope {
namespace {

/// The kernels of a facet at a width, the cheapest first.
struct Ranked {
  Series series;
  double instructions = 0.0;
  double utilization = 0.0;
};

std::vector<Ranked> ranked(const ReportView& view, const std::string& facet, int width,
                           Stages stages) {
  std::vector<Ranked> list;
  for (const Series& series : series_of(view.report())) {
    if (shown_facet(series) != facet || !view.missing_scenes(series).empty()) continue;
    const auto instructions = mean_instructions(view, series, width, stages);
    const auto busy = mean_utilization(view, series, width, stages);
    if (instructions && busy) list.push_back({series, *instructions, *busy});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.instructions < b.instructions; });
  return list;
}

/// `At W = 64, A is ahead: it needs 9.79 instructions for each element, with 88% of its lanes busy;
/// B needs 8% more, with 56%.`
std::string sentence(const ReportView& view, const std::string& facet, int width, Stages stages) {
  const std::vector<Ranked> list = ranked(view, facet, width, stages);
  if (list.empty()) return {};
  const Ranked& best = list.front();
  std::string text = fmt::format(
      "At W = {}{}{}, {} {} {:.2f} instructions for each {}, with {:.0f}% of its lanes busy", width,
      facet.empty() ? "" : " and ", facet, shown_kernel(best.series.kernel),
      list.size() > 1 ? "is ahead: it needs" : "needs", best.instructions,
      element_of(view.report()).name, 100.0 * best.utilization);
  for (std::size_t i = 1; i < list.size(); ++i)
    text += fmt::format("; {} needs {}, with {:.0f}%", shown_kernel(list[i].series.kernel),
                        shown_change(list[i].instructions, best.instructions),
                        100.0 * list[i].utilization);
  return text + '.';
}

class Answer {
 public:
  Answer(const ReportView& view, Stages stages)
      : view_(view),
        stages_(stages),
        widths_(few_widths(machine_widths_of(view.report()))),
        facets_(facets_of(view.report())) {}

  std::string html(const std::string& note) const {
    const std::string rows = body();
    if (rows.find("<b>") == rows.npos) return {};
    std::string text = fmt::format(
        "<div class=\"scroll\" tabindex=\"0\"><table class=\"answer\">\n<caption>{}</caption>\n"
        "<thead><tr><th scope=\"col\">Scene</th>",
        html_escaped(title()));
    for (const int width : widths_) text += fmt::format("<th scope=\"col\">W = {}</th>", width);
    text += fmt::format("</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n", rows);
    for (const std::string& line : {note, absences()})
      if (!line.empty()) text += fmt::format("<p class=\"note\">{}</p>\n", html_escaped(line));
    return text;
  }

 private:
  bool has_rivals() const { return kernels_of(view_.report()).size() > 1; }

  std::string title() const {
    const std::string each = element_of(view_.report()).name;
    if (has_rivals())
      return fmt::format(
          "The kernel with the fewest instructions for each {}, and how busy its "
          "lanes are",
          each);
    return fmt::format("{}: instructions for each {}, and how busy the lanes are",
                       fmt::join(kernels_of(view_.report()), ""), each);
  }

  std::string body() const {
    std::string rows;
    for (const std::string& facet : facets_) {
      if (facets_.size() > 1)
        rows += fmt::format("<tr><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                            widths_.size() + 1, html_escaped(facet));
      for (const std::string& scene : scenes_of(view_.report()))
        rows += row(ReportView(view_.report(), scene), facet, scene);
      if (view_.scenes().size() > 1) rows += row(view_, facet, view_.caption());
    }
    return rows;
  }

  std::string row(const ReportView& scenes, const std::string& facet,
                  const std::string& label) const {
    std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", html_escaped(label));
    for (const int width : widths_) text += cell(ranked(scenes, facet, width, stages_));
    return text + "</tr>\n";
  }

  std::string cell(const std::vector<Ranked>& kernels) const {
    if (kernels.empty()) return "<td>–</td>";
    const Ranked& best = kernels.front();
    return fmt::format("<td><b>{}</b> {:.2f}<br><span class=\"of\">{:.0f}% busy</span></td>",
                       has_rivals() ? html_escaped(shown_kernel(best.series.kernel)) : "",
                       best.instructions, 100.0 * best.utilization);
  }

  std::string absences() const {
    std::string text;
    for (const Series& series : series_of(view_.report()))
      if (const auto missing = view_.missing_scenes(series); !missing.empty())
        text += fmt::format("{}{} was not run on {}: its means, here and below, are of the others.",
                            text.empty() ? "" : " ", shown(series), fmt::join(missing, ", "));
    return text;
  }

  const ReportView& view_;
  Stages stages_;
  std::vector<int> widths_;
  std::vector<std::string> facets_;
};

}  // namespace

Markup findings(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string text = "<ul class=\"findings\">\n";
  for (const std::string& sentence : sentences)
    text += fmt::format("<li>{}</li>\n", html_escaped(sentence));
  return {text + "</ul>\n"};
}

std::vector<std::string> ranking_sentences(const ReportView& view, Stages stages) {
  std::vector<int> widths = machine_widths_of(view.report());
  if (widths.size() > 2) widths = {widths.front(), widths.back()};
  std::vector<std::string> list;
  for (const std::string& facet : facets_of(view.report()))
    for (const int width : widths)
      if (std::string text = sentence(view, facet, width, stages); !text.empty())
        list.push_back(std::move(text));
  return list;
}

Markup answer_table(const ReportView& view, Stages stages, const std::string& note) {
  return {Answer(view, stages).html(note)};
}

std::string shown_change(double part, double whole) {
  const double percent = 100.0 * (part / whole - 1.0);
  if (std::abs(percent) < 0.05) return "as many";
  return fmt::format("{:.{}f}% {}", std::abs(percent), std::abs(percent) < 1.0 ? 1 : 0,
                     percent < 0.0 ? "fewer" : "more");
}

}  // namespace lanescope
