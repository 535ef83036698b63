// SPDX-License-Identifier: MIT
#include "analysis/tables/run_summary.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Adds rows below a heading, unless there are none.
void add(TableData& data, std::string heading, std::vector<Row> rows) {
  if (!rows.empty()) data.rows.push_back({std::move(heading), {}});
  for (Row& row : rows) data.rows.push_back(std::move(row));
}

TableData summary(const Report& report) {
  const Configuration& c = report.runs.front().configuration;
  const ReportView view(report);
  const Series series = series_of(report).front();
  const std::string facet = shown_facet(series);
  TableData data;
  data.name = "run";
  data.setting = view.setting();
  data.title = fmt::format("{} on {}{}{}", c.kernel, c.scene, facet.empty() ? "" : ", ", facet);
  data.columns = width_headers(widths_of(report));
  add(data, "Utilization (share of the instructions of all stages)",
      utilization_rows(view, series));
  add(data, "Instructions for each element", instruction_rows(view, series));
  add(data, "Metrics", metric_rows(view, series));
  add(data, "Counts", counter_rows(view, series));
  add(data, "Counts in the output", output_rows(view, series));
  if (c.mode == Mode::kUncounted)
    data.notes = {"Nothing was counted while the kernel ran (mode uncounted)."};
  return data;
}

}  // namespace

std::vector<TableData> run_summaries(const Report& report) {
  std::vector<TableData> tables;
  for (const Report& part : by_series(report)) tables.push_back(summary(part));
  return tables;
}

}  // namespace lanescope
