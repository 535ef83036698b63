// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/thesis_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/base/json_text.h"
#include "analysis/studies/luong/comparison.h"
#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/tables/utilization.h"
#include "analysis/studies/luong/thesis.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;

Configuration first_configuration(const ReportView& view) {
  const auto& runs = view.report().runs;
  return runs.empty() ? Configuration{} : runs.front().configuration;
}

template <class WidthFigure>
Json over_widths(const WidthFigure& figure) {
  Json list = Json::array();
  for (const int width : kThesisWidths) list.push_back(number_or_null(figure(width)));
  return list;
}

Json utilization_json(const ReportView& view, const UtilizationTable& table) {
  const Series& series = table.series;
  Json busy = Json::object();
  Json share = Json::object();
  for (const std::string_view stage : thesis_stages(table)) {
    const std::string name(stage);
    busy[name] = over_widths([&](int w) { return mean_stage_utilization(view, series, stage, w); });
    share[name] = over_widths([&](int w) { return stage_share(view, series, stage, w); });
  }
  busy["Overall"] = over_widths([&](int w) { return overall_utilization(view, series, w); });
  Json json = {{"algorithm", series.kernel == "lockstep" ? "LOCKSTEP" : "REPACK"},
               {"micropolygon", series.facet},
               {"utilization", busy},
               {"fraction_of_time", share},
               {"ops_per_mp", over_widths([&](int w) { return instructions(view, series, w); })}};
  if (table.number == "4.1") json["note"] = "Setup is omitted, as in the thesis";
  return json;
}

Json overhead_json(const ReportView& view) {
  Json shares = Json::object();
  for (const std::string_view stage : kThesisStages)
    shares[std::string(stage)] = number_or_null(overhead_over_widths(view, kRepackTriangle, stage));
  return {
      {"algorithm", "REPACK"},
      {"overhead", shares},
      {"definition",
       "share of the stage's own instructions that are spent on buffers, mean over the widths"}};
}

Json shape_json(const ReportView& view, const Series& series) {
  Json counts = Json::object();
  for (const std::string_view stage : {"Bound", "Test", "Process"})
    counts[std::string(stage)] =
        over_widths([&](int w) { return mean_stage_instructions(view, series, stage, w); });
  counts["Total"] = over_widths([&](int w) { return instructions(view, series, w); });
  return {{"ste", number_or_null(sample_test_efficiency(view, series.facet))},
          {"micropolygons", number_or_null(micropolygons_rasterized(view, series.facet))},
          {"ops_per_mp", counts}};
}

std::optional<double> largest(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return a ? a : b;
  return std::max(*a, *b);
}

std::optional<double> larrabee_units(const ReportView& view, const Series& series) {
  return quotient(instructions_per_second(view, series, false), instructions_of_a_unit());
}

Json working_set_json(const ReportView& view) {
  std::optional<double> maximum;
  for (const int width : kThesisWidths)
    maximum = largest(maximum, largest_working_set(view, kRepackTriangle, width));
  return {{"average", number_or_null(average_working_set(view, kRepackTriangle, kClaimWidth))},
          {"maximum", number_or_null(maximum)}};
}

Json claims_json(const ReportView& view) {
  const auto ste =
      quotient(sample_test_efficiency(view, kQuad), sample_test_efficiency(view, kTriangle));
  const auto per_quad = quotient(instructions(view, kLockstepQuad, kClaimWidth),
                                 instructions(view, kLockstepTriangle, kClaimWidth));
  constexpr int kVertexBytes = kAttributeCount * static_cast<int>(sizeof(float));
  return {{"quads_total_operations_saved",
           number_or_null(saved_by_quads(view, "lockstep", kClaimWidth))},
          {"quads_ste_over_triangles", number_or_null(ste)},
          {"quad_over_triangle_ops_per_mp", number_or_null(per_quad)},
          {"repack_working_set_over_width", working_set_json(view)},
          {"conflict_rate_max_at_w64",
           number_or_null(largest(conflicting_invocations(view, kLockstepTriangle, 64),
                                  conflicting_invocations(view, kRepackTriangle, 64)))},
          {"test_and_stream_load_combined_utilization",
           number_or_null(test_and_load_utilization(view, kRepackTriangle, kClaimWidth))},
          {"vertex_bytes", kVertexBytes},
          {"triangle_bytes", 3 * kVertexBytes},
          {"ops_per_mp_at_w16", number_or_null(instructions(view, kLockstepTriangle, kClaimWidth))},
          {"larrabee_units_at_60fps",
           {{"triangles", number_or_null(larrabee_units(view, kLockstepTriangle))},
            {"quads", number_or_null(larrabee_units(view, kLockstepQuad))},
            {"vector_ops_per_second",
             number_or_null(instructions_per_second(view, kLockstepTriangle, false))}}}};
}

}  // namespace

Json thesis_json(const ReportView& view) {
  return {{"source",
           fmt::format("lanescope {}: {}", view.report().program_version, view.report().command)},
          {"setup", setup_json(first_configuration(view), view.scenes())},
          {"table_4_1", utilization_json(view, utilization_table("4.1"))},
          {"table_4_2", utilization_json(view, utilization_table("4.2"))},
          {"table_4_3", overhead_json(view)},
          {"table_4_4", utilization_json(view, utilization_table("4.4"))},
          {"table_4_5", utilization_json(view, utilization_table("4.5"))},
          {"table_4_6",
           {{"algorithm", "LOCKSTEP"},
            {"triangle", shape_json(view, kLockstepTriangle)},
            {"quad", shape_json(view, kLockstepQuad)}}},
          {"text_claims", claims_json(view)}};
}

}  // namespace lanescope::luong
