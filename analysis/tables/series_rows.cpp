// SPDX-License-Identifier: MIT
#include "analysis/tables/series_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "analysis/tables/means.h"

namespace lanescope {
namespace {

/// A row for each counter; `value(run, name)` is that of a run.
template <class Value>
std::vector<Row> rows_of_counters(const ReportView& view, const Series& series,
                                  const std::vector<CounterRecord>& counters, const Value& value) {
  std::vector<Row> rows;
  for (const CounterRecord& counter : counters)
    rows.push_back(figure_row(view, series, counter.name, kCount, [&](int width) {
      return view.mean(series, width, [&](const RunRecord& run) -> std::optional<double> {
        const auto count = value(run, std::string_view(counter.name));
        if (!count) return std::nullopt;
        return static_cast<double>(*count);
      });
    }));
  return rows;
}

bool is_empty(const Cell& cell) { return !cell.figure && !cell.share && cell.words.empty(); }

/// Drops the widths at which only others were run.
void drop_empty_columns(TableData& data) {
  for (std::size_t column = data.columns.size(); column-- > 0;) {
    const bool is_used = std::any_of(data.rows.begin(), data.rows.end(), [&](const Row& row) {
      return column < row.cells.size() && !is_empty(row.cells[column]);
    });
    if (is_used) continue;
    const auto place = static_cast<std::ptrdiff_t>(column);
    data.columns.erase(data.columns.begin() + place);
    for (Row& row : data.rows)
      if (column < row.cells.size()) row.cells.erase(row.cells.begin() + place);
  }
}

}  // namespace

std::string shown_kernel(std::string_view kernel) {
  std::string letters(kernel);
  std::transform(letters.begin(), letters.end(), letters.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return letters;
}

std::string shown_facet(const Series& series) {
  const std::string_view name = facet_name(series.kernel);
  return name.empty() ? std::string() : fmt::format("{} = {}", name, series.facet);
}

std::string shown(const Series& series) {
  const std::string facet = shown_facet(series);
  return shown_kernel(series.kernel) + (facet.empty() ? "" : ", " + facet);
}

std::vector<std::string> stages_of(const ReportView& view, const Series& series) {
  const RunRecord* const run = view.find_any(series);
  return run ? names_of(run->stages) : std::vector<std::string>();
}

std::string element_of(const ReportView& view, const Series& series) {
  const RunRecord* const run = view.find_any(series);
  return run ? run->element.abbreviation : "";
}

Row row_over(const ReportView& view, const Series& series, std::string label,
             const std::function<Cell(int width)>& cell) {
  const std::vector<int> own = view.widths(series);
  Row row{std::move(label), {}};
  for (const int width : widths_of(view.report()))
    row.cells.push_back(std::binary_search(own.begin(), own.end(), width) ? cell(width) : Cell{});
  return row;
}

Row figure_row(const ReportView& view, const Series& series, std::string label, const Unit& unit,
               const std::function<std::optional<double>(int width)>& figure) {
  return row_over(view, series, std::move(label), [&](int width) {
    return Cell{Figure{figure(width), {}, &unit}, {}, {}};
  });
}

std::vector<Row> utilization_rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows;
  for (const std::string& stage : stages_of(view, series))
    rows.push_back(row_over(view, series, stage, [&](int width) {
      return Cell{Figure{mean_stage_utilization(view, series, stage, width), {}, &kPercent},
                  Figure{mean_stage_share(view, series, stage, width), {}, &kShare},
                  {}};
    }));
  if (rows.empty()) return rows;
  rows.push_back(figure_row(view, series, "Overall, all stages", kPercent,
                            [&](int width) { return mean_utilization(view, series, width); }));
  return rows;
}

std::vector<Row> instruction_rows(const ReportView& view, const Series& series) {
  if (stages_of(view, series).empty()) return {};
  return {figure_row(view, series, fmt::format("Instr./{}, all stages", element_of(view, series)),
                     kInstructions,
                     [&](int width) { return mean_instructions(view, series, width); })};
}

std::vector<Row> metric_rows(const ReportView& view, const Series& series) {
  std::vector<Row> rows;
  const RunRecord* const run = view.find_any(series);
  if (!run) return rows;
  for (const MetricRecord& metric : run->metrics)
    rows.push_back(figure_row(view, series, metric.name, kMeasure, [&](int width) {
      return mean_counter_ratio(view, series, width, metric.numerator, metric.denominator);
    }));
  return rows;
}

std::vector<Row> counter_rows(const ReportView& view, const Series& series) {
  const RunRecord* const any = view.find_any(series);
  if (!any) return {};
  return rows_of_counters(view, series, any->counters,
                          [](const RunRecord& run, auto name) { return run.counter(name); });
}

std::vector<Row> output_rows(const ReportView& view, const Series& series) {
  const RunRecord* const any = view.find_any(series);
  if (!any) return {};
  return rows_of_counters(view, series, any->output.counters,
                          [](const RunRecord& run, auto name) { return run.output.counter(name); });
}

TableData table_over_widths(
    const ReportView& view, std::string title, std::string row_header,
    const std::function<std::vector<Row>(const ReportView&, const Series&)>& rows) {
  TableData data;
  data.title = std::move(title);
  data.row_header = std::move(row_header);
  data.columns = width_headers(widths_of(view.report()));
  for (const Series& series : series_of(view.report())) {
    const std::vector<Row> own = rows(view, series);
    if (own.empty()) continue;
    data.rows.push_back({shown(series), {}});
    data.rows.insert(data.rows.end(), own.begin(), own.end());
  }
  drop_empty_columns(data);
  return data;
}

}  // namespace lanescope
