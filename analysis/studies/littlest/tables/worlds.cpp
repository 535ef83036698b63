// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/figures.h"
#include "analysis/tables/table.h"

namespace lanescope::littlest {
namespace {

std::optional<double> source_share(const RunRecord& run) {
  std::optional<double> seen, filled;
  for (const CounterRecord& counter : run.source.counters) {
    if (counter.name == "cubes_seen") seen = static_cast<double>(counter.value);
    if (counter.name == "cubes_seen_filled") filled = static_cast<double>(counter.value);
  }
  return quotient(filled, seen);
}

std::optional<double> counted(const RunRecord& run, std::string_view name) {
  const auto value = run.counter(name);
  if (!value) return std::nullopt;
  return static_cast<double>(*value);
}

struct Column {
  std::string_view header;
  const Unit* unit;
  RunFigure figure;
};

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"probes", &kCount, [](const RunRecord& run) { return counted(run, "probes"); }},
      {"filled", &kPercent, source_share},
      {"octants a probe", &kMeasure,
       [](const RunRecord& run) { return counter_ratio(run, "octants_rendered", "probes"); }},
      {"occluded", &kPercent,
       [](const RunRecord& run) {
         return counter_ratio(run, "samples_occluded", "samples_taken");
       }},
      {"full", &kPercent, [](const RunRecord& run) {
         return counter_ratio(run, "octants_full", "octants_rendered");
       }}};
  return all;
}

TableData build(const ReportView& view) {
  const Report& report = view.report();
  TableData data;
  data.title = "The worlds, as their probes see them";
  data.caption = "each world by itself";
  data.row_header = "World";
  const std::vector<Series> programs = programs_of(report, kFaces);
  if (programs.empty()) return data;
  for (const Column& column : columns()) data.columns.emplace_back(column.header);
  const std::vector<std::string> scenes = scenes_and_filled(view);
  for (const std::string& scene : scenes) {
    const ReportView one(report, scene);
    const std::vector<int> widths = one.widths(programs.front());
    if (widths.empty()) continue;
    Row row{scene, {}};
    for (const Column& column : columns())
      row.cells.push_back(
          {Figure{one.mean(programs.front(), widths.front(), column.figure), {}, column.unit},
           {},
           {}});
    data.rows.push_back(std::move(row));
  }
  data.notes = {
      "Filled: of the cubes of the world that bricks with probes see. Octants that no cube at the "
      "corner "
      "blocks are rendered. Occluded: of their pixels. Full: octants that see no sky."};
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_worlds{"worlds", "how full the worlds are, and what probes see",
                                     littlest::build};

}  // namespace lanescope
