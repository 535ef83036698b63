// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/studies/littlest/figures.h"
#include "analysis/tables/series_rows.h"

namespace lanescope::littlest {
namespace {

Row scene_row(const Report& report, const std::string& scene, std::string_view projection) {
  const ReportView view(report, scene);
  Row row{scene, {}};
  for (const int width : machine_widths_of(report)) {
    Cell cell;
    if (const auto best = winner(view, projection, width))
      cell.words = fmt::format("{} {:.1f}", shown_kernel(best->series.kernel), best->per_octant);
    row.cells.push_back(std::move(cell));
  }
  return row;
}

TableData build(const ReportView& view) {
  const Report& report = view.report();
  TableData data;
  data.title = "The program that needs the fewest instructions, and how many for an octant";
  data.caption = "each world by itself";
  data.row_header = "World";
  if (programs_of(report).empty()) return data;
  data.columns = width_headers(machine_widths_of(report));
  for (const std::string_view projection : {kFaces, kDirections}) {
    if (programs_of(report, projection).size() < 2) continue;
    data.rows.push_back({fmt::format("projection = {}", projection), {}});
    for (const std::string& scene : scenes_and_filled(view))
      data.rows.push_back(scene_row(report, scene, projection));
  }
  return data;
}

}  // namespace
}  // namespace lanescope::littlest

namespace lanescope {

extern const Table littlest_t_winners{
    "winners", "which program needs the fewest instructions, for each world and width",
    littlest::build};

}  // namespace lanescope
