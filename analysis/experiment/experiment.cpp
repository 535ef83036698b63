// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment.h"

#include <numeric>

#include "analysis/base/build_info.h"
#include "analysis/base/memory.h"
#include "analysis/base/parallel.h"
#include "analysis/experiment/group_run.h"
#include "analysis/experiment/run_record.h"
#include "analysis/experiment/stopwatch.h"
#include "analysis/experiment/width_independence.h"

namespace lanescope {
namespace {

using Indices = std::vector<std::size_t>;

/// Segments of a brief run; more of them would tell little more.
constexpr int kBriefSegments = 2;

std::vector<const Configuration*> selected(const std::vector<Configuration>& configurations,
                                           const Indices& indices) {
  std::vector<const Configuration*> all;
  for (const std::size_t index : indices) all.push_back(&configurations[index]);
  return all;
}

std::vector<int> all_segments(int count) {
  std::vector<int> segments(static_cast<std::size_t>(count));
  std::iota(segments.begin(), segments.end(), 0);
  return segments;
}

/// A few, spread evenly.
std::vector<int> brief_segments(int count) {
  if (count <= kBriefSegments) return all_segments(count);
  std::vector<int> segments;
  for (int i = 0; i < kBriefSegments; ++i)
    segments.push_back((2 * i + 1) * count / (2 * kBriefSegments));
  return segments;
}

/// Hashes take a while: outputs are looked at in parallel.
void record_outputs(const GroupRun& group, const Indices& indices, int threads, Report& report) {
  parallel_for(threads, static_cast<int>(group.size()), [&](int, int item) {
    const auto i = static_cast<std::size_t>(item);
    const Member& member = group.member(i);
    report.runs[indices[i]].output = {
        member.output->hash(),
        counter_records(member.kernel->output_counters, member.output->counters())};
  });
}

void record(const GroupRun& group, const Indices& indices, const ExperimentOptions& options,
            Report& report, Dictionary& dictionary) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    report.runs[indices[i]] = group.record(i, dictionary);
    report.timing.kernel_ms[indices[i]] = group.kernel_ms(i);
  }
  report.timing.source_ms += group.source_ms();
  report.timing.observation_ms += group.observation_ms();
  record_outputs(group, indices, options.threads, report);
  if (!options.on_output) return;
  for (std::size_t i = 0; i < indices.size(); ++i)
    options.on_output({*group.member(i).configuration, *group.member(i).output});
}

std::vector<InstructionEntry> entries(const Dictionary& dictionary) {
  std::vector<InstructionEntry> all;
  for (const auto& [mnemonic, info] : dictionary)
    all.push_back({std::string(mnemonic), std::string(info->meaning),
                   std::string(to_string(info->instruction_class)),
                   std::string(to_string(info->charge))});
  return all;
}

}  // namespace

Report run_experiment(const std::vector<Configuration>& configurations,
                      const ExperimentOptions& options) {
  Stopwatch watch;
  Report report;
  report.program_version = program_version();
  report.commit = program_commit();
  report.runs.resize(configurations.size());
  report.timing.kernel_ms.resize(configurations.size());
  Dictionary dictionary;
  OutputPool own_outputs;
  OutputPool& outputs = options.outputs ? *options.outputs : own_outputs;
  const std::uint64_t bytes = output_bytes(configurations, options.group_limits);
  if (bytes > available_memory_bytes()) outputs.clear();
  require_memory(bytes);
  const std::vector<Indices> groups = group_by_source(configurations, options.group_limits);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    GroupRun group(selected(configurations, groups[i]), outputs, options.threads, options.opening);
    group.run(all_segments(group.segment_count()), [&](double fraction) {
      if (options.progress)
        options.progress((static_cast<double>(i) + fraction) / static_cast<double>(groups.size()));
    });
    record(group, groups[i], options, report, dictionary);
  }
  require_width_independence(report.runs);
  report.instructions = entries(dictionary);
  report.timing.wall_ms = watch.ms();
  report.timing.threads = options.threads;
  report.timing.host = processor_model();
  report.timing.compiler = compiler();
  report.timing.peak_memory_bytes = peak_memory_bytes();
  return report;
}

double estimated_thread_ms(const std::vector<Configuration>& configurations,
                           const GroupLimits& group_limits) {
  double sum_ms = 0.0;
  OutputPool outputs;
  for (const Indices& indices : group_by_source(configurations, group_limits)) {
    Stopwatch watch;
    GroupRun group(selected(configurations, indices), outputs, 1);
    sum_ms += watch.ms();
    const std::vector<int> segments = brief_segments(group.segment_count());
    if (segments.empty()) continue;
    group.run(segments, nullptr);
    sum_ms += watch.ms() * group.segment_count() / static_cast<double>(segments.size());
  }
  return sum_ms;
}

}  // namespace lanescope
