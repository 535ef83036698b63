// SPDX-License-Identifier: MIT
#include "analysis/tables/memory_places.h"
#include "analysis/tables/series_rows.h"

namespace lanescope {
namespace {

bool has_conflicts(const std::vector<const RunRecord*>& runs, const MemoryPlace& place) {
  for (const RunRecord* run : runs)
    if (const MemoryRecord* memory = find_memory(*run, place); memory && memory->conflicts > 0)
      return true;
  return false;
}

std::vector<const RunRecord*> all_runs(const ReportView& view, const Series& series) {
  std::vector<const RunRecord*> runs;
  for (const int width : view.widths(series))
    for (const RunRecord* run : view.runs(series, width)) runs.push_back(run);
  return runs;
}

std::vector<Row> rows(const ReportView& view, const Series& series) {
  const std::vector<const RunRecord*> runs = all_runs(view, series);
  std::vector<Row> rows;
  for (const MemoryPlace& place : memory_places(runs, stages_of(view, series))) {
    rows.push_back(figure_row(view, series, place.name(), kLines,
                              [&](int width) { return mean_lines(view, series, width, place); }));
    if (has_conflicts(runs, place))
      rows.push_back(
          figure_row(view, series, place.name() + ", conflicts", kSmallPercent,
                     [&](int width) { return mean_conflicts(view, series, width, place); }));
  }
  return rows;
}

TableData build(const ReportView& view) {
  TableData data = table_over_widths(view, "Lines of memory that one execution touches",
                                     "Stage: instruction", rows);
  data.notes = {
      "In the pieces of work that were observed (observe_every). A line has 64 bytes. A conflict "
      "is a lane that stores to an element that an earlier lane of the same execution stored to; "
      "they are of the lanes that were on."};
  return data;
}

}  // namespace

extern const Table t_memory{"memory", "lines that gathers and scatters touch, and conflicts",
                            build};

}  // namespace lanescope
