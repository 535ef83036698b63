// SPDX-License-Identifier: MIT
#include "analysis/trace/trace.h"

#include <algorithm>
#include <memory>

#include "analysis/experiment/scene_source.h"
#include "simulator/base/error.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope {
namespace {

/// Lets through what happens in the batches of the window.
class Gate final : public Observer {
 public:
  Gate(const TraceWindow& window, std::span<TraceSink* const> sinks)
      : window_(window), sinks_(sinks) {}

  /// The next packet's first batch is `batch`. What precedes it in the packet counts to it: turning
  /// around of micropolygons that face away.
  void begin_packet(std::uint64_t batch) {
    next_ = batch;
    open_ = window_.holds(batch);
  }

  void batch_begins() override {
    const std::uint64_t batch = next_++;
    open_ = window_.holds(batch);
    if (!open_) return;
    for (TraceSink* sink : sinks_) sink->batch(batch);
  }

  void issued(const IssueEvent& event) override {
    if (!open_) return;
    for (TraceSink* sink : sinks_) sink->issued(event);
  }

 private:
  const TraceWindow& window_;
  std::span<TraceSink* const> sinks_;
  std::uint64_t next_ = 0;
  bool open_ = false;
};

/// Runs a kernel on those packets that reach into the window.
class WindowRun {
 public:
  WindowRun(const Configuration& configuration, const Kernel& kernel, const TraceWindow& window,
            std::span<TraceSink* const> sinks)
      : width_(static_cast<std::uint64_t>(configuration.width)),
        window_(window),
        frame_(configuration.sample_grid()),
        gate_(window, sinks),
        execution_(kernel.start(
            {configuration.width, Mode::kTracing, configuration.options, frame_, &gate_})) {}

  bool finished() const { return batches_ >= window_.end_batch; }
  /// Batches passed so far.
  std::uint64_t batches() const { return batches_; }

  void take(const Packet& packet) {
    if (finished()) return;
    const std::uint64_t first = batches_;
    batches_ += (static_cast<std::uint64_t>(packet.size()) + width_ - 1) / width_;
    if (batches_ <= window_.first_batch) return;
    gate_.begin_packet(first);
    execution_->rasterize(packet);
  }

 private:
  std::uint64_t width_;
  const TraceWindow& window_;
  Frame frame_;
  Gate gate_;
  std::unique_ptr<Execution> execution_;
  std::uint64_t batches_ = 0;
};

const Kernel& traced_kernel(const Configuration& configuration) {
  const Kernel& kernel = find_kernel(configuration.kernel);
  if (kernel.stages.empty())
    throw InputError("--kernel", "{} issues no instructions that could be traced", kernel.name);
  return kernel;
}

void require_inside(const Region& region, const TessellationOptions& options) {
  if (region.x_px + region.width_px > options.width_px ||
      region.y_px + region.height_px > options.height_px)
    throw InputError("--region", "{},{},{}x{} is not inside the frame, which is {}x{}", region.x_px,
                     region.y_px, region.width_px, region.height_px, options.width_px,
                     options.height_px);
}

void require_complete(const WindowRun& run, const TraceWindow& window) {
  if (window.region && run.batches() == 0) throw InputError("--region", "no micropolygon meets it");
  if (window.end_batch != TraceWindow::kToTheEnd && !run.finished())
    throw InputError("--batches", "{}:{} reaches beyond the last batch; the {} has {} batches",
                     window.first_batch, window.end_batch, window.region ? "region" : "scene",
                     run.batches());
}

}  // namespace

void trace(const Configuration& configuration, const TraceWindow& window,
           std::span<TraceSink* const> sinks, const std::function<void(double)>& progress) {
  const Kernel& kernel = traced_kernel(configuration);
  if (window.region) require_inside(*window.region, configuration.tessellation);
  const Scene scene = build_scene(configuration);
  const TessellationOptions options = configuration.tessellation_options();
  const Tessellator tessellator(scene, options);
  for (TraceSink* sink : sinks) sink->begin(configuration, kernel);

  WindowRun run(configuration, kernel, window, sinks);
  const auto take = [&](const Packet& packet) {
    run.take(packet);
    if (window.end_batch != TraceWindow::kToTheEnd)
      progress(std::min(
          1.0, static_cast<double>(run.batches()) / static_cast<double>(window.end_batch)));
  };
  std::optional<RegionFilter> filter;
  if (window.region) filter.emplace(*window.region, options.samples_per_axis, take);
  for (int segment = 0; segment < tessellator.segment_count() && !run.finished(); ++segment) {
    tessellator.tessellate(
        segment, [&](const Packet& packet) { filter ? filter->take(packet) : take(packet); });
    if (window.end_batch == TraceWindow::kToTheEnd)
      progress(static_cast<double>(segment + 1) / tessellator.segment_count());
  }
  if (filter) filter->flush();
  require_complete(run, window);
  for (TraceSink* sink : sinks) sink->end();
}

}  // namespace lanescope
