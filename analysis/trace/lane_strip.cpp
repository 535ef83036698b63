// SPDX-License-Identifier: MIT
#include "analysis/trace/lane_strip.h"

#include <algorithm>

#include "simulator/base/error.h"

namespace lanescope {

LaneStrip::LaneStrip(const Configuration& configuration, const Kernel& kernel,
                     std::size_t max_columns)
    : configuration_(configuration),
      kernel_(&kernel),
      max_columns_(max_columns),
      sums_(kernel.stages.size()) {
  LANESCOPE_CHECK(max_columns >= 2 && max_columns % 2 == 0, "{} columns", max_columns);
}

void LaneStrip::batch(std::uint64_t number) {
  if (batch_starts_.empty()) first_batch_ = number;
  batch_starts_.push_back(issued_);
}

void LaneStrip::issued(const IssueEvent& event) {
  if (issued_ >> scale_ == max_columns_) merge_pairs();
  const auto column = static_cast<std::size_t>(issued_ >> scale_);
  if (column == columns()) counts_.resize(counts_.size() + column_size());
  std::uint32_t* counts = &counts_[place(column, event.stage)];
  *counts++ += 1;
  for (int lane = 0; lane < width(); ++lane) counts[lane] += event.active >> lane & 1;
  sums_[event.stage].issued += 1;
  sums_[event.stage].charged += event.charged();
  ++issued_;
}

void LaneStrip::merge_pairs() {
  const std::size_t size = column_size();
  const std::size_t merged = (columns() + 1) / 2;
  counts_.resize(2 * merged * size);  // An odd one out merges with an empty column.
  for (std::size_t column = 0; column < merged; ++column)
    for (std::size_t i = 0; i < size; ++i)
      counts_[column * size + i] =
          counts_[2 * column * size + i] + counts_[(2 * column + 1) * size + i];
  counts_.resize(merged * size);
  ++scale_;
}

void LaneStrip::coarsen(int scale) {
  LANESCOPE_CHECK(scale >= scale_, "scale {} is finer than {}", scale, scale_);
  while (scale_ < scale) merge_pairs();
}

LaneSums LaneStrip::total() const {
  LaneSums total;
  for (const LaneSums& stage : sums_) {
    total.issued += stage.issued;
    total.charged += stage.charged;
  }
  return total;
}

const std::vector<LaneStrip>& LaneStrips::at_one_scale() {
  int coarsest = 0;
  for (const LaneStrip& strip : strips_) coarsest = std::max(coarsest, strip.scale());
  for (LaneStrip& strip : strips_) strip.coarsen(coarsest);
  return strips_;
}

}  // namespace lanescope
