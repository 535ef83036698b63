// SPDX-License-Identifier: MIT
#include "analysis/html/downloads.h"

#include <fmt/format.h>

#include <filesystem>

#include "analysis/html/markup.h"
#include "analysis/html/packed.h"
#include "analysis/report/report_json.h"
#include "analysis/report/tidy.h"

namespace lanescope {
namespace {

/// Packed; a report is some tenths of that for each hundred runs.
constexpr std::size_t kMostBytes = 4'000'000;

std::string link(const std::string& file, std::string_view type, const std::string& what,
                 const std::string& content) {
  const std::string bytes = packed(content);
  if (bytes.size() > kMostBytes)
    return fmt::format("<li>{}: too large for this page; it is the file {}</li>\n",
                       html_escaped(what), html_escaped(file));
  return fmt::format(
      "<li><a class=\"download\" href=\"#downloads\" download=\"{}\" data-type=\"{}\">{}</a>\n"
      "<script type=\"text/plain\" class=\"packed\">{}</script></li>\n",
      html_escaped(file), type, html_escaped(what), bytes);
}

std::string file_name(const NamedReport& source) {
  const std::string name = std::filesystem::path(source.name).filename();
  return name == "-" ? "report.json" : name;
}

}  // namespace

std::string downloads_html(const std::vector<NamedReport>& sources) {
  std::string text = "<ul>\n";
  for (const NamedReport& source : sources)
    text += link(file_name(source), "application/json",
                 fmt::format("{}: every count, as JSON", file_name(source)),
                 report_text(source.report));
  text += link("runs.csv", "text/csv", "runs.csv: a row for each run",
               tidy_csv(tidy(sources, TidyRows::kRuns)));
  text += link("stages.csv", "text/csv", "stages.csv: a row for each stage of a run",
               tidy_csv(tidy(sources, TidyRows::kStages)));
  return text +
         "</ul>\n"
         "<p class=\"note\">Below each chart, its numbers can be saved as CSV, too; the menu "
         "beside "
         "it saves it as a picture.</p>\n";
}

}  // namespace lanescope
