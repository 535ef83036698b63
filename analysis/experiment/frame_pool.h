// SPDX-License-Identifier: MIT
// Frames that are used again and again.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "kernels/micropolygons/frame.h"

namespace lanescope {

/// Hands out empty frames in the memory of earlier ones: the operating system takes forty times as
/// long to provide a frame's memory as it takes to clear it.
class FramePool {
 public:
  /// An empty frame on the sample grid of a configuration.
  std::unique_ptr<Frame> take(const Configuration& configuration);
  void give_back(std::unique_ptr<Frame> frame) { free_.push_back(std::move(frame)); }

 private:
  std::optional<Configuration> sampled_as_;  ///< The configuration that `blank_` is for.
  std::unique_ptr<Frame> blank_;
  std::vector<std::unique_ptr<Frame>> free_;
};

}  // namespace lanescope
