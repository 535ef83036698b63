// SPDX-License-Identifier: MIT
#include "analysis/studies/littlest/tables/over_fill.h"

#include <fmt/format.h>

#include "analysis/tables/series_rows.h"

namespace lanescope::littlest {

TableData over_fill(const ReportView& view, std::string title, const Unit& unit,
                    const std::function<std::optional<double>(
                        const ReportView& scene, const Series& series, int width)>& figure) {
  const Report& report = view.report();
  TableData data;
  data.title = std::move(title);
  data.caption = "scattered worlds";
  data.row_header = "Program";
  const std::vector<Filled> scenes = filled_scenes(report);
  if (scenes.empty()) return data;
  for (const Filled& scene : scenes)
    data.columns.push_back(fmt::format("{:g}% filled", 100 * scene.share));
  for (const Series& series : programs_of(report)) {
    data.rows.push_back({shown(series), {}});
    for (const int width : ReportView(report).widths(series)) {
      Row row{fmt::format("W = {}", width), {}};
      for (const Filled& scene : scenes)
        row.cells.push_back(
            {Figure{figure(ReportView(report, scene.scene), series, width), {}, &unit}, {}, {}});
      data.rows.push_back(std::move(row));
    }
  }
  return data;
}

}  // namespace lanescope::littlest
