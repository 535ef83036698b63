// SPDX-License-Identifier: MIT
// What happens at each sample of a frame: tests, hits, and the micropolygon that is seen there. The
// scalar reference is watched; tests and hits of the other kernels are the same.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/pictures/image.h"
#include "kernels/micropolygons/rastmp.h"

namespace lanescope {

/// Runs the reference on a whole scene, whatever the configuration's kernel, and shows its tests
/// and hits to an observer that is safe for several threads. Returns its counters. `progress` is
/// called with the finished share of the work on the caller's thread. Throws InputError for what
/// the configuration names and does not exist. Requires threads > 0.
KernelResult watch_samples(const Configuration& configuration, SampleObserver& observer,
                           int threads, const std::function<void(double)>& progress);

/// Counts tests or hits of each sample. Safe for any number of threads, and then the same.
class SampleCounter final : public SampleObserver {
 public:
  enum class What { kTests, kHits };

  SampleCounter(const SampleGrid& grid, What what)
      : what_(what), counts_(static_cast<std::size_t>(grid.sample_count())) {}

  void tested(std::uint32_t sample) override {
    if (what_ == What::kTests) increment(sample);
  }
  void hit(std::uint64_t, std::uint32_t sample, float, std::uint32_t) override {
    if (what_ == What::kHits) increment(sample);
  }

  /// By index of the sample.
  const std::vector<std::uint32_t>& counts() const { return counts_; }

 private:
  void increment(std::uint32_t sample);

  What what_;
  std::vector<std::uint32_t> counts_;
};

/// Finds the micropolygon whose fragment the frame shows at each sample: the nearest; of equally
/// near ones that of the smaller colour word, as in the frame, then that of the smaller id. Safe
/// for any number of threads, and then the same.
class VisibleMicropolygons final : public SampleObserver {
 public:
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

  explicit VisibleMicropolygons(const SampleGrid& grid)
      : fragments_(static_cast<std::size_t>(grid.sample_count())) {}

  void hit(std::uint64_t micropolygon_id, std::uint32_t sample, float depth,
           std::uint32_t colour) override;

  /// The id at a sample, or kNone.
  std::uint64_t id(std::size_t sample) const { return fragments_[sample].id; }

 private:
  struct Fragment {
    float depth = std::numeric_limits<float>::infinity();
    std::uint32_t colour = 0xffffffff;
    std::uint64_t id = kNone;
  };
  static constexpr std::size_t kLocks = 1024;

  std::vector<Fragment> fragments_;
  std::array<std::mutex, kLocks> locks_;  ///< Each for every kLocks-th sample.
};

/// Sums over the samples of each pixel, by rows from the top.
std::vector<std::uint64_t> pixel_sums(const SampleGrid& grid,
                                      const std::vector<std::uint32_t>& counts);

/// A pixel for each sample, in a colour of its micropolygon.
Image micropolygon_picture(const SampleGrid& grid, const VisibleMicropolygons& visible);

}  // namespace lanescope
