// SPDX-License-Identifier: MIT
#include "tests/analysis/sample_report.h"

namespace lanescope::testing {
namespace {

constexpr int kWidth = 8;

/// As many lanes as possible on in each instruction, and always the first ones.
void add_lanes(StageRecord& record, const SampleStage& stage) {
  record.lane_active.assign(kWidth, 0);
  record.histogram.assign(kWidth + 1, 0);
  for (std::uint64_t i = 0; i < stage.issued; ++i) {
    const std::uint64_t lanes = (stage.active + i) / stage.issued;
    record.histogram[lanes] += 1;
    for (std::size_t lane = 0; lane < lanes; ++lane) record.lane_active[lane] += 1;
  }
}

/// All `add`, but for the first instruction of Process: a `scatter` to one element.
StageRecord stage_record(const SampleStage& stage) {
  StageRecord record;
  record.name = stage.name;
  record.instructions = {
      {"add", stage.issued, stage.active, stage.overhead_issued, stage.overhead_issued}};
  add_lanes(record, stage);
  if (stage.name != "Process" || stage.issued == 0 || stage.active < stage.issued) return record;
  const std::uint64_t lanes = stage.active / stage.issued;
  record.instructions.front().issued -= 1;
  record.instructions.front().active -= lanes;
  record.instructions.push_back({"scatter", 1, lanes});
  std::vector<std::uint64_t> lines(kWidth + 1, 0);
  lines[1] = 1;
  record.memory = {{"scatter", 1, lanes, 1, lines, lanes - 1}};
  record.lane_groups = {{"scatter", 1, lane_groups_of((std::uint64_t{1} << lanes) - 1)}};
  return record;
}

/// One piece of three is observed: an instruction of each stage, with one lane on.
void add_observation(RunRecord& run) {
  run.source.pieces = 3;
  run.source.pieces_observed = 1;
  for (const StageRecord& stage : run.stages)
    run.source_lines.push_back(
        {"kernels/sample.h", static_cast<std::uint32_t>(10 + run.source_lines.size()), stage.name,
         1, 1, stage.total().overhead_issued > 0 ? 1u : 0u, SourcePlace{"kernels/sample.h", 5}});
  run.series = {{"box_candidates", "candidates of each box", "candidates", "boxes", {0, 3, 1}}};
}

void add_counters(RunRecord& run, std::uint64_t rasterized) {
  run.counters = {
      {"micropolygons_seen", "micropolygons in the packets", "micropolygons", 2 * rasterized},
      {"micropolygons_culled", "facing away", "micropolygons", rasterized},
      {"micropolygons_rasterized", "the others", "micropolygons", rasterized},
      {"tests", "samples tested", "tests", 10 * rasterized},
      {"hits", "samples hit", "hits", 2 * rasterized},
      {"process_issued", "invocations of Process", "invocations", 50},
      {"conflict_invocations", "those with a conflict", "invocations", 2},
      {"conflict_hits", "hits that conflict", "hits", 1}};
  run.metrics = {{"ste", "sample test efficiency", "hits", "tests"}};
}

std::vector<SampleStage> quads(std::vector<SampleStage> stages) {
  for (SampleStage& stage : stages) {
    if (stage.name == "Setup") continue;
    stage.issued = stage.issued * 8 / 10;
    stage.active = stage.active * 8 / 10;
    stage.overhead_issued = stage.overhead_issued * 8 / 10;
  }
  return stages;
}

RunRecord quad_run(const std::string& kernel, const std::string& scene,
                   const std::vector<SampleStage>& stages, std::uint64_t rasterized) {
  RunRecord run = sample_run(kernel, scene, "quad", quads(stages), rasterized / 2);
  for (CounterRecord& counter : run.counters)
    if (counter.name == "hits") counter.value = 3 * rasterized / 2;
  return run;
}

void add_scene(Report& report, const std::string& scene, const std::vector<SampleStage>& lockstep,
               const std::vector<SampleStage>& repack, std::uint64_t rasterized) {
  report.runs.push_back(sample_run("lockstep", scene, "triangle", lockstep, rasterized));
  report.runs.push_back(sample_run("repack", scene, "triangle", repack, rasterized));
  report.runs.push_back(quad_run("lockstep", scene, lockstep, rasterized));
  report.runs.push_back(quad_run("repack", scene, repack, rasterized));
}

Configuration sample_configuration(const std::string& kernel, const std::string& scene,
                                   const std::string& micropolygon) {
  Arguments given;
  given.set("kernel", kernel);
  given.set("width_lanes", std::uint64_t{kWidth});
  given.set("scene", scene);
  given.set("micropolygon", micropolygon);
  given.set("frame", std::uint64_t{0});
  return resolved(given);
}

/// What the source counted is 1, 2, 3 and so on.
void add_kind(RunRecord& run, const Workload& workload) {
  run.workload = workload.name;
  for (const CounterInfo& info : workload.counters)
    run.source.counters.push_back({std::string(info.name), std::string(info.meaning),
                                   std::string(info.unit), run.source.counters.size() + 1});
}

}  // namespace

RunRecord sample_run(const std::string& kernel, const std::string& scene,
                     const std::string& micropolygon, const std::vector<SampleStage>& stages,
                     std::uint64_t rasterized) {
  RunRecord run;
  run.configuration = sample_configuration(kernel, scene, micropolygon);
  add_kind(run, *find_kernel(kernel).workload);
  run.element = {"micropolygons_rasterized", "micropolygon", "mp"};
  for (const SampleStage& stage : stages) run.stages.push_back(stage_record(stage));
  add_counters(run, rasterized);
  add_observation(run);
  if (kernel == "repack") {
    run.counters.push_back({"working_set_sum", "micropolygons alive", "micropolygons", 280});
    run.counters.push_back({"working_set_observations", "observations", "observations", 10});
    run.counters.push_back({"working_set_maximum", "most alive", "micropolygons", 32});
  }
  run.source.hash = 0x0123456789abcdef;
  run.results_hash = 0xffffffffffffffff;
  run.output = {0x00000000000000ff, {{"samples_covered", "samples with a hit", "samples", 10}}};
  return run;
}

Report sample_report() {
  Report report;
  report.program_version = "0.1.0";
  report.commit = "0123456789ab";
  report.command = "lanescope tables";
  report.instructions = {{"add", "r[i] = a[i] + b[i]", "arithmetic", "active_lanes"},
                         {"scatter", "memory[index[i]] = v[i]", "memory", "active_lanes"}};
  add_scene(report, "ballroll",
            {{"Setup", 2, 16}, {"Bound", 10, 72}, {"Test", 60, 360}, {"Process", 30, 60}},
            {{"Setup", 2, 16},
             {"Bound", 10, 72, 2},
             {"Test Stream-load", 20, 32, 20},
             {"Test", 60, 456, 15},
             {"Process", 10, 80, 4}},
            20);
  add_scene(report, "columnpivot",
            {{"Setup", 3, 12}, {"Bound", 20, 128}, {"Test", 60, 240}, {"Process", 20, 80}},
            {{"Setup", 3, 12},
             {"Bound", 20, 128, 2},
             {"Test Stream-load", 10, 16, 10},
             {"Test", 40, 320, 10},
             {"Process", 10, 40, 2}},
            10);
  add_scene(report, "teapot", {{"Setup", 1, 8}, {"Bound", 10, 80}, {"Test", 10, 80}},
            {{"Setup", 1, 8}, {"Bound", 10, 80}, {"Test", 10, 80}}, 10);
  report.timing = {
      12.5, 2,    "a processor", "a compiler", std::vector<double>(report.runs.size(), 0.25),
      1.5,  0.75, 1048576};
  return report;
}

}  // namespace lanescope::testing
