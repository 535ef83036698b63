// SPDX-License-Identifier: MIT
#include "analysis/tables/run_summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/configuration/special_options.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

bool same_but_for_width(Configuration a, const Configuration& b) {
  a.width = b.width;
  return a == b;
}

/// The runs of a report, divided into reports of those that differ in nothing but the width.
std::vector<Report> by_series(const Report& report) {
  std::vector<Report> all;
  for (const RunRecord& run : report.runs) {
    auto place = std::find_if(all.begin(), all.end(), [&](const Report& part) {
      return same_but_for_width(part.runs.front().configuration, run.configuration);
    });
    if (place == all.end()) place = all.insert(all.end(), Report{});
    place->runs.push_back(run);
  }
  return all;
}

/// `frame = 4, resolution = 480x300`: what is not as it is by default, but for the facet.
std::string caption_of(const Configuration& configuration) {
  std::vector<std::string> texts;
  for (const SpecialOption& option : special_options(configuration))
    if (option.parameter != facet_name(configuration.kernel)) texts.push_back(option.text());
  return texts.empty() ? "all parameters as they are by default"
                       : fmt::format("{}", fmt::join(texts, ", "));
}

void add(TableData& data, std::vector<Row> rows) {
  for (Row& row : rows) data.rows.push_back(std::move(row));
}

TableData summary(const Report& report) {
  const Configuration& c = report.runs.front().configuration;
  const ReportView view(report);
  const Series series = series_of(report).front();
  const std::string facet = shown_facet(series);
  TableData data;
  data.name = "run";
  data.caption = caption_of(c);
  data.title = fmt::format("{} on {}{}{}", c.kernel, c.scene, facet.empty() ? "" : ", ", facet);
  data.row_header = "Utilization (share of the instructions)";
  for (const int width : widths_of(report)) data.columns.push_back(fmt::format("W = {}", width));
  add(data, utilization_rows(view, series));
  add(data, instruction_rows(view, series));
  data.rows.push_back({"Metrics", {}});
  add(data, metric_rows(view, series));
  data.rows.push_back({"Counts", {}});
  add(data, counter_rows(view, series));
  return data;
}

}  // namespace

std::vector<TableData> run_summaries(const Report& report) {
  std::vector<TableData> tables;
  for (const Report& part : by_series(report)) tables.push_back(summary(part));
  return tables;
}

}  // namespace lanescope
