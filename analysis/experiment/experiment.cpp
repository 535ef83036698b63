// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string_view>

#include "analysis/base/build_info.h"
#include "analysis/base/parallel.h"
#include "analysis/experiment/frame_pool.h"
#include "analysis/experiment/observation.h"
#include "analysis/experiment/packet_hash.h"
#include "analysis/experiment/scene_source.h"
#include "simulator/base/error.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope {
namespace {

using Clock = std::chrono::steady_clock;
using Indices = std::vector<std::size_t>;
using Dictionary = std::map<std::string_view, const InstructionInfo*>;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One configuration while its group runs.
struct Member {
  const Configuration* configuration;
  const Kernel* kernel;
  std::unique_ptr<Frame> frame;
};

/// A member as a tracing machine sees it, in those packets that are observed. They are rasterized
/// once more, which changes nothing in the frame.
class Observed {
 public:
  explicit Observed(const Member& member) : configuration_(*member.configuration) {
    if (configuration_.observe_every == 0 || configuration_.mode == Mode::kUncounted ||
        member.kernel->stages.empty())
      return;
    seen_ = std::make_unique<MemoryAndSource>();
    execution_ = member.kernel->start(
        {configuration_.width, Mode::kTracing, configuration_.options, *member.frame, seen_.get()});
  }

  void take(const Packet& packet) {
    ++sums_.packets;
    if (!execution_ || !is_observed(packet, configuration_.observe_every,
                                    configuration_.tessellation.packet_capacity))
      return;
    ++sums_.packets_observed;
    execution_->rasterize(packet);
  }

  const Observation& sums() const { return sums_; }
  /// Null if nothing is observed.
  const MemoryAndSource* seen() const { return seen_.get(); }

 private:
  const Configuration& configuration_;
  std::unique_ptr<MemoryAndSource> seen_;
  std::unique_ptr<Execution> execution_;
  Observation sums_;
};

/// Times of one worker, or of all together.
struct WorkTimes {
  double dicing_ms = 0.0;
  double observation_ms = 0.0;
};

/// What one worker has of a group: an execution of each member, and its share of the sums.
class Worker {
 public:
  explicit Worker(const std::vector<Member>& members) : kernel_ms_(members.size(), 0.0) {
    for (const Member& m : members) {
      executions_.push_back(m.kernel->start(
          {m.configuration->width, m.configuration->mode, m.configuration->options, *m.frame}));
      observed_.emplace_back(m);
    }
  }

  void run(const Tessellator& tessellator, int segment) {
    const Clock::time_point start = Clock::now();
    double elsewhere_ms = 0.0;
    tessellation_ += tessellator.tessellate(segment, [&](const Packet& packet) {
      const Clock::time_point begin = Clock::now();
      take(packet);
      elsewhere_ms += ms_since(begin);
    });
    times_.dicing_ms += ms_since(start) - elsewhere_ms;
  }

  KernelResult result(std::size_t member) const { return executions_[member]->result(); }
  double kernel_ms(std::size_t member) const { return kernel_ms_[member]; }
  const Observed& observed(std::size_t member) const { return observed_[member]; }
  const WorkTimes& times() const { return times_; }
  std::uint64_t scene_hash() const { return scene_hash_; }
  const TessellationCounts& tessellation() const { return tessellation_; }

 private:
  void take(const Packet& packet) {
    scene_hash_ += packet_hash(packet);
    for (std::size_t i = 0; i < executions_.size(); ++i) {
      const Clock::time_point start = Clock::now();
      executions_[i]->rasterize(packet);
      const Clock::time_point counted = Clock::now();
      observed_[i].take(packet);
      kernel_ms_[i] += std::chrono::duration<double, std::milli>(counted - start).count();
      times_.observation_ms += ms_since(counted);
    }
  }

  std::vector<std::unique_ptr<Execution>> executions_;
  std::vector<Observed> observed_;
  std::vector<double> kernel_ms_;
  WorkTimes times_;
  std::uint64_t scene_hash_ = 0;
  TessellationCounts tessellation_;
};

std::vector<StageRecord> stage_records(const Kernel& kernel, const Counts& counts) {
  std::vector<StageRecord> records;
  for (std::size_t i = 0; i < counts.stages.size(); ++i) {
    const StageCounts& stage = counts.stages[i];
    StageRecord record{std::string(kernel.stages[i]), {}, stage.lane_active, stage.histogram, {}};
    for (const InstructionCounts& c : stage.instructions)
      record.instructions.push_back({std::string(c.info->mnemonic), c.issued, c.active,
                                     c.overhead_issued, c.overhead_active});
    records.push_back(std::move(record));
  }
  return records;
}

void add_figures(RunRecord& run, const Kernel& kernel, const KernelResult& result) {
  LANESCOPE_CHECK(result.counters.size() == kernel.counters.size(), "{} counters of {}: {}",
                  kernel.counters.size(), kernel.name, result.counters.size());
  for (std::size_t i = 0; i < kernel.counters.size(); ++i) {
    const CounterInfo& info = kernel.counters[i];
    run.counters.push_back({std::string(info.name), std::string(info.meaning),
                            std::string(info.unit), result.counters[i]});
  }
  for (const MetricInfo& info : kernel.metrics)
    run.metrics.push_back({std::string(info.name), std::string(info.meaning),
                           std::string(info.numerator), std::string(info.denominator)});
  for (std::size_t i = 0; i < kernel.series.size(); ++i) {
    const SeriesInfo& info = kernel.series[i];
    run.series.push_back({std::string(info.name), std::string(info.meaning),
                          std::string(info.index), std::string(info.unit), result.series[i]});
  }
}

/// Runs the configurations of one group and fills in their runs of the report.
class GroupRun {
 public:
  GroupRun(const std::vector<Configuration>& configurations, const Indices& indices,
           const ExperimentOptions& options, FramePool& frames)
      : indices_(indices),
        options_(options),
        frames_(frames),
        scene_(build_scene(configurations[indices.front()])),
        tessellator_(scene_, configurations[indices.front()].tessellation_options()) {
    for (const std::size_t index : indices) {
      const Configuration& c = configurations[index];
      members_.push_back({&c, &find_kernel(c.kernel), frames.take(c)});
    }
  }

  GroupRun(const GroupRun&) = delete;
  GroupRun& operator=(const GroupRun&) = delete;
  ~GroupRun() {
    for (Member& member : members_) frames_.give_back(std::move(member.frame));
  }

  void run(Report& report, Dictionary& dictionary, const std::function<void(double)>& progress) {
    const int segments = tessellator_.segment_count();
    const int workers = std::max(1, std::min(options_.threads, segments));
    for (int i = 0; i < workers; ++i) workers_.emplace_back(members_);
    parallel_for(
        workers, segments,
        [&](int worker, int segment) {
          workers_[static_cast<std::size_t>(worker)].run(tessellator_, segment);
        },
        [&](int done) { progress(static_cast<double>(done) / segments); });
    for (std::size_t i = 0; i < members_.size(); ++i)
      record(i, report.runs[indices_[i]], report.timing.kernel_ms[indices_[i]], dictionary);
    for (const Worker& worker : workers_) {
      report.timing.dicing_ms += worker.times().dicing_ms;
      report.timing.observation_ms += worker.times().observation_ms;
    }
    record_frames(report);
  }

 private:
  void record(std::size_t i, RunRecord& run, double& kernel_ms, Dictionary& dictionary) const {
    const Member& member = members_[i];
    KernelResult sum = workers_.front().result(i);
    kernel_ms = workers_.front().kernel_ms(i);
    for (std::size_t w = 1; w < workers_.size(); ++w) {
      merge(*member.kernel, sum, workers_[w].result(i));
      kernel_ms += workers_[w].kernel_ms(i);
    }
    run.configuration = *member.configuration;
    run.thesis_like = is_thesis_like(run.configuration);
    for (const Worker& worker : workers_) {
      run.scene_hash += worker.scene_hash();
      run.tessellation += worker.tessellation();
    }
    if (run.configuration.mode != Mode::kUncounted)
      run.stages = stage_records(*member.kernel, sum.counts);
    add_observation(run, i);
    add_figures(run, *member.kernel, sum);
    run.hits_hash = sum.hits_hash;
    for (const StageCounts& stage : sum.counts.stages)
      for (const InstructionCounts& c : stage.instructions)
        dictionary.emplace(c.info->mnemonic, c.info);
  }

  void add_observation(RunRecord& run, std::size_t member) const {
    MemoryAndSource seen;
    for (const Worker& worker : workers_) {
      const Observed& observed = worker.observed(member);
      run.observation.packets += observed.sums().packets;
      run.observation.packets_observed += observed.sums().packets_observed;
      if (observed.seen()) seen += *observed.seen();
    }
    for (std::size_t stage = 0; stage < run.stages.size(); ++stage)
      run.stages[stage].memory = seen.memory(stage);
    run.source_lines = seen.source_lines(members_[member].kernel->stages);
  }

  void record_frames(Report& report) const {
    parallel_for(options_.threads, static_cast<int>(members_.size()), [&](int, int item) {
      const auto i = static_cast<std::size_t>(item);
      RunRecord& run = report.runs[indices_[i]];
      run.frame_hash = members_[i].frame->hash();
      run.samples_covered = members_[i].frame->covered();
    });
    if (!options_.on_frame) return;
    const Vec3 background = scene_.lighting.background;
    for (const Member& member : members_)
      options_.on_frame({*member.configuration, *member.frame,
                         to_colour(background.x, background.y, background.z)});
  }

  const Indices& indices_;
  const ExperimentOptions& options_;
  FramePool& frames_;
  Scene scene_;
  Tessellator tessellator_;
  std::vector<Member> members_;
  std::vector<Worker> workers_;
};

}  // namespace

Report run_experiment(const std::vector<Configuration>& configurations,
                      const ExperimentOptions& options) {
  const Clock::time_point start = Clock::now();
  Report report;
  report.program_version = program_version();
  report.commit = program_commit();
  report.runs.resize(configurations.size());
  report.timing.kernel_ms.resize(configurations.size());
  Dictionary dictionary;
  FramePool own_frames;
  FramePool& frames = options.frames ? *options.frames : own_frames;
  const std::vector<Indices> groups = group_by_tessellation(configurations, options.group_limits);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    GroupRun run(configurations, groups[i], options, frames);
    run.run(report, dictionary, [&](double fraction) {
      if (options.progress)
        options.progress((static_cast<double>(i) + fraction) / static_cast<double>(groups.size()));
    });
  }
  for (const auto& [mnemonic, info] : dictionary)
    report.instructions.push_back({std::string(mnemonic), std::string(info->meaning),
                                   std::string(to_string(info->instruction_class)),
                                   std::string(to_string(info->charge))});
  report.timing.wall_ms = ms_since(start);
  report.timing.threads = options.threads;
  report.timing.host = processor_model();
  report.timing.compiler = compiler();
  report.timing.peak_memory_bytes = peak_memory_bytes();
  return report;
}

}  // namespace lanescope
