// SPDX-License-Identifier: MIT
#include "analysis/trace/trace.h"

#include <algorithm>
#include <memory>

#include "analysis/base/memory.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

/// Counts the batches of a kernel, and lets through what happens in those of the window.
class Gate final : public Observer {
 public:
  Gate(const TraceWindow& window, std::span<TraceSink* const> sinks)
      : window_(window), sinks_(sinks) {}

  /// What a kernel does with a piece of work before its first batch counts to that.
  void begin_piece() { open_ = window_.holds(batches_); }

  void batch_begins() override {
    const std::uint64_t batch = batches_++;
    open_ = window_.holds(batch);
    if (!open_) return;
    for (TraceSink* sink : sinks_) sink->batch(batch);
  }

  void issued(const IssueEvent& event) override {
    if (!open_) return;
    for (TraceSink* sink : sinks_) sink->issued(event);
  }

  /// Batches that have begun.
  std::uint64_t batches() const { return batches_; }

 private:
  const TraceWindow& window_;
  std::span<TraceSink* const> sinks_;
  std::uint64_t batches_ = 0;
  bool open_ = false;
};

/// A kernel that runs until the window has been passed. It takes all pieces before that: how many
/// batches they are, and what it keeps of them, only the kernel knows.
class WindowRun {
 public:
  WindowRun(const Configuration& configuration, const Kernel& kernel, const Source& source,
            const TraceWindow& window, std::span<TraceSink* const> sinks)
      : window_(window),
        output_(kernel.open(configuration.arguments, source)),
        gate_(window, sinks),
        execution_(kernel.start(
            {configuration.width, Mode::kTracing, configuration.arguments, *output_, &gate_})) {}

  bool finished() const { return gate_.batches() >= window_.end_batch; }
  std::uint64_t batches() const { return gate_.batches(); }

  void take(const Work& piece) {
    if (finished()) return;
    gate_.begin_piece();
    execution_->run(piece);
  }

 private:
  const TraceWindow& window_;
  std::unique_ptr<Output> output_;
  Gate gate_;
  std::unique_ptr<Execution> execution_;
};

const Kernel& traced_kernel(const Configuration& configuration) {
  const Kernel& kernel = find_kernel(configuration.kernel);
  if (kernel.stages.empty())
    throw InputError("--kernel", "{} issues no instructions that could be traced", kernel.name);
  return kernel;
}

/// Null if the whole scene is traced.
std::unique_ptr<RegionFilter> region_filter(const Configuration& configuration,
                                            const TraceWindow& window) {
  if (!window.region) return nullptr;
  const Workload& workload = workload_of(configuration);
  if (!workload.filter)
    throw InputError("--region", "{} have no regions; leave it out", workload.name);
  return workload.filter(*window.region, configuration.arguments);
}

void require_complete(const WindowRun& run, const Kernel& kernel, const TraceWindow& window) {
  if (window.region && run.batches() == 0)
    throw InputError("--region", "no {} meets it", kernel.element.name);
  if (window.end_batch != TraceWindow::kToTheEnd && !run.finished())
    throw InputError("--batches", "{}:{} reaches beyond the last batch; the {} has {} batches",
                     window.first_batch, window.end_batch, window.region ? "region" : "scene",
                     run.batches());
}

}  // namespace

void trace(const Configuration& configuration, const TraceWindow& window,
           std::span<TraceSink* const> sinks, const std::function<void(double)>& progress,
           const OpeningListener& opening) {
  const Kernel& kernel = traced_kernel(configuration);
  const std::unique_ptr<RegionFilter> filter = region_filter(configuration, window);
  const std::unique_ptr<Source> source = open_source(configuration, opening);
  require_memory(kernel.output_bytes(configuration.arguments));
  for (TraceSink* sink : sinks) sink->begin(configuration, kernel);

  WindowRun run(configuration, kernel, *source, window, sinks);
  const WorkSink take = [&](const Work& piece) {
    run.take(piece);
    if (window.end_batch != TraceWindow::kToTheEnd)
      progress(std::min(
          1.0, static_cast<double>(run.batches()) / static_cast<double>(window.end_batch)));
  };
  const WorkSink chosen =
      filter ? WorkSink([&](const Work& piece) { filter->take(piece, take); }) : take;
  for (int segment = 0; segment < source->segment_count() && !run.finished(); ++segment) {
    source->produce(segment, chosen);
    if (window.end_batch == TraceWindow::kToTheEnd)
      progress(static_cast<double>(segment + 1) / source->segment_count());
  }
  if (filter) filter->flush(take);
  require_complete(run, kernel, window);
  for (TraceSink* sink : sinks) sink->end();
}

}  // namespace lanescope
