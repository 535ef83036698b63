// SPDX-License-Identifier: MIT
#include "analysis/experiment/sample_maps.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <tuple>

#include "analysis/base/parallel.h"
#include "analysis/experiment/scene_source.h"
#include "analysis/pictures/palette.h"
#include "workloads/micropolygons/tessellator.h"

namespace lanescope {

KernelResult watch_samples(const Configuration& configuration, SampleObserver& observer,
                           int threads, const std::function<void(double)>& progress) {
  const Scene scene = build_scene(configuration);
  const Tessellator tessellator(scene, configuration.tessellation_options());
  const int segments = tessellator.segment_count();
  Frame frame(configuration.sample_grid());
  std::vector<std::unique_ptr<Execution>> executions;
  for (int i = 0; i < threads; ++i)
    executions.push_back(start_observed_rastmp(configuration.options, frame, observer));
  parallel_for(
      threads, segments,
      [&](int worker, int segment) {
        Execution& execution = *executions[static_cast<std::size_t>(worker)];
        tessellator.tessellate(segment, [&](const Packet& packet) { execution.rasterize(packet); });
      },
      [&](int done) { progress(static_cast<double>(done) / segments); });
  KernelResult sum = executions.front()->result();
  for (std::size_t i = 1; i < executions.size(); ++i)
    merge(find_kernel("rastmp"), sum, executions[i]->result());
  return sum;
}

void SampleCounter::increment(std::uint32_t sample) {
  std::atomic_ref<std::uint32_t>(counts_[sample]).fetch_add(1, std::memory_order_relaxed);
}

void VisibleMicropolygons::hit(std::uint64_t micropolygon_id, std::uint32_t sample, float depth,
                               std::uint32_t colour) {
  if (!(depth >= 0.0f)) return;  // The frame drops these, too.
  const std::lock_guard lock(locks_[sample % kLocks]);
  Fragment& nearest = fragments_[sample];
  const auto order = [](const Fragment& f) { return std::tuple(f.depth, f.colour, f.id); };
  const Fragment fragment{depth, colour, micropolygon_id};
  if (order(fragment) < order(nearest)) nearest = fragment;
}

std::vector<std::uint64_t> pixel_sums(const SampleGrid& grid,
                                      const std::vector<std::uint32_t>& counts) {
  const auto width = static_cast<std::size_t>(grid.width_px());
  const auto axis = static_cast<std::size_t>(grid.samples_per_axis());
  const auto columns = static_cast<std::size_t>(grid.width_cells());
  std::vector<std::uint64_t> sums(width * static_cast<std::size_t>(grid.height_px()));
  for (std::size_t sample = 0; sample < counts.size(); ++sample)
    sums[sample / columns / axis * width + sample % columns / axis] += counts[sample];
  return sums;
}

Image micropolygon_picture(const SampleGrid& grid, const VisibleMicropolygons& visible) {
  Image image{grid.width_cells(), grid.height_cells(), {}};
  for (std::size_t sample = 0; sample < static_cast<std::size_t>(grid.sample_count()); ++sample) {
    const std::uint64_t id = visible.id(sample);
    image.pixels.push_back(id == VisibleMicropolygons::kNone ? kNothing : identity_colour(id));
  }
  return image;
}

}  // namespace lanescope
