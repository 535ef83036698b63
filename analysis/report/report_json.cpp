// SPDX-License-Identifier: MIT
// Writes reports; report_reader.cpp reads them.
#include "analysis/report/report_json.h"

#include <fmt/format.h>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/figures.h"
#include "simulator/memory.h"

namespace lanescope {

/// Generated from analysis/data/report.schema.json; without the parameters.
extern const char* const kReportJsonSchema;

namespace {

using Json = nlohmann::ordered_json;

Json ratio_json(const Ratio& ratio) {
  return {{"numerator", ratio.numerator},
          {"denominator", ratio.denominator},
          {"value", number_or_null(ratio.value())}};
}

template <class Record, class Write>
Json list_json(const std::vector<Record>& records, Write write) {
  Json list = Json::array();
  for (const Record& record : records) list.push_back(write(record));
  return list;
}

Json counter_json(const CounterRecord& counter) {
  return {{"name", counter.name},
          {"meaning", counter.meaning},
          {"unit", counter.unit},
          {"value", counter.value}};
}

Json source_json(const SourceRecord& source) {
  return {{"hash", hash_text(source.hash)},
          {"pieces", source.pieces},
          {"pieces_observed", source.pieces_observed},
          {"counters", list_json(source.counters, counter_json)}};
}

Json element_json(const ElementRecord& element) {
  return {
      {"counter", element.counter}, {"name", element.name}, {"abbreviation", element.abbreviation}};
}

Json output_json(const OutputRecord& output) {
  return {{"hash", hash_text(output.hash)}, {"counters", list_json(output.counters, counter_json)}};
}

Json instruction_json(const InstructionRecord& counts) {
  return {{"mnemonic", counts.mnemonic},
          {"issued", counts.issued},
          {"active", counts.active},
          {"overhead_issued", counts.overhead_issued},
          {"overhead_active", counts.overhead_active}};
}

Json memory_json(const MemoryRecord& memory) {
  return {{"mnemonic", memory.mnemonic},
          {"issued", memory.issued},
          {"active", memory.active},
          {"lines", memory.lines},
          {"lines_histogram", memory.lines_histogram},
          {"conflicts", memory.conflicts}};
}

Json lane_groups_json(const LaneGroupRecord& record) {
  return {{"mnemonic", record.mnemonic},
          {"issued", record.issued},
          {"active_groups", record.groups.active},
          {"dense_groups", record.groups.dense}};
}

Json stage_json(const StageRecord& stage, int width) {
  return {{"name", stage.name},
          {"utilization", ratio_json(utilization(stage, width))},
          {"instructions", list_json(stage.instructions, instruction_json)},
          {"lane_active", stage.lane_active},
          {"histogram", stage.histogram},
          {"memory", list_json(stage.memory, memory_json)},
          {"lane_groups", list_json(stage.lane_groups, lane_groups_json)}};
}

Json series_json(const SeriesRecord& series) {
  return {{"name", series.name},
          {"meaning", series.meaning},
          {"index", series.index},
          {"unit", series.unit},
          {"values", series.values}};
}

Json source_line_json(const SourceLineRecord& line) {
  Json json = {{"file", line.place.file}, {"line", line.place.line}, {"stage", line.stage},
               {"issued", line.issued},   {"active", line.active},   {"overhead", line.overhead}};
  if (line.block) json["block"] = {{"file", line.block->file}, {"line", line.block->line}};
  return json;
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

Json entry_json(const InstructionEntry& entry) {
  return {{"mnemonic", entry.mnemonic},
          {"meaning", entry.meaning},
          {"class", entry.instruction_class},
          {"charge", entry.charge}};
}

Json timing_json(const Timing& timing) {
  return {{"wall_ms", json_ms(timing.wall_ms)},
          {"threads", timing.threads},
          {"host", timing.host},
          {"compiler", timing.compiler},
          {"kernel_ms", list_json(timing.kernel_ms, json_ms)},
          {"source_ms", json_ms(timing.source_ms)},
          {"observation_ms", json_ms(timing.observation_ms)},
          {"peak_memory_bytes", timing.peak_memory_bytes}};
}

}  // namespace

Json to_json(const RunRecord& run) {
  const Configuration& c = run.configuration;
  return {{"parameters", configuration_json(c)},
          {"workload", run.workload},
          {"source", source_json(run.source)},
          {"element", element_json(run.element)},
          {"stages", list_json(run.stages, [&](const auto& s) { return stage_json(s, c.width); })},
          {"counters", list_json(run.counters, counter_json)},
          {"metrics", list_json(run.metrics, [&](const auto& m) { return metric_json(run, m); })},
          {"series", list_json(run.series, series_json)},
          {"source_lines", list_json(run.source_lines, source_line_json)},
          {"results_hash", hash_text(run.results_hash)},
          {"output", output_json(run.output)}};
}

Json to_json(const Report& report) {
  return {{"schema", {{"name", kReportSchema}, {"version", kReportVersion}}},
          {"made_by",
           {{"program", "lanescope"},
            {"version", report.program_version},
            {"commit", report.commit.empty() ? Json(nullptr) : Json(report.commit)},
            {"command", report.command}}},
          {"machine", {{"line_bytes", kLineBytes}, {"element_types", kElementTypes}}},
          {"instructions", list_json(report.instructions, entry_json)},
          {"runs", list_json(report.runs, [](const RunRecord& run) { return to_json(run); })},
          {"timing", timing_json(report.timing)}};
}

std::string report_text(const Report& report) { return json_text(to_json(report)); }

std::string report_json_schema() {
  Json schema = Json::parse(kReportJsonSchema);
  schema["$defs"]["parameters"] = configuration_schema();
  return json_text(schema);
}

}  // namespace lanescope
