// SPDX-License-Identifier: MIT
// Reads what report_json.cpp writes, and refuses everything else.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "analysis/base/files.h"
#include "analysis/base/json_cursor.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/figures.h"
#include "analysis/report/report_json.h"
#include "simulator/memory.h"

namespace lanescope {
namespace {

double read_number(const JsonCursor& cursor) { return cursor.number(); }
std::uint64_t read_count(const JsonCursor& cursor) { return cursor.count(); }

/// Checks a count that other counts give.
void require_count(const JsonCursor& cursor, std::uint64_t expected, std::string_view reason) {
  if (cursor.count() != expected) cursor.fail(fmt::format("{}, {}", expected, reason));
}

/// Checks a count of some among `limit`.
void require_at_most(const JsonCursor& cursor, std::uint64_t limit, std::string_view reason) {
  if (cursor.count() > limit) cursor.fail(fmt::format("at most {}, {}", limit, reason));
}

std::uint64_t sum(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

/// Sum of k over the things that a histogram counts.
std::uint64_t weighted_sum(const std::vector<std::uint64_t>& histogram) {
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < histogram.size(); ++k) sum += k * histogram[k];
  return sum;
}

/// Checks that a ratio is what the counts give, so that an edited report is not believed.
void check_ratio(const JsonCursor& cursor, const Ratio& expected) {
  cursor.require_members({"numerator", "denominator", "value"});
  require_count(cursor.member("numerator"), expected.numerator, "which the counts give");
  require_count(cursor.member("denominator"), expected.denominator, "which the counts give");
  const JsonCursor value = cursor.member("value");
  const auto derived = expected.value();
  if (!derived && !value.is_null()) value.fail("null, as the denominator is 0");
  if (derived && std::abs(value.number() - *derived) > 1e-12 * std::abs(*derived))
    value.fail(fmt::format("{}, the numerator over the denominator", *derived));
}

TessellationCounts read_tessellation(const JsonCursor& cursor) {
  cursor.require_members(
      {"patches_culled", "patches_split", "patches_dropped", "grids", "micropolygons", "dropped"});
  TessellationCounts counts;
  counts.patches_culled = cursor.member("patches_culled").count();
  counts.patches_split = cursor.member("patches_split").count();
  counts.patches_dropped = cursor.member("patches_dropped").count();
  counts.grids = cursor.member("grids").count();
  counts.micropolygons = cursor.member("micropolygons").count();
  counts.dropped = cursor.member("dropped").count();
  return counts;
}

InstructionRecord read_instruction(const JsonCursor& cursor) {
  cursor.require_members({"mnemonic", "issued", "active", "overhead_issued", "overhead_active"});
  require_at_most(cursor.member("overhead_issued"), cursor.member("issued").count(),
                  "which were issued");
  require_at_most(cursor.member("overhead_active"), cursor.member("active").count(),
                  "which were active");
  return {cursor.member("mnemonic").string(), cursor.member("issued").count(),
          cursor.member("active").count(), cursor.member("overhead_issued").count(),
          cursor.member("overhead_active").count()};
}

std::vector<std::uint64_t> read_counts(const JsonCursor& cursor, int length) {
  std::vector<std::uint64_t> counts = read_list(cursor, read_count);
  if (counts.size() != static_cast<std::size_t>(length))
    throw InputError(cursor.where(), "has {} elements; {} are needed", counts.size(), length);
  return counts;
}

std::vector<std::uint64_t> read_at_least(const JsonCursor& cursor, int length) {
  std::vector<std::uint64_t> counts = read_list(cursor, read_count);
  if (counts.size() < static_cast<std::size_t>(length))
    throw InputError(cursor.where(), "has {} elements; {} are needed", counts.size(), length);
  return counts;
}

/// Checks that executions were observed of what was issued, and that their sums fit together. Lanes
/// are those that accessed memory, whatever the instruction was charged.
void check_memory(const JsonCursor& cursor, const MemoryRecord& memory, int width,
                  const StageRecord& stage) {
  const auto issued =
      std::find_if(stage.instructions.begin(), stage.instructions.end(),
                   [&](const auto& counts) { return counts.mnemonic == memory.mnemonic; });
  if (issued == stage.instructions.end())
    cursor.member("mnemonic").fail("the mnemonic of an instruction of this stage");
  require_count(cursor.member("issued"), sum(memory.lines_histogram), "which the histogram gives");
  require_count(cursor.member("lines"), weighted_sum(memory.lines_histogram),
                "which the histogram gives");
  require_at_most(cursor.member("issued"), issued->issued, "which were issued");
  require_at_most(cursor.member("active"), memory.issued * static_cast<std::uint64_t>(width),
                  "which there are in the instructions observed");
  require_at_most(cursor.member("conflicts"), memory.active, "which were active");
}

MemoryRecord read_memory(const JsonCursor& cursor, int width, const StageRecord& stage) {
  cursor.require_members({"mnemonic", "issued", "active", "lines", "lines_histogram", "conflicts"});
  MemoryRecord memory{cursor.member("mnemonic").string(),
                      cursor.member("issued").count(),
                      cursor.member("active").count(),
                      cursor.member("lines").count(),
                      read_at_least(cursor.member("lines_histogram"), width + 1),
                      cursor.member("conflicts").count()};
  check_memory(cursor, memory, width, stage);
  return memory;
}

/// Checks that the lanes and their histogram are of the instructions issued.
void check_lanes(const JsonCursor& cursor, const StageRecord& stage) {
  const std::uint64_t issued = stage.total().issued;
  if (sum(stage.histogram) != issued)
    throw InputError(cursor.member("histogram").where(),
                     "adds up to {}; {} instructions were issued", sum(stage.histogram), issued);
  if (sum(stage.lane_active) != weighted_sum(stage.histogram))
    throw InputError(cursor.member("lane_active").where(), "adds up to {}; {} by the histogram",
                     sum(stage.lane_active), weighted_sum(stage.histogram));
}

StageRecord read_stage(const JsonCursor& cursor, int width) {
  cursor.require_members(
      {"name", "utilization", "instructions", "lane_active", "histogram", "memory"});
  StageRecord stage;
  stage.name = cursor.member("name").string();
  stage.instructions = read_list(cursor.member("instructions"), read_instruction);
  stage.lane_active = read_counts(cursor.member("lane_active"), width);
  stage.histogram = read_counts(cursor.member("histogram"), width + 1);
  check_ratio(cursor.member("utilization"), utilization(stage, width));
  check_lanes(cursor, stage);
  for (const JsonCursor& memory : cursor.member("memory").items())
    stage.memory.push_back(read_memory(memory, width, stage));
  return stage;
}

CounterRecord read_counter(const JsonCursor& cursor) {
  cursor.require_members({"name", "meaning", "unit", "value"});
  return {cursor.member("name").string(), cursor.member("meaning").string(),
          cursor.member("unit").string(), cursor.member("value").count()};
}

MetricRecord read_metric(const JsonCursor& cursor, const RunRecord& run) {
  cursor.require_members({"name", "meaning", "numerator_counter", "denominator_counter", "ratio"});
  const auto counter = [&](std::string_view member) {
    const std::string name = cursor.member(member).string();
    if (!run.counter(name)) cursor.member(member).fail("the name of a counter of this run");
    return name;
  };
  MetricRecord metric{cursor.member("name").string(), cursor.member("meaning").string(),
                      counter("numerator_counter"), counter("denominator_counter")};
  check_ratio(cursor.member("ratio"),
              {*run.counter(metric.numerator), *run.counter(metric.denominator)});
  return metric;
}

SeriesRecord read_series(const JsonCursor& cursor) {
  cursor.require_members({"name", "meaning", "index", "unit", "values"});
  return {cursor.member("name").string(), cursor.member("meaning").string(),
          cursor.member("index").string(), cursor.member("unit").string(),
          read_list(cursor.member("values"), read_count)};
}

Observation read_observation(const JsonCursor& cursor) {
  cursor.require_members({"packets", "packets_observed"});
  require_at_most(cursor.member("packets_observed"), cursor.member("packets").count(),
                  "the packets");
  return {cursor.member("packets").count(), cursor.member("packets_observed").count()};
}

SourceLineRecord read_source_line(const JsonCursor& cursor) {
  cursor.require_members({"file", "line", "stage", "issued", "active", "overhead"});
  return {
      cursor.member("file").string(),  static_cast<std::uint32_t>(cursor.member("line").integer(1)),
      cursor.member("stage").string(), cursor.member("issued").count(),
      cursor.member("active").count(), cursor.member("overhead").count()};
}

/// Checks that the lines of a stage together issued no more than the stage.
void check_source_lines(const JsonCursor& lines, const RunRecord& run) {
  std::map<std::string, std::uint64_t> left;
  for (const StageRecord& stage : run.stages) left[stage.name] = stage.total().issued;
  for (const JsonCursor& line : lines.items()) {
    const auto stage = left.find(line.member("stage").string());
    if (stage == left.end()) line.member("stage").fail("the name of a stage of this run");
    require_at_most(line.member("issued"), stage->second, "which the stage issued");
    require_at_most(line.member("overhead"), line.member("issued").count(), "which were issued");
    stage->second -= line.member("issued").count();
  }
}

RunRecord read_run(const JsonCursor& cursor) {
  cursor.require_members({"parameters", "scene_hash", "thesis_like", "tessellation", "stages",
                          "counters", "metrics", "series", "observation", "source_lines",
                          "hits_hash", "frame_hash", "samples_covered"});
  RunRecord run;
  run.configuration = read_configuration(cursor.member("parameters"));
  run.scene_hash = cursor.member("scene_hash").hash();
  run.thesis_like = cursor.member("thesis_like").boolean();
  run.tessellation = read_tessellation(cursor.member("tessellation"));
  for (const JsonCursor& stage : cursor.member("stages").items())
    run.stages.push_back(read_stage(stage, run.configuration.width));
  run.counters = read_list(cursor.member("counters"), read_counter);
  for (const JsonCursor& metric : cursor.member("metrics").items())
    run.metrics.push_back(read_metric(metric, run));
  run.series = read_list(cursor.member("series"), read_series);
  run.observation = read_observation(cursor.member("observation"));
  run.source_lines = read_list(cursor.member("source_lines"), read_source_line);
  check_source_lines(cursor.member("source_lines"), run);
  run.hits_hash = cursor.member("hits_hash").hash();
  run.frame_hash = cursor.member("frame_hash").hash();
  run.samples_covered = cursor.member("samples_covered").count();
  return run;
}

InstructionEntry read_entry(const JsonCursor& cursor) {
  cursor.require_members({"mnemonic", "meaning", "class", "charge"});
  return {cursor.member("mnemonic").string(), cursor.member("meaning").string(),
          cursor.member("class").string(), cursor.member("charge").string()};
}

Timing read_timing(const JsonCursor& cursor) {
  cursor.require_members({"wall_ms", "threads", "host", "compiler", "kernel_ms", "dicing_ms",
                          "observation_ms", "peak_memory_bytes"});
  return {cursor.member("wall_ms").number(),
          cursor.member("threads").integer(1),
          cursor.member("host").string(),
          cursor.member("compiler").string(),
          read_list(cursor.member("kernel_ms"), read_number),
          cursor.member("dicing_ms").number(),
          cursor.member("observation_ms").number(),
          cursor.member("peak_memory_bytes").count()};
}

/// Looks at the version before anything else, as a newer form may have other members.
void check_schema(const JsonCursor& document) {
  const JsonCursor schema = document.member("schema");
  schema.require_members({"name", "version"});
  if (schema.member("name").string() != kReportSchema)
    schema.member("name").fail(fmt::format("\"{}\"", kReportSchema));
  const int version = schema.member("version").integer(1);
  if (version > kReportVersion)
    throw InputError(schema.member("version").where(),
                     "version {} is newer than {}, the newest that this program reads", version,
                     kReportVersion);
  if (version < kReportVersion)
    throw InputError(schema.member("version").where(),
                     "version {} is older than {}, the only one that this program reads", version,
                     kReportVersion);
}

/// The machine is the same in every report of a version.
void check_machine(const JsonCursor& machine) {
  machine.require_members({"line_bytes", "element_types"});
  if (machine.member("line_bytes").count() != kLineBytes)
    machine.member("line_bytes").fail(fmt::format("{}", kLineBytes));
  const std::vector<JsonCursor> types = machine.member("element_types").items();
  if (types.size() != kElementTypes.size())
    throw InputError(machine.member("element_types").where(), "has {} elements; {} are needed",
                     types.size(), kElementTypes.size());
  for (std::size_t i = 0; i < types.size(); ++i)
    if (types[i].string() != kElementTypes[i])
      types[i].fail(fmt::format("\"{}\"", kElementTypes[i]));
}

/// Checks what holds between members: every mnemonic is explained, each run has its time.
void check_consistency(const JsonCursor& document, const Report& report) {
  std::set<std::string> explained;
  for (const InstructionEntry& entry : report.instructions) explained.insert(entry.mnemonic);
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    for (const StageRecord& stage : report.runs[i].stages)
      for (const InstructionRecord& counts : stage.instructions)
        if (!explained.contains(counts.mnemonic))
          throw InputError(document.member("runs").items()[i].where(),
                           "the instruction '{}' is not among /instructions", counts.mnemonic);
  const std::size_t times = report.timing.kernel_ms.size();
  if (times != report.runs.size())
    throw InputError(document.member("timing").member("kernel_ms").where(),
                     "has {} elements; {} are needed, one for each run", times, report.runs.size());
}

}  // namespace

Report parse_report(std::string_view text, const std::string& where) {
  const nlohmann::ordered_json json = parse_json(text, where);
  const JsonCursor document(json, where);
  check_schema(document);
  document.require_members({"schema", "made_by", "machine", "instructions", "runs", "timing"});
  const JsonCursor made_by = document.member("made_by");
  made_by.require_members({"program", "version", "commit", "command"});
  if (made_by.member("program").string() != "lanescope")
    made_by.member("program").fail("\"lanescope\"");
  Report report;
  report.program_version = made_by.member("version").string();
  if (!made_by.member("commit").is_null()) report.commit = made_by.member("commit").string();
  check_machine(document.member("machine"));
  report.command = made_by.member("command").string();
  report.instructions = read_list(document.member("instructions"), read_entry);
  report.runs = read_list(document.member("runs"), read_run);
  report.timing = read_timing(document.member("timing"));
  check_consistency(document, report);
  return report;
}

Report read_report(const std::string& path) { return parse_report(read_file(path), path); }

}  // namespace lanescope
