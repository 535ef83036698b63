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

std::size_t Tally::keep(std::size_t place, std::size_t stage, const IssueList& list) {
  if (place == kNoPlace) {
    if (free_.empty()) {
      free_.push_back(kept_.size());
      kept_.emplace_back();
    }
    place = free_.back();
    free_.pop_back();
  }
  kept_[place] = {stage, list};
  return place;
}

void Tally::add(std::size_t place, std::span<const std::uint64_t> lane_executions,
                std::span<const std::uint64_t> histogram) {
  const Kept& kept = kept_[place];
  Stage& stage = stages_[kept.stage];
  std::uint64_t executions = 0;
  std::uint64_t active = 0;
  for (std::size_t k = 0; k < histogram.size(); ++k) {
    executions += histogram[k];
    active += histogram[k] * k;
  }
  std::uint64_t length = 0;
  for_each_issued(kept.list, [&](Issued instruction, std::uint64_t times) {
    length += times;
    add(stage, instruction, times * executions, times * active);
  });
  const auto add_up = [&](std::vector<std::uint64_t>& to, std::span<const std::uint64_t> from) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (i < to.size())
        to[i] += from[i] * length;
      else
        beyond_width_ |= from[i] != 0;
    }
  };
  add_up(stage.lane_active, lane_executions);
  add_up(stage.histogram, histogram);
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
  for (std::size_t i = 0; i < stage.lane_active.size(); ++i) stage.lane_active[i] += active >> i & 1;
}

void Tally::add(Stage& stage, Issued instruction, std::uint64_t issued, std::uint64_t active) {
  auto counts = std::ranges::find(stage.instructions, instruction.info, &InstructionCounts::info);
  if (counts == stage.instructions.end())
    counts = stage.instructions.insert(counts, {.info = instruction.info});
  const std::uint64_t lanes =
      charged_lanes(instruction.info->charge, issued, active, width_);
  *counts += {instruction.info, issued, lanes, instruction.overhead ? issued : 0,
              instruction.overhead ? lanes : 0};
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
