// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/sample_views.h"

#include <atomic>
#include <tuple>

#include "kernels/micropolygons/frame.h"
#include "kernels/micropolygons/options.h"
#include "simulator/base/random.h"

namespace lanescope {
namespace {

/// A sample that nothing covers.
constexpr Colour kNothing{24, 24, 27};

/// A colour that tells a micropolygon from its neighbours; none is as dark as kNothing.
Colour identity_colour(std::uint64_t id) {
  const std::uint64_t hash = mix64(id);
  const auto channel = [&](int place) {
    return static_cast<std::uint8_t>(70 + (hash >> (8 * place) & 0xff) * 185 / 255);
  };
  return {channel(0), channel(1), channel(2)};
}

template <SampleCounter::What kWhat>
std::unique_ptr<Output> open_counter(const Arguments& arguments, const Source&) {
  return std::make_unique<SampleCounter>(sample_grid(arguments), kWhat);
}

std::unique_ptr<Output> open_visible(const Arguments& arguments, const Source&) {
  return std::make_unique<VisibleMicropolygons>(sample_grid(arguments));
}

std::uint64_t counter_bytes(const Arguments& arguments) {
  return frame_samples(arguments) * SampleCounter::kSampleBytes;
}

std::uint64_t visible_bytes(const Arguments& arguments) {
  return frame_samples(arguments) * VisibleMicropolygons::kSampleBytes;
}

std::unique_ptr<Execution> start_watched(const Launch& launch) {
  return start_observed_rastmp(launch.arguments, static_cast<SampleView&>(launch.output));
}

}  // namespace

void SampleCounter::increment(std::uint32_t sample) {
  std::atomic_ref<std::uint32_t>(counts_[sample]).fetch_add(1, std::memory_order_relaxed);
}

std::uint64_t SampleCounter::hash() const {
  std::uint64_t hash = 0;
  for (const std::uint32_t count : counts_) hash = mix64(hash ^ count);
  return hash;
}

std::optional<Raster> SampleCounter::picture() const {
  const bool tests = what_ == What::kTests;
  Raster raster;
  raster.width_px = grid().width_px();
  raster.height_px = grid().height_px();
  raster.counts = pixel_sums(grid(), counts_);
  raster.count_unit = tests ? 1 : static_cast<std::uint64_t>(grid().samples_per_pixel());
  raster.counted = tests ? "tests per pixel" : "hits per sample";
  return raster;
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

std::uint64_t VisibleMicropolygons::hash() const {
  std::uint64_t hash = 0;
  for (const Fragment& fragment : fragments_) hash = mix64(hash ^ fragment.id);
  return hash;
}

std::optional<Raster> VisibleMicropolygons::picture() const {
  Raster raster;
  raster.width_px = grid().width_cells();
  raster.height_px = grid().height_cells();
  for (const Fragment& fragment : fragments_)
    raster.pixels.push_back(fragment.id == kNone ? kNothing : identity_colour(fragment.id));
  return raster;
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

const std::array<View, 3> kSampleViews{{
    {"tests", "tests of each pixel, as a heat map", open_counter<SampleCounter::What::kTests>,
     counter_bytes, start_watched},
    {"hits", "hits for each sample of a pixel, as a heat map",
     open_counter<SampleCounter::What::kHits>, counter_bytes, start_watched},
    {"micropolygons", "the visible micropolygons, a pixel for each sample", open_visible,
     visible_bytes, start_watched},
}};

}  // namespace lanescope
