// SPDX-License-Identifier: MIT
#include <algorithm>

#include "analysis/tables/table.h"
#include "analysis/tables/thesis.h"
#include "analysis/tables/thesis_figures.h"

namespace lanescope {
namespace {

std::optional<double> as_double(std::optional<std::uint64_t> count) {
  if (!count) return std::nullopt;
  return static_cast<double>(*count);
}

/// A cell for each scene, and one for their mean unless there is only one.
Row scene_row(const ReportView& view, std::string label, Micropolygon shape,
              const RunFigure& figure, const Unit& unit, std::optional<double> thesis) {
  Row row{std::move(label), {}};
  for (const std::string& scene : view.scenes()) {
    const RunRecord* run = view.find_any(scene, shape);
    row.cells.push_back({Figure{run ? figure(*run) : std::nullopt, {}, &unit}, {}, {}});
  }
  const Cell mean{Figure{view.mean(shape, figure), thesis, &unit}, {}, {}};
  if (view.scenes().size() == 1)
    row.cells.front() = mean;
  else
    row.cells.push_back(mean);
  return row;
}

std::optional<double> depth_complexity(const RunRecord& run) {
  const auto hits = run.counter("hits");
  if (!hits) return std::nullopt;
  return Ratio{*hits, run.samples_covered}.value();
}

std::optional<double> covered(const RunRecord& run) {
  const Configuration& c = run.configuration;
  const std::uint64_t samples = static_cast<std::uint64_t>(c.tessellation.width_px) *
                                static_cast<std::uint64_t>(c.tessellation.height_px) *
                                static_cast<std::uint64_t>(c.samples_per_pixel);
  return Ratio{run.samples_covered, samples}.value();
}

void add_shape(TableData& data, const ReportView& view, Micropolygon shape,
               const std::string& plural) {
  const auto thesis = [&](std::string_view name) {
    return thesis_value({"table_4_6", to_string(shape), name});
  };
  const auto ratio = [](std::string_view above, std::string_view below) {
    return [=](const RunRecord& run) { return counter_ratio(run, above, below); };
  };
  const auto add = [&](const std::string& label, const RunFigure& figure, const Unit& unit,
                       std::optional<double> reference = {}) {
    data.rows.push_back(scene_row(view, label, shape, figure, unit, reference));
  };
  data.rows.push_back({plural, {}});
  add("STE", ratio("hits", "tests"), kPercent, thesis("ste"));
  add("Tests/mp", ratio("tests", "micropolygons_rasterized"), kPoints);
  add(
      "Rasterized",
      [](const RunRecord& run) { return as_double(run.counter("micropolygons_rasterized")); },
      kMillions, thesis("micropolygons"));
  add("Facing away", ratio("micropolygons_culled", "micropolygons_seen"), kPercent);
  add("Hits/covered sample", depth_complexity, kPoints);
  add("Samples covered", covered, kPercent);
}

TableData build(const ReportView& view) {
  TableData data;
  data.title = "Sample test efficiency, and what the scenes are like";
  data.row_header = "Micropolygons";
  data.columns = view.scenes();
  if (view.scenes().size() != 1) data.columns.push_back("Mean");
  add_shape(data, view, Micropolygon::kTriangle, "Triangles");
  add_shape(data, view, Micropolygon::kQuad, "Quads");
  data.notes = {
      "STE, sample test efficiency, is hits / tests. No kernel or width changes these figures."};
  return data;
}

}  // namespace

extern const Table t_sample_tests{"sample_tests",
                                  "sample test efficiency and micropolygons, by scene", build};

}  // namespace lanescope
