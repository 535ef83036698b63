// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"

namespace lanescope::luong {
namespace {

constexpr std::array<std::string_view, 3> kStages{"Bound", "Test", "Process"};

/// The figure of the thesis names no width; without W = 16 the narrowest of the report stands in.
int shown_width(const ReportView& view) {
  const std::vector<int> widths = widths_of(view, kLockstepTriangle);
  const bool usual = std::find(widths.begin(), widths.end(), kClaimWidth) != widths.end();
  return usual ? kClaimWidth : widths.front();
}

std::optional<double> count(const RunRecord* run, std::string_view stage) {
  if (!run) return std::nullopt;
  if (stage.empty()) return static_cast<double>(total(*run, kAllButSetup).issued);
  const StageRecord* found = run->stage(stage);
  if (!found) return std::nullopt;
  return static_cast<double>(found->total().issued);
}

Row scene_row(const ReportView& view, const std::string& scene, const Series& series, int width) {
  const RunRecord* run = view.find(series, scene, width);
  const auto whole = count(view.find(kLockstepTriangle, scene, width), "");
  Row row{fmt::format("{}, {}", scene, plural(series.facet)), {}};
  const auto add = [&](std::string_view stage) {
    const auto issued = count(run, stage);
    row.cells.push_back(
        {Figure{issued, {}, &kMillions}, Figure{quotient(issued, whole), {}, &kShare}, {}});
  };
  for (const std::string_view stage : kStages) add(stage);
  add("");
  return row;
}

TableData build(const ReportView& view) {
  const int width = shown_width(view);
  TableData data;
  data.title = fmt::format("Figure 4.2: LOCKSTEP, W = {}: instructions of each scene", width);
  data.caption = "each scene by itself";
  data.row_header = "Scene";
  data.columns = {"Bound", "Test", "Process", "Total, without Setup"};
  for (const std::string& scene : view.scenes())
    for (const Series& series : {kLockstepTriangle, kLockstepQuad})
      data.rows.push_back(scene_row(view, scene, series, width));
  data.notes = {
      "In parentheses: relative to all instructions of the scene's triangles but those of Setup. "
      "The thesis "
      "plots these figures without giving them."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_total_instructions{
    "total_instructions", "figure 4.2: all instructions of each scene, triangles and quads",
    luong::compared<luong::build>};

}  // namespace lanescope
