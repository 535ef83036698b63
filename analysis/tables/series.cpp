// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

/// The lists of that name of several runs, added up place by place.
std::vector<std::uint64_t> added_up(const std::vector<const RunRecord*>& runs,
                                    std::string_view name) {
  std::vector<std::uint64_t> sum;
  for (const RunRecord* run : runs) {
    const SeriesRecord* const found = run->find_series(name);
    if (!found) continue;
    sum.resize(std::max(sum.size(), found->values.size()));
    for (std::size_t i = 0; i < found->values.size(); ++i) sum[i] += found->values[i];
  }
  return sum;
}

Cell count_cell(std::uint64_t count) {
  return {Figure{static_cast<double>(count), {}, &kCount}, {}, {}};
}

Row summary(std::string label, const std::vector<std::uint64_t>& values) {
  const auto largest = std::max_element(values.begin(), values.end());
  return {std::move(label),
          {count_cell(values.size()),
           count_cell(std::accumulate(values.begin(), values.end(), std::uint64_t{0})),
           count_cell(*largest), count_cell(static_cast<std::uint64_t>(largest - values.begin()))}};
}

void add_rows(TableData& data, const ReportView& view, const Series& series, int width) {
  const std::vector<const RunRecord*> runs = view.runs(series, width);
  if (runs.empty()) return;
  std::vector<Row> rows;
  for (const SeriesRecord& record : runs.front()->series)
    if (const auto values = added_up(runs, record.name); !values.empty())
      rows.push_back(summary(record.name, values));
  if (rows.empty()) return;
  data.rows.push_back({fmt::format("{}, W = {}", shown(series), width), {}});
  data.rows.insert(data.rows.end(), rows.begin(), rows.end());
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Series: histograms, and courses over time";
  data.caption = fmt::format("{}", fmt::join(view.scenes(), ", "));
  data.row_header = "Series";
  data.columns = {"Places", "Sum", "Largest", "At"};
  for (const Series& series : series_of(view.report()))
    for (const int width : view.widths(series)) add_rows(data, view, series, width);
  data.notes = {
      "Lists of several scenes are added up place by place; the report has all their values."};
  return data;
}

}  // namespace

extern const Table t_series{"series", "a summary of each list of figures that kernels count",
                            build};

}  // namespace lanescope
