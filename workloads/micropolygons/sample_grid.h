// SPDX-License-Identifier: MIT
// Where the samples are: one in each sub-pixel cell, at its centre or jittered.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lanescope {

/// Cells along each side of a pixel: the square root. Throws InputError for counts that are not
/// among SampleGrid::kSampleCounts.
int samples_per_axis(int samples_per_pixel);

/// A pixel is divided into samples_per_axis x samples_per_axis square cells, each with one sample
/// (Cook's jittered sampling; the thesis, 2.3). Positions are in cells: cell (x, y) covers
/// [x, x + 1) x [y, y + 1), and its sample's index is y * width_cells() + x.
class SampleGrid {
 public:
  static constexpr std::array<int, 5> kSampleCounts{1, 4, 9, 16, 64};
  static constexpr int kMaxCells = 16384;  ///< Along either side of the frame.

  /// Number of jitter offsets; sample i uses offset i % kJitterPeriod.
  static constexpr int kJitterPeriod = 4096;

  /// `samples_per_pixel` is among kSampleCounts. With `jitter` off, samples lie at cell centres.
  /// Offsets are multiples of kSubpixel in [0, 1), decided by `seed`.
  /// Throws InputError for other sample counts and for frames that frame_size_problem complains of.
  SampleGrid(int width_px, int height_px, int samples_per_pixel, bool jitter, std::uint64_t seed);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  int samples_per_axis() const { return samples_per_axis_; }
  int samples_per_pixel() const { return samples_per_axis_ * samples_per_axis_; }
  int width_cells() const { return width_px_ * samples_per_axis_; }
  int height_cells() const { return height_px_ * samples_per_axis_; }
  std::int64_t sample_count() const { return std::int64_t{width_cells()} * height_cells(); }

  /// [kJitterPeriod][2] offsets (x, y) of the sample from the corner of its cell, in cells.
  const std::vector<float>& jitter() const { return jitter_; }

 private:
  int width_px_;
  int height_px_;
  int samples_per_axis_;
  std::vector<float> jitter_;
};

/// What is wrong with a frame that is empty or larger than kMaxCells x kMaxCells cells, or nothing.
std::string frame_size_problem(int width_px, int height_px, int samples_per_pixel);

}  // namespace lanescope
