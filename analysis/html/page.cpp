// SPDX-License-Identifier: MIT
#include "analysis/html/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "analysis/html/assets.h"
#include "analysis/html/blocks.h"
#include "analysis/html/downloads.h"
#include "analysis/html/groups.h"
#include "analysis/html/guide.h"
#include "analysis/html/markup.h"
#include "analysis/html/over_settings.h"
#include "analysis/html/pictures.h"
#include "analysis/html/settings.h"
#include "analysis/html/summary.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// A heading and what is below it, with its place in the list of contents.
struct Part {
  std::string id;
  std::string title;
  std::string html;
};

/// A name for an id: reports of other programs may have parameters of any name.
std::string plain(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '_'; }, '-');
  return name;
}

/// What the docs say of a section; empty if nothing.
std::string guide_details(std::string_view title) {
  const std::string html = guide_html(title);
  if (html.empty()) return {};
  return fmt::format(
      "<details class=\"guide\"><summary>How to read this<span class=\"hidden\">: {}</span>"
      "</summary>\n{}</details>\n",
      html_escaped(title), html);
}

/// A page under construction: its parts, and the sections that have no figures.
class Parts {
 public:
  Parts(const std::vector<Setting>& settings, const std::vector<PagePlan>& plans)
      : settings_(settings), plans_(plans), first_(first_setting(settings)) {}

  void add(Part part) { parts_.push_back(std::move(part)); }

  void add_over_settings() {
    for (const SettingAxis& axis : axes_of(settings_)) {
      const std::string id = "over-" + plain(axis.parameter);
      const std::string html = blocks_html({over_parameter(settings_, axis)}, 0, id);
      if (!html.empty())
        add({id, "Over " + axis.parameter, html + guide_details("Over a parameter")});
    }
  }

  /// The section of that id of each setting's plan, which may be different ones. One without
  /// figures shows `otherwise`, or is left out.
  void add_section(std::string_view id, std::string_view otherwise = {}) {
    const Section* shown = nullptr;
    std::vector<std::vector<SectionBlock>> blocks(settings_.size());
    for (std::size_t i = 0; i < settings_.size(); ++i) {
      const Section* section = find(plans_[i], id);
      if (!section) continue;
      blocks[i] = section->build(settings_[i].view);
      if (!shown || i == first_) shown = section;
    }
    std::string html = blocks_html(blocks, first_, std::string(id));
    if (html.empty()) html = otherwise;
    if (html.empty()) {
      missing_.emplace_back(shown->title);
      return;
    }
    const std::string sentence = shown->explanation.empty()
                                     ? std::string()
                                     : fmt::format("<p>{}</p>\n", html_escaped(shown->explanation));
    add({std::string(id), std::string(shown->title),
         sentence + html + guide_details(shown->title)});
  }

  void prepend_to_last(const std::string& html) { parts_.back().html.insert(0, html); }

  /// What the reader would look for in vain.
  std::string missing_note() const {
    if (missing_.empty()) return {};
    return fmt::format("<p class=\"note\">The reports have no figures for: {}.</p>\n",
                       html_escaped(fmt::format("{}", fmt::join(missing_, "; "))));
  }

  const std::vector<Part>& all() const { return parts_; }

 private:
  static const Section* find(const PagePlan& plan, std::string_view id) {
    const auto found = std::find_if(plan.sections.begin(), plan.sections.end(),
                                    [&](const Section* section) { return section->id == id; });
    return found == plan.sections.end() ? nullptr : *found;
  }

  const std::vector<Setting>& settings_;
  const std::vector<PagePlan>& plans_;
  std::size_t first_;
  std::vector<Part> parts_;
  std::vector<std::string> missing_;
};

/// The ids of the sections of all plans, in the order in which they first occur.
std::vector<std::string_view> section_ids(const std::vector<PagePlan>& plans) {
  std::vector<std::string_view> ids;
  for (const PagePlan& plan : plans)
    for (const Section* section : plan.sections)
      if (std::find(ids.begin(), ids.end(), section->id) == ids.end()) ids.push_back(section->id);
  return ids;
}

constexpr std::string_view kNoFigures =
    "<p>There is nothing to compare: nothing that the kernels were given was drawn.</p>\n";

/// First the answer, then pictures, then charts; what was run, and with what, at the end.
std::vector<Part> parts_of(const std::vector<NamedReport>& sources, const std::string& pictures,
                           const std::vector<Setting>& settings,
                           const std::vector<PagePlan>& plans) {
  Parts parts(settings, plans);
  const std::vector<std::string_view> ids = section_ids(plans);
  parts.add_section(ids.front(), kNoFigures);
  parts.prepend_to_last(cheapest_settings(settings).html);
  parts.add({"frames", "Frames", pictures_html(sources, pictures)});
  parts.add_over_settings();
  for (std::size_t i = 1; i < ids.size(); ++i) parts.add_section(ids[i]);
  parts.add({"runs", "What was run", summary_html(sources) + parts.missing_note()});
  parts.add({"downloads", "Downloads", downloads_html(sources)});
  return parts.all();
}

std::string contents_html(const std::vector<Part>& parts) {
  std::string text = "<ul>\n";
  for (const Part& part : parts)
    text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", part.id, html_escaped(part.title));
  return text + "</ul>\n";
}

std::string part_html(const Part& part) {
  return fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n{2}</section>\n",
                     part.id, html_escaped(part.title), part.html);
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
  std::vector<PagePlan> plans;
  std::vector<Setting> settings;
  for (const Group& group : groups) {
    plans.push_back(plan_of(group.report));
    settings.push_back(
        {&group, ReportView(group.report, scenes_of(group.report, plans.back().scenes))});
  }
  const std::vector<Part> parts = parts_of(sources, pictures, settings, plans);
  std::string body;
  for (const Part& part : parts) body += part_html(part);
  return filled(page_template(), {{"title", html_escaped(title_of(sources))},
                                  {"style", std::string(page_style())},
                                  {"contents", contents_html(parts)},
                                  {"settings", setting_controls(settings)},
                                  {"sections", body},
                                  {"licences", html_escaped(library_licences())},
                                  {"vega", library(vega())},
                                  {"vega_lite", library(vega_lite())},
                                  {"vega_embed", library(vega_embed())},
                                  {"program", std::string(page_program())}});
}

}  // namespace lanescope
