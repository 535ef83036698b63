// SPDX-License-Identifier: MIT
// Writes reports; report_reader.cpp reads them.
#include "analysis/report_json.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/figures.h"
#include "analysis/json_text.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(std::uint64_t value) { return fmt::format("{:#018x}", value); }

/// Microseconds are enough for times.
double rounded_ms(double ms) { return std::round(ms * 1000.0) / 1000.0; }

Json ratio_json(const Ratio& ratio) {
  const auto value = ratio.value();
  return {{"numerator", ratio.numerator},
          {"denominator", ratio.denominator},
          {"value", value ? Json(*value) : Json(nullptr)}};
}

template <class Record, class Write>
Json list_json(const std::vector<Record>& records, Write write) {
  Json list = Json::array();
  for (const Record& record : records) list.push_back(write(record));
  return list;
}

Json scene_json(const RunRecord& run) {
  const Configuration& c = run.configuration;
  return {
      {"name", c.scene},
      {"mesh_patches", c.is_mesh() ? Json(name_of(kMeshPatches, *c.mesh_patches)) : Json(nullptr)},
      {"frame", c.frame},
      {"turn_degrees", json_number(c.turn_degrees)},
      {"thesis_like", run.thesis_like},
      {"hash", hex(run.scene_hash)}};
}

Json parameters_json(const Configuration& c) {
  return {{"mode", name_of(kModes, c.mode)},
          {"cull_backfaces", c.options.cull_backfaces},
          {"edges", name_of(kEdges, c.options.edges)},
          {"stream_load_threshold", json_number(c.options.stream_load_threshold)},
          {"width_px", c.tessellation.width_px},
          {"height_px", c.tessellation.height_px},
          {"samples_per_pixel", c.samples_per_pixel},
          {"jitter", c.jitter},
          {"seed", c.seed},
          {"dice_area_px", json_number(c.tessellation.dice_area_px)},
          {"grid_limit", c.tessellation.grid_limit},
          {"packet_capacity", c.tessellation.packet_capacity},
          {"grid_overlap_px", json_number(c.tessellation.grid_overlap_px)}};
}

Json tessellation_json(const TessellationCounts& counts) {
  return {{"patches_culled", counts.patches_culled},   {"patches_split", counts.patches_split},
          {"patches_dropped", counts.patches_dropped}, {"grids", counts.grids},
          {"micropolygons", counts.micropolygons},     {"dropped", counts.dropped}};
}

Json instruction_json(const InstructionRecord& counts) {
  return {{"mnemonic", counts.mnemonic},
          {"issued", counts.issued},
          {"active", counts.active},
          {"overhead_issued", counts.overhead_issued},
          {"overhead_active", counts.overhead_active}};
}

Json stage_json(const StageRecord& stage, int width) {
  return {{"name", stage.name},
          {"utilization", ratio_json(utilization(stage, width))},
          {"instructions", list_json(stage.instructions, instruction_json)},
          {"lane_active", stage.lane_active},
          {"histogram", stage.histogram}};
}

Json counter_json(const CounterRecord& counter) {
  return {{"name", counter.name},
          {"meaning", counter.meaning},
          {"unit", counter.unit},
          {"value", counter.value}};
}

Json metric_json(const RunRecord& run, const MetricRecord& metric) {
  const Ratio ratio{run.counter(metric.numerator).value_or(0),
                    run.counter(metric.denominator).value_or(0)};
  return {{"name", metric.name},
          {"meaning", metric.meaning},
          {"numerator_counter", metric.numerator},
          {"denominator_counter", metric.denominator},
          {"ratio", ratio_json(ratio)}};
}

Json run_json(const RunRecord& run) {
  const Configuration& c = run.configuration;
  return {{"kernel", c.kernel},
          {"width_lanes", c.width},
          {"micropolygon", to_string(c.shape())},
          {"scene", scene_json(run)},
          {"parameters", parameters_json(c)},
          {"tessellation", tessellation_json(run.tessellation)},
          {"stages", list_json(run.stages, [&](const auto& s) { return stage_json(s, c.width); })},
          {"counters", list_json(run.counters, counter_json)},
          {"metrics", list_json(run.metrics, [&](const auto& m) { return metric_json(run, m); })},
          {"hits_hash", hex(run.hits_hash)},
          {"frame_hash", hex(run.frame_hash)},
          {"samples_covered", run.samples_covered}};
}

Json entry_json(const InstructionEntry& entry) {
  return {{"mnemonic", entry.mnemonic},
          {"meaning", entry.meaning},
          {"class", entry.instruction_class},
          {"charge", entry.charge}};
}

Json timing_json(const Timing& timing) {
  return {{"wall_ms", rounded_ms(timing.wall_ms)},
          {"threads", timing.threads},
          {"host", timing.host},
          {"compiler", timing.compiler},
          {"kernel_ms", list_json(timing.kernel_ms, rounded_ms)}};
}

}  // namespace

Json to_json(const Report& report) {
  return {{"schema", {{"name", kReportSchema}, {"version", kReportVersion}}},
          {"made_by",
           {{"program", "lanescope"},
            {"version", report.program_version},
            {"command", report.command}}},
          {"instructions", list_json(report.instructions, entry_json)},
          {"runs", list_json(report.runs, run_json)},
          {"timing", timing_json(report.timing)}};
}

std::string report_text(const Report& report) { return json_text(to_json(report)); }

}  // namespace lanescope
