// SPDX-License-Identifier: MIT
#include "analysis/html/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/configuration/special_options.h"
#include "analysis/html/markup.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// A name that may be broken at its underscores: headings of counters are longer than their values.
std::string breakable(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '_' ? "_<wbr>" : std::string(1, c);
  return text;
}

/// A table of words whose first column names the rows.
std::string words_table(const std::string& caption, const std::vector<std::string>& headers,
                        const std::vector<std::vector<std::string>>& rows) {
  std::string text = fmt::format(
      "<div class=\"scroll\"><table class=\"words\">\n<caption>{}</caption>\n"
      "<thead><tr>",
      html_escaped(caption));
  for (const std::string& header : headers)
    text += fmt::format("<th scope=\"col\">{}</th>", breakable(html_escaped(header)));
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

/// Names of the counters of all sources, in the order in which they first occur.
std::vector<std::string> counters_of(const std::vector<NamedReport>& sources) {
  std::vector<std::string> names;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs)
      for (const CounterRecord& counter : run.source.counters)
        if (std::find(names.begin(), names.end(), counter.name) == names.end())
          names.push_back(counter.name);
  return names;
}

std::string counter_text(const std::vector<CounterRecord>& counters, const std::string& name) {
  const auto found = std::find_if(counters.begin(), counters.end(),
                                  [&](const CounterRecord& c) { return c.name == name; });
  return found == counters.end() ? "" : fmt::format("{}", found->value);
}

/// What it was made into: the facet says more than the kind of work.
std::string work_of(const RunRecord& run) {
  const std::string facet = shown_facet({run.configuration.kernel, facet_of(run.configuration)});
  return facet.empty() ? run.workload : facet;
}

std::string scenes_table(const std::vector<NamedReport>& sources) {
  const std::vector<std::string> counters = counters_of(sources);
  std::vector<std::string> headers{"Scene", "Work", "Hash", "Pieces"};
  headers.insert(headers.end(), counters.begin(), counters.end());
  std::vector<std::vector<std::string>> rows;
  for (const NamedReport& source : sources)
    for (const RunRecord& run : source.report.runs) {
      std::vector<std::string> row{scene_title(run.configuration), work_of(run),
                                   hash_text(run.source.hash),
                                   fmt::format("{}", run.source.pieces)};
      for (const std::string& name : counters)
        row.push_back(counter_text(run.source.counters, name));
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
    }
  return words_table("Scenes, and the work that was made of them", headers, rows);
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
