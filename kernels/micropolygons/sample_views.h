// SPDX-License-Identifier: MIT
// What happens at each sample of a frame: tests, hits, and the micropolygon that is seen there. The
// scalar reference is watched; tests and hits of the other kernels are the same.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

#include "kernels/kernel.h"
#include "kernels/micropolygons/rastmp.h"
#include "workloads/micropolygons/sample_grid.h"

namespace lanescope {

/// An output that is drawn by watching the reference.
class SampleView : public Output, public SampleObserver {
 public:
  explicit SampleView(SampleGrid grid) : grid_(std::move(grid)) {}
  const SampleGrid& grid() const { return grid_; }

 private:
  SampleGrid grid_;
};

/// Counts tests or hits of each sample. Safe for any number of threads, and then the same.
class SampleCounter final : public SampleView {
 public:
  enum class What { kTests, kHits };
  static constexpr std::uint64_t kSampleBytes = sizeof(std::uint32_t);

  SampleCounter(const SampleGrid& grid, What what)
      : SampleView(grid), what_(what), counts_(static_cast<std::size_t>(grid.sample_count())) {}

  void tested(std::uint32_t sample) override {
    if (what_ == What::kTests) increment(sample);
  }
  void hit(std::uint64_t, std::uint32_t sample, float, std::uint32_t) override {
    if (what_ == What::kHits) increment(sample);
  }

  /// By index of the sample.
  const std::vector<std::uint32_t>& counts() const { return counts_; }

  std::uint64_t hash() const override;
  /// Tests of each pixel, or hits for each of its samples.
  std::optional<Raster> picture() const override;

 private:
  void increment(std::uint32_t sample);

  What what_;
  std::vector<std::uint32_t> counts_;
};

/// Finds the micropolygon whose fragment the frame shows at each sample: the nearest; of equally
/// near ones that of the smaller colour word, as in the frame, then that of the smaller id. Safe
/// for any number of threads, and then the same.
class VisibleMicropolygons final : public SampleView {
 public:
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

  static const std::uint64_t kSampleBytes;

  explicit VisibleMicropolygons(const SampleGrid& grid)
      : SampleView(grid), fragments_(static_cast<std::size_t>(grid.sample_count())) {}

  void hit(std::uint64_t micropolygon_id, std::uint32_t sample, float depth,
           std::uint32_t colour) override;

  /// The id at a sample, or kNone.
  std::uint64_t id(std::size_t sample) const { return fragments_[sample].id; }

  std::uint64_t hash() const override;
  /// A pixel for each sample, in a colour of its micropolygon.
  std::optional<Raster> picture() const override;

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

inline constexpr std::uint64_t VisibleMicropolygons::kSampleBytes = sizeof(Fragment);

/// Sums over the samples of each pixel, by rows from the top.
std::vector<std::uint64_t> pixel_sums(const SampleGrid& grid,
                                      const std::vector<std::uint32_t>& counts);

/// The views of the rasterizers: tests, hits, micropolygons.
extern const std::array<View, 3> kSampleViews;

}  // namespace lanescope
