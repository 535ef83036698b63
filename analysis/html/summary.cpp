// SPDX-License-Identifier: MIT
#include "analysis/html/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/configuration/configuration_json.h"
#include "analysis/html/markup.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// A table of words whose first column names the rows.
std::string words_table(const std::string& caption, const std::vector<std::string>& headers,
                        const std::vector<std::vector<std::string>>& rows) {
  std::string text = fmt::format(
      "<div class=\"scroll\"><table class=\"words\">\n<caption>{}</caption>\n"
      "<thead><tr>",
      html_escaped(caption));
  for (const std::string& header : headers)
    text += fmt::format("<th scope=\"col\">{}</th>", html_escaped(header));
  text += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += i == 0 ? fmt::format("<tr><th scope=\"row\">{}</th>", html_escaped(row[i]))
                     : fmt::format("<td>{}</td>", html_escaped(row[i]));
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n";
}

std::string reports_table(const std::vector<NamedReport>& sources) {
  std::vector<std::vector<std::string>> rows;
  for (const NamedReport& source : sources) {
    const Report& report = source.report;
    rows.push_back({source.name, report.command, report.program_version,
                    report.commit.empty() ? "not known" : report.commit,
                    std::to_string(report.runs.size())});
  }
  return words_table("Reports and the commands that make them again",
                     {"File", "Command", "Version", "Commit", "Runs"}, rows);
}

std::string scenes_table(const std::vector<NamedReport>& sources) {
  std::vector<std::vector<std::string>> rows;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs) {
      const Configuration& c = run.configuration;
      std::vector<std::string> row{c.scene,
                                   std::string(to_string(c.shape())),
                                   fmt::format("{}", c.frame),
                                   fmt::format("{}", run.tessellation.micropolygons),
                                   fmt::format("{:#018x}", run.scene_hash),
                                   run.thesis_like ? "yes" : "no"};
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
    }
  return words_table(
      "Scenes", {"Scene", "Kind", "Frame", "Micropolygons", "Hash", "Like the thesis's"}, rows);
}

std::string shown_value(const Json& value) {
  if (value.is_null()) return "none";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string parameters_table(const std::vector<NamedReport>& sources, bool same) {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> values;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs) {
      const Json parameters = configuration_json(run.configuration);
      for (const auto& [name, value] : parameters.items()) {
        const auto known = std::find(names.begin(), names.end(), name);
        const auto place = static_cast<std::size_t>(known - names.begin());
        if (known == names.end()) {
          names.push_back(name);
          values.emplace_back();
        }
        const std::string shown = shown_value(value);
        if (std::find(values[place].begin(), values[place].end(), shown) == values[place].end())
          values[place].push_back(shown);
      }
    }
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < names.size(); ++i)
    if ((values[i].size() == 1) == same)
      rows.push_back({names[i], fmt::format("{}", fmt::join(values[i], ", "))});
  if (rows.empty()) return {};
  return same
             ? words_table("Parameters that are the same in all runs", {"Parameter", "Value"}, rows)
             : words_table("Parameters that vary", {"Parameter", "Values"}, rows);
}

std::string timing_note(const std::vector<NamedReport>& sources) {
  std::string text = "<p class=\"note\">Time and host, which no count depends on:";
  for (const NamedReport& source : sources) {
    const Timing& timing = source.report.timing;
    text += fmt::format(" {}: {:.1f} s on {} threads of {}, compiled by {}.",
                        html_escaped(source.name), timing.wall_ms / 1000.0, timing.threads,
                        html_escaped(timing.host), html_escaped(timing.compiler));
  }
  return text + "</p>\n";
}

}  // namespace

std::string summary_html(const std::vector<NamedReport>& sources) {
  return reports_table(sources) + scenes_table(sources) + parameters_table(sources, false) +
         "<details><summary>Parameters that are the same in all runs</summary>\n" +
         parameters_table(sources, true) + "</details>\n" + timing_note(sources);
}

}  // namespace lanescope
