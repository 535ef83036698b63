// SPDX-License-Identifier: MIT
#include <algorithm>

#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/thesis.h"

namespace lanescope::luong {
namespace {

std::optional<double> as_double(std::optional<std::uint64_t> count) {
  if (!count) return std::nullopt;
  return static_cast<double>(*count);
}

/// A cell for each scene, and one for their mean unless there is only one.
Row scene_row(const ReportView& view, std::string label, std::string_view facet,
              const RunFigure& figure, const Unit& unit, std::optional<double> thesis) {
  Row row{std::move(label), {}};
  for (const std::string& scene : view.scenes()) {
    const RunRecord* run = view.find_any(facet, scene);
    row.cells.push_back({Figure{run ? figure(*run) : std::nullopt, {}, &unit}, {}, {}});
  }
  const Cell mean{Figure{mean_of_any(view, facet, figure), thesis, &unit}, {}, {}};
  if (view.scenes().size() == 1)
    row.cells.front() = mean;
  else
    row.cells.push_back(mean);
  return row;
}

std::uint64_t samples_covered(const RunRecord& run) {
  return run.output.counter("samples_covered").value_or(0);
}

std::optional<double> depth_complexity(const RunRecord& run) {
  const auto hits = run.counter("hits");
  if (!hits) return std::nullopt;
  return Ratio{*hits, samples_covered(run)}.value();
}

std::optional<double> covered(const RunRecord& run) {
  std::uint64_t samples = 1;
  for (const char* factor : {"width_px", "height_px", "samples_per_pixel"}) {
    const Value value = value_of(run.configuration, factor);
    const auto* const number = std::get_if<std::uint64_t>(&value);
    samples *= number ? *number : 0;
  }
  return Ratio{samples_covered(run), samples}.value();
}

void add_shape(TableData& data, const ReportView& view, std::string_view facet,
               const std::string& plural) {
  const auto thesis = [&](std::string_view name) {
    return thesis_value({"table_4_6", facet, name});
  };
  const auto ratio = [](std::string_view above, std::string_view below) {
    return [=](const RunRecord& run) { return counter_ratio(run, above, below); };
  };
  const auto add = [&](const std::string& label, const RunFigure& figure, const Unit& unit,
                       std::optional<double> reference = {}) {
    data.rows.push_back(scene_row(view, label, facet, figure, unit, reference));
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
  add_shape(data, view, kTriangle, "Triangles");
  add_shape(data, view, kQuad, "Quads");
  data.notes = {
      "STE, sample test efficiency, is hits / tests. No kernel or width changes these figures."};
  return data;
}

}  // namespace
}  // namespace lanescope::luong

namespace lanescope {

extern const Table luong_t_sample_tests{"sample_tests",
                                        "sample test efficiency and micropolygons, by scene",
                                        luong::compared<luong::build>};

}  // namespace lanescope
