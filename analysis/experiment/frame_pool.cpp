// SPDX-License-Identifier: MIT
#include "analysis/experiment/frame_pool.h"

#include <tuple>
#include <utility>

namespace lanescope {
namespace {

bool same_sampling(const Configuration& a, const Configuration& b) {
  const auto key = [](const Configuration& c) {
    return std::tie(c.tessellation.width_px, c.tessellation.height_px, c.samples_per_pixel,
                    c.jitter, c.seed);
  };
  return key(a) == key(b);
}

}  // namespace

std::unique_ptr<Frame> FramePool::take(const Configuration& configuration) {
  if (!sampled_as_ || !same_sampling(*sampled_as_, configuration)) {
    free_.clear();
    blank_ = std::make_unique<Frame>(configuration.sample_grid());
    sampled_as_ = configuration;
  }
  if (free_.empty()) return std::make_unique<Frame>(*blank_);
  std::unique_ptr<Frame> frame = std::move(free_.back());
  free_.pop_back();
  *frame = *blank_;
  return frame;
}

}  // namespace lanescope
