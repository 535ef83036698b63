// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

constexpr std::array<std::string_view, 3> kStages{"Bound", "Test", "Process"};

std::optional<double> ours(const ReportView& view, const Series& series, std::string_view label,
                           int width) {
  if (label == "Total") return instructions(view, series, width);
  return mean_stage_instructions(view, series, label, width);
}

std::string heading(const ReportView& view, std::string_view facet, std::string_view plural) {
  const Figure ste{sample_test_efficiency(view, facet), thesis_value({"table_4_6", facet, "ste"}),
                   &kPercent};
  const Figure count{micropolygons_rasterized(view, facet),
                     thesis_value({"table_4_6", facet, "micropolygons"}), &kMillions};
  if (!differences_from_thesis(view).empty())
    return fmt::format("{}: STE {}, {} micropolygons", plural, shown(ste), shown(count));
  return fmt::format("{}: STE {} (thesis {}), {} micropolygons (thesis {})", plural, shown(ste),
                     shown_paper(ste), shown(count), shown_paper(count));
}

void add_block(TableData& data, const ReportView& view, const Series& series,
               std::string_view plural) {
  data.rows.push_back({heading(view, series.facet, plural), {}});
  std::vector<std::string_view> labels(kStages.begin(), kStages.end());
  labels.push_back("Total");
  for (const std::string_view label : labels) {
    Row row{std::string(label) + (label == "Total" ? ", without Setup" : ""), {}};
    for (const int width : widths_of(view, kLockstepTriangle)) {
      const auto thesis = thesis_value({"table_4_6", series.facet, "ops_per_mp", label}, width);
      row.cells.push_back(
          {Figure{ours(view, series, label, width), thesis, &kRoundInstructions}, {}, {}});
    }
    data.rows.push_back(std::move(row));
  }
}

void add_ratio(TableData& data, const ReportView& view) {
  data.rows.push_back({"Quads against triangles", {}});
  Row row{"Total, without Setup", {}};
  for (const int width : widths_of(view, kLockstepTriangle)) {
    const auto ratio = quotient(instructions(view, kLockstepQuad, width),
                                instructions(view, kLockstepTriangle, width));
    const auto thesis =
        quotient(thesis_value({"table_4_6", "quad", "ops_per_mp", "Total"}, width),
                 thesis_value({"table_4_6", "triangle", "ops_per_mp", "Total"}, width));
    row.cells.push_back({Figure{ratio, thesis, &kFactor}, {}, {}});
  }
  data.rows.push_back(std::move(row));
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Table 4.6: LOCKSTEP: instructions for each micropolygon, triangles and quads";
  data.row_header = "Stage";
  data.columns = width_headers(widths_of(view, kLockstepTriangle));
  add_block(data, view, kLockstepTriangle, "Triangles");
  add_block(data, view, kLockstepQuad, "Quads");
  add_ratio(data, view);
  data.notes = {
      "Setup is left out, as in the thesis. Micropolygons are those rasterized in a scene."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_quads_vs_triangles{
    "quads_vs_triangles", "table 4.6: instructions for each triangle and for each quad",
    luong::compared<luong::build>};

}  // namespace lanescope
