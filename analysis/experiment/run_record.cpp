// SPDX-License-Identifier: MIT
#include "analysis/experiment/run_record.h"

#include "simulator/base/error.h"

namespace lanescope {
namespace {

std::vector<StageRecord> stage_records(const Kernel& kernel, const Counts& counts,
                                       const MemoryAndSource& seen) {
  LANESCOPE_CHECK(counts.stages.empty() || counts.stages.size() == kernel.stages.size(),
                  "{} stages of {}: {}", kernel.stages.size(), kernel.name, counts.stages.size());
  std::vector<StageRecord> records;
  for (std::size_t i = 0; i < counts.stages.size(); ++i) {
    const StageCounts& stage = counts.stages[i];
    StageRecord record{std::string(kernel.stages[i]),
                       {},
                       stage.lane_active,
                       stage.histogram,
                       seen.memory(i),
                       seen.lane_groups(i)};
    for (const InstructionCounts& c : stage.instructions)
      record.instructions.push_back({std::string(c.info->mnemonic), c.issued, c.active,
                                     c.overhead_issued, c.overhead_active});
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<MetricRecord> metric_records(const Kernel& kernel) {
  std::vector<MetricRecord> records;
  for (const MetricInfo& info : kernel.metrics)
    records.push_back({std::string(info.name), std::string(info.meaning),
                       std::string(info.numerator), std::string(info.denominator)});
  return records;
}

std::vector<SeriesRecord> series_records(const Kernel& kernel, const KernelResult& result) {
  LANESCOPE_CHECK(result.series.size() == kernel.series.size(), "{} series of {}: {}",
                  kernel.series.size(), kernel.name, result.series.size());
  std::vector<SeriesRecord> records;
  for (std::size_t i = 0; i < kernel.series.size(); ++i) {
    const SeriesInfo& info = kernel.series[i];
    records.push_back({std::string(info.name), std::string(info.meaning), std::string(info.index),
                       std::string(info.unit), result.series[i]});
  }
  return records;
}

}  // namespace

std::vector<CounterRecord> counter_records(std::span<const CounterInfo> infos,
                                           const std::vector<std::uint64_t>& values) {
  LANESCOPE_CHECK(values.size() == infos.size(), "{} counters: {}", infos.size(), values.size());
  std::vector<CounterRecord> records;
  for (std::size_t i = 0; i < infos.size(); ++i)
    records.push_back({std::string(infos[i].name), std::string(infos[i].meaning),
                       std::string(infos[i].unit), values[i]});
  return records;
}

RunRecord run_record(const Configuration& configuration, const Kernel& kernel,
                     const KernelResult& result, const MemoryAndSource& seen) {
  RunRecord run;
  run.configuration = configuration;
  run.workload = kernel.workload->name;
  run.element = {std::string(kernel.element.counter), std::string(kernel.element.name),
                 std::string(kernel.element.abbreviation)};
  run.results_hash = result.results_hash;
  const bool counts_nothing = result.counts.stages.empty() && !kernel.stages.empty();
  if (counts_nothing) return run;
  run.stages = stage_records(kernel, result.counts, seen);
  run.counters = counter_records(kernel.counters, result.counters);
  run.metrics = metric_records(kernel);
  run.series = series_records(kernel, result);
  run.source_lines = seen.source_lines(kernel.stages);
  return run;
}

}  // namespace lanescope
