// SPDX-License-Identifier: MIT
// Reads what report_json.cpp writes, and refuses everything else.
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "analysis/figures.h"
#include "analysis/files.h"
#include "analysis/json_cursor.h"
#include "analysis/report_json.h"

namespace lanescope {
namespace {

constexpr int kMaxWidth = 64;

template <class Value, std::size_t kCount>
Value read_choice(const JsonCursor& cursor, const std::array<Choice<Value>, kCount>& choices) {
  const auto value = find_choice(choices, cursor.string());
  if (!value) cursor.fail(list_or(choices));
  return *value;
}

float read_float(const JsonCursor& cursor) {
  const double number = cursor.number();
  if (std::abs(number) > std::numeric_limits<float>::max())
    cursor.fail("a number in the range of single precision");
  return static_cast<float>(number);
}

double read_number(const JsonCursor& cursor) { return cursor.number(); }
std::uint64_t read_count(const JsonCursor& cursor) { return cursor.count(); }

/// Checks that a ratio is what the counts give, so that an edited report is not believed.
void check_ratio(const JsonCursor& cursor, const Ratio& expected) {
  cursor.require_members({"numerator", "denominator", "value"});
  const auto same = [&](std::string_view name, std::uint64_t count) {
    if (cursor.member(name).count() != count)
      cursor.member(name).fail(fmt::format("{}, which the counts give", count));
  };
  same("numerator", expected.numerator);
  same("denominator", expected.denominator);
  const JsonCursor value = cursor.member("value");
  const auto derived = expected.value();
  if (!derived && !value.is_null()) value.fail("null, as the denominator is 0");
  if (derived && std::abs(value.number() - *derived) > 1e-12 * std::abs(*derived))
    value.fail(fmt::format("{}, the numerator over the denominator", *derived));
}

void read_scene(const JsonCursor& cursor, RunRecord& run) {
  cursor.require_members({"name", "mesh_patches", "frame", "turn_degrees", "thesis_like", "hash"});
  Configuration& c = run.configuration;
  c.scene = cursor.member("name").string();
  const JsonCursor patches = cursor.member("mesh_patches");
  if (!patches.is_null()) c.mesh_patches = read_choice(patches, kMeshPatches);
  c.frame = cursor.member("frame").integer(0);
  c.turn_degrees = read_float(cursor.member("turn_degrees"));
  run.thesis_like = cursor.member("thesis_like").boolean();
  run.scene_hash = cursor.member("hash").hash();
}

void read_parameters(const JsonCursor& cursor, Configuration& c) {
  cursor.require_members({"mode", "cull_backfaces", "edges", "stream_load_threshold", "width_px",
                          "height_px", "samples_per_pixel", "jitter", "seed", "dice_area_px",
                          "grid_limit", "packet_capacity", "grid_overlap_px"});
  c.mode = read_choice(cursor.member("mode"), kModes);
  c.options.cull_backfaces = cursor.member("cull_backfaces").boolean();
  c.options.edges = read_choice(cursor.member("edges"), kEdges);
  c.options.stream_load_threshold = read_float(cursor.member("stream_load_threshold"));
  c.tessellation.width_px = cursor.member("width_px").integer(1);
  c.tessellation.height_px = cursor.member("height_px").integer(1);
  c.samples_per_pixel = cursor.member("samples_per_pixel").integer(1);
  c.jitter = cursor.member("jitter").boolean();
  c.seed = cursor.member("seed").count();
  c.tessellation.dice_area_px = read_float(cursor.member("dice_area_px"));
  c.tessellation.grid_limit = cursor.member("grid_limit").integer(1);
  c.tessellation.packet_capacity = cursor.member("packet_capacity").integer(1);
  c.tessellation.grid_overlap_px = read_float(cursor.member("grid_overlap_px"));
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

StageRecord read_stage(const JsonCursor& cursor, int width) {
  cursor.require_members({"name", "utilization", "instructions", "lane_active", "histogram"});
  StageRecord stage;
  stage.name = cursor.member("name").string();
  stage.instructions = read_list(cursor.member("instructions"), read_instruction);
  stage.lane_active = read_counts(cursor.member("lane_active"), width);
  stage.histogram = read_counts(cursor.member("histogram"), width + 1);
  check_ratio(cursor.member("utilization"), utilization(stage, width));
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

RunRecord read_run(const JsonCursor& cursor) {
  cursor.require_members({"kernel", "width_lanes", "micropolygon", "scene", "parameters",
                          "tessellation", "stages", "counters", "metrics", "hits_hash",
                          "frame_hash", "samples_covered"});
  RunRecord run;
  run.configuration.kernel = cursor.member("kernel").string();
  run.configuration.width = cursor.member("width_lanes").integer(1, kMaxWidth);
  run.configuration.options.shape = read_choice(cursor.member("micropolygon"), kShapes);
  read_scene(cursor.member("scene"), run);
  read_parameters(cursor.member("parameters"), run.configuration);
  run.tessellation = read_tessellation(cursor.member("tessellation"));
  for (const JsonCursor& stage : cursor.member("stages").items())
    run.stages.push_back(read_stage(stage, run.configuration.width));
  run.counters = read_list(cursor.member("counters"), read_counter);
  for (const JsonCursor& metric : cursor.member("metrics").items())
    run.metrics.push_back(read_metric(metric, run));
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
  cursor.require_members({"wall_ms", "threads", "host", "compiler", "kernel_ms"});
  return {cursor.member("wall_ms").number(), cursor.member("threads").integer(1),
          cursor.member("host").string(), cursor.member("compiler").string(),
          read_list(cursor.member("kernel_ms"), read_number)};
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
  document.require_members({"schema", "made_by", "instructions", "runs", "timing"});
  const JsonCursor made_by = document.member("made_by");
  made_by.require_members({"program", "version", "command"});
  if (made_by.member("program").string() != "lanescope")
    made_by.member("program").fail("\"lanescope\"");
  Report report;
  report.program_version = made_by.member("version").string();
  report.command = made_by.member("command").string();
  report.instructions = read_list(document.member("instructions"), read_entry);
  report.runs = read_list(document.member("runs"), read_run);
  report.timing = read_timing(document.member("timing"));
  check_consistency(document, report);
  return report;
}

Report read_report(const std::string& path) { return parse_report(read_file(path), path); }

}  // namespace lanescope
