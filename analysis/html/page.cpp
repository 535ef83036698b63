// SPDX-License-Identifier: MIT
#include "analysis/html/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/html/assets.h"
#include "analysis/html/groups.h"
#include "analysis/html/markup.h"
#include "analysis/html/pictures.h"
#include "analysis/html/summary.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// A heading and what is below it, with its place in the list of contents.
struct Part {
  std::string id;
  std::string title;
  int level = 2;
  std::string html;
};

std::string chart_html(const Chart& chart, const std::string& id) {
  if (chart.rows.empty())
    return fmt::format("<p class=\"note\">The reports have no such figures: {}</p>\n",
                       html_escaped(chart.caption));
  nlohmann::ordered_json spec = chart.spec;
  spec["description"] = chart.caption;
  return fmt::format(
      "<figure class=\"chart\" id=\"{0}\" data-drawn=\"false\">\n<div class=\"scroll\"><div "
      "class=\"drawing\"></div></div>\n<figcaption>{1}</figcaption>\n<details "
      "class=\"numbers\"><summary>Numbers as a table<span class=\"hidden\">: {1}</span></summary>"
      "</details>\n<script type=\"application/json\">{2}</script>\n</figure>\n",
      id, html_escaped(chart.caption),
      script_json({{"spec", std::move(spec)}, {"data", chart.rows.to_json()}}));
}

std::string block_html(const Block& block, const std::string& section_id) {
  if (const Markup* markup = std::get_if<Markup>(&block)) return markup->html;
  const Chart& chart = std::get<Chart>(block);
  return chart_html(chart, section_id + '-' + chart.id);
}

Part section_part(const Section& section, const ReportView& view, const std::string& prefix,
                  int level) {
  Part part{prefix + std::string(section.id), std::string(section.title), level,
            fmt::format("<p>{}</p>\n", html_escaped(section.explanation))};
  const std::vector<Block> blocks = section.build(view);
  if (blocks.empty()) part.html += "<p class=\"note\">The reports have no such figures.</p>\n";
  for (const Block& block : blocks) part.html += block_html(block, part.id);
  return part;
}

/// The sections of each group; a single group needs no heading of its own.
void add_groups(std::vector<Part>& parts, const std::vector<Group>& groups, const PlanOf& plan_of) {
  const bool several = groups.size() > 1;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string prefix = several ? fmt::format("setting-{}-", i + 1) : "";
    if (several) parts.push_back({fmt::format("setting-{}", i + 1), groups[i].name, 2, ""});
    const Report& report = groups[i].report;
    const PagePlan plan = plan_of(report);
    const ReportView view(report, scenes_of(report, plan.scenes));
    for (const Section* section : plan.sections)
      parts.push_back(section_part(*section, view, prefix, several ? 3 : 2));
  }
}

std::string contents_html(const std::vector<Part>& parts) {
  std::string text = "<ul>\n";
  for (const Part& part : parts)
    text += fmt::format("<li class=\"level{}\"><a href=\"#{}\">{}</a></li>\n", part.level, part.id,
                        html_escaped(part.title));
  return text + "</ul>\n";
}

std::string part_html(const Part& part) {
  return fmt::format(
      "<section aria-labelledby=\"{0}\">\n<h{1} id=\"{0}\">{2}</h{1}>\n{3}</section>\n", part.id,
      part.level, html_escaped(part.title), part.html);
}

/// A library without the address of its source map, which a browser would look for.
std::string library(std::string_view text) {
  const std::size_t map = text.rfind("//# sourceMappingURL=");
  return std::string(map == text.npos ? text : text.substr(0, map));
}

/// The template with its `{{name}}`s replaced. Requires that `values` has each of them.
std::string filled(std::string_view text, const std::map<std::string_view, std::string>& values) {
  std::string result;
  for (std::size_t open; (open = text.find("{{")) != text.npos;) {
    const std::size_t close = text.find("}}", open);
    const auto value = values.find(text.substr(open + 2, close - open - 2));
    LANESCOPE_CHECK(value != values.end(), "{}", text.substr(open, 20));
    result.append(text.substr(0, open)).append(value->second);
    text.remove_prefix(close + 2);
  }
  return result.append(text);
}

std::string title_of(const std::vector<NamedReport>& sources) {
  std::vector<std::string> commands;
  for (const NamedReport& source : sources) commands.push_back(source.report.command);
  return fmt::format("{}", fmt::join(commands, " + "));
}

}  // namespace

std::string report_page(const std::vector<NamedReport>& sources, const std::string& pictures,
                        const PlanOf& plan_of) {
  const std::vector<Group> groups = groups_of(sources);
  if (groups.empty())
    throw InputError(sources.front().name, "has no runs; there is nothing to show");
  std::vector<Part> parts{{"runs", "What was run", 2, summary_html(sources)},
                          {"frames", "Frames", 2, pictures_html(sources, pictures)}};
  add_groups(parts, groups, plan_of);
  std::string body;
  for (const Part& part : parts) body += part_html(part);
  return filled(page_template(), {{"title", html_escaped(title_of(sources))},
                                  {"style", std::string(page_style())},
                                  {"contents", contents_html(parts)},
                                  {"sections", body},
                                  {"licences", html_escaped(library_licences())},
                                  {"vega", library(vega())},
                                  {"vega_lite", library(vega_lite())},
                                  {"vega_embed", library(vega_embed())},
                                  {"program", std::string(page_program())}});
}

}  // namespace lanescope
