// SPDX-License-Identifier: MIT
#include "simulator/tally.h"

#include <algorithm>
#include <bit>

#include "simulator/base/error.h"
#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

/// Calls f(instruction, times) for what a list holds.
template <class F>
void for_each_issued(const IssueList& list, F&& f) {
  const auto infos = instruction_set();
  const auto visit = [&](const std::uint64_t* words, bool overhead) {
    for (std::size_t word = 0; word < IssueList::kWords; ++word)
      for (std::uint64_t left = words[word]; left != 0;) {
        const int quarter = std::countr_zero(left) / 16;
        f(Issued{infos[4 * word + static_cast<std::size_t>(quarter)], overhead},
          left >> (16 * quarter) & IssueList::kMostTimes);
        left &= ~(IssueList::kMostTimes << (16 * quarter));
      }
  };
  visit(list.baseline, false);
  visit(list.overhead, true);
  for (int i = 0; i < list.foreign_count; ++i) f(list.foreign[i], 1);
}

}  // namespace

Tally::Tally(int width, std::size_t stage_count) : width_(width), stages_(stage_count) {
  for (Stage& stage : stages_) {
    stage.lane_active.resize(static_cast<std::size_t>(width));
    stage.histogram.resize(static_cast<std::size_t>(width) + 1);
  }
}

SiteLog& Tally::open(std::size_t stage) {
  if (free_.empty()) free_.push_back(logs_.emplace_back(std::make_unique<SiteLog>()).get());
  SiteLog& log = *free_.back();
  free_.pop_back();
  log.stage = stage;
  return log;
}

void Tally::take(SiteLog& log) {
  Stage& stage = stages_[log.stage];
  std::uint64_t executions = 0;
  std::uint64_t active = 0;
  for (std::size_t k = 0; k < log.sums.histogram.size(); ++k) {
    executions += log.sums.histogram[k];
    active += log.sums.histogram[k] * k;
  }
  std::uint64_t length = 0;
  if (executions != 0) {
    for_each_issued(log.list, [&](Issued instruction, std::uint64_t times) {
      length += times;
      add(stage, instruction, times * executions, times * active);
    });
  }
  const auto add_up = [&](std::vector<std::uint64_t>& to, const auto& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i] * length;
    for (std::size_t i = to.size(); i < from.size(); ++i) beyond_width_ |= from[i] != 0;
  };
  add_up(stage.lane_active, log.sums.lanes);
  add_up(stage.histogram, log.sums.histogram);
  log.sums = {};
}

void Tally::charge(std::size_t stage_index, Issued issued, std::uint64_t active) {
  Stage& stage = stages_[stage_index];
  const auto lanes = static_cast<std::size_t>(std::popcount(active));
  if (lanes >= stage.histogram.size() || active >> 1 >> (width_ - 1) != 0) {
    beyond_width_ = true;
    return;
  }
  add(stage, issued, 1, lanes);
  ++stage.histogram[lanes];
  for (std::size_t i = 0; i < stage.lane_active.size(); ++i)
    stage.lane_active[i] += active >> i & 1;
}

InstructionCounts& Tally::counts_of(Stage& stage, const InstructionInfo* info) {
  std::vector<InstructionCounts>& all = stage.instructions;
  const auto address = reinterpret_cast<std::uintptr_t>(info);
  std::uint32_t& place = stage.recent[(address ^ address >> 6) / alignof(InstructionInfo) % 64];
  if (place < all.size() && all[place].info == info) return all[place];
  for (place = 0; place < all.size(); ++place)
    if (all[place].info == info) return all[place];
  return all.emplace_back(InstructionCounts{.info = info});
}

void Tally::add(Stage& stage, Issued instruction, std::uint64_t issued, std::uint64_t active) {
  InstructionCounts& counts = counts_of(stage, instruction.info);
  const std::uint64_t lanes = charged_lanes(instruction.info->charge, issued, active, width_);
  counts.issued += issued;
  counts.active += lanes;
  if (!instruction.overhead) return;
  counts.overhead_issued += issued;
  counts.overhead_active += lanes;
}

Counts Tally::counts() const {
  LANESCOPE_CHECK(!beyond_width_, "a block had lanes on that are beyond the width, {}", width_);
  Counts counts(width_, stages_.size());
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    for (const InstructionCounts& c : stages_[s].instructions) counts.add(s, c);
    counts.stages[s].lane_active = stages_[s].lane_active;
    counts.stages[s].histogram = stages_[s].histogram;
  }
  return counts;
}

}  // namespace lanescope
