// SPDX-License-Identifier: MIT
// The lanes of a kernel over time, in bounded memory: columns of 2^k instructions, which merge in
// pairs when there are too many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/trace/trace.h"

namespace lanescope {

/// Sums over instructions.
struct LaneSums {
  std::uint64_t issued = 0;
  std::uint64_t charged = 0;  ///< Lanes, as tables count them.
};

/// One kernel's trace. At scale 0 every column is one instruction.
class LaneStrip {
 public:
  static constexpr std::size_t kMaxColumns = 2048;

  LaneStrip(const Configuration& configuration, const Kernel& kernel,
            std::size_t max_columns = kMaxColumns);

  void batch(std::uint64_t number);
  void issued(const IssueEvent& event);
  /// Merges columns until the scale is `scale`. Requires that it is not finer than it is.
  void coarsen(int scale);

  const Configuration& configuration() const { return configuration_; }
  const Kernel& kernel() const { return *kernel_; }
  int width() const { return configuration_.width; }
  int scale() const { return scale_; }
  std::size_t columns() const { return counts_.size() / column_size(); }
  /// Instructions of a stage in a column.
  std::uint32_t issued(std::size_t column, std::size_t stage) const {
    return counts_[place(column, stage)];
  }
  /// Those of them that ran with the lane on.
  std::uint32_t active(std::size_t column, std::size_t stage, int lane) const {
    return counts_[place(column, stage) + 1 + static_cast<std::size_t>(lane)];
  }
  /// Of each stage, over the whole trace.
  const std::vector<LaneSums>& stages() const { return sums_; }
  LaneSums total() const;
  /// The instruction with which each batch begins, and the number of the first batch.
  const std::vector<std::uint64_t>& batch_starts() const { return batch_starts_; }
  std::uint64_t first_batch() const { return first_batch_; }

 private:
  std::size_t stage_size() const { return 1 + static_cast<std::size_t>(width()); }
  std::size_t column_size() const { return sums_.size() * stage_size(); }
  std::size_t place(std::size_t column, std::size_t stage) const {
    return column * column_size() + stage * stage_size();
  }
  void merge_pairs();

  Configuration configuration_;
  const Kernel* kernel_;
  std::size_t max_columns_;
  int scale_ = 0;
  std::uint64_t issued_ = 0;
  std::vector<std::uint32_t> counts_;  ///< [columns][stages][1 + W]: issued, then by lane.
  std::vector<LaneSums> sums_;
  std::vector<std::uint64_t> batch_starts_;
  std::uint64_t first_batch_ = 0;
};

/// Keeps a strip of each kernel.
class LaneStrips final : public TraceSink {
 public:
  void begin(const Configuration& configuration, const Kernel& kernel) override {
    strips_.emplace_back(configuration, kernel);
  }
  void batch(std::uint64_t number) override { strips_.back().batch(number); }
  void issued(const IssueEvent& event) override { strips_.back().issued(event); }
  void end() override {}

  /// The strips, all at the coarsest one's scale.
  const std::vector<LaneStrip>& at_one_scale();

 private:
  std::vector<LaneStrip> strips_;
};

}  // namespace lanescope
