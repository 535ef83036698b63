// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/sample_grid.h"

#include "simulator/base/error.h"
#include "simulator/base/random.h"
#include "workloads/micropolygons/micropolygon.h"

namespace lanescope {
int samples_per_axis(int samples_per_pixel) {
  for (int axis = 1; axis * axis <= samples_per_pixel; ++axis)
    for (const int count : SampleGrid::kSampleCounts)
      if (axis * axis == count && count == samples_per_pixel) return axis;
  throw InputError("--msaa", "{} is not a sample count; use 1, 4, 9, 16 or 64", samples_per_pixel);
}

std::string frame_size_problem(int width_px, int height_px, int samples_per_pixel) {
  const int limit_px = SampleGrid::kMaxCells / samples_per_axis(samples_per_pixel);
  if (width_px < 1 || height_px < 1 || width_px > limit_px || height_px > limit_px)
    return fmt::format("{}x{} is outside 1x1 to {}x{} at {} samples a pixel", width_px, height_px,
                       limit_px, limit_px, samples_per_pixel);
  return {};
}

SampleGrid::SampleGrid(int width_px, int height_px, int samples_per_pixel, bool jitter,
                       std::uint64_t seed)
    : width_px_(width_px),
      height_px_(height_px),
      samples_per_axis_(lanescope::samples_per_axis(samples_per_pixel)) {
  if (const auto problem = frame_size_problem(width_px, height_px, samples_per_pixel);
      !problem.empty())
    throw InputError("--resolution", "{}", problem);
  jitter_.reserve(2 * kJitterPeriod);
  for (std::uint64_t i = 0; i < kJitterPeriod; ++i) {
    const std::uint64_t hash = mix64(mix64(seed) + i);
    jitter_.push_back(static_cast<float>(jitter ? hash & 255 : 128) * kSubpixel);
    jitter_.push_back(static_cast<float>(jitter ? hash >> 8 & 255 : 128) * kSubpixel);
  }
}

}  // namespace lanescope
