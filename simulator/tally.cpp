// SPDX-License-Identifier: MIT
#include "simulator/tally.h"

#include <algorithm>

#include "simulator/base/error.h"
#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

/// Calls f(info, times, overhead) for what a list holds.
template <class F>
void for_each_issued(const IssueList& list, F&& f) {
  const auto infos = instruction_set();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const auto shift = 16 * (i % 4);
    if (const auto times = list.baseline[i / 4] >> shift & 0xffff) f(*infos[i], times, false);
    if (const auto times = list.overhead[i / 4] >> shift & 0xffff) f(*infos[i], times, true);
  }
  for (int i = 0; i < list.foreign_count; ++i)
    f(*list.foreign[i].info, 1, list.foreign[i].overhead);
}

}  // namespace

std::size_t Tally::intern(std::size_t stage_index, std::uint64_t signature,
                          const IssueList& issued) {
  Stage& stage = stages_.at(stage_index);
  const auto [begin, end] = stage.by_signature.equal_range(signature);
  for (auto known = begin; known != end; ++known)
    if (stage.lists[known->second].issued == issued) return known->second;
  const auto lanes = static_cast<std::size_t>(width_);
  stage.lists.push_back(
      {issued, std::vector<std::uint64_t>(lanes), std::vector<std::uint64_t>(lanes + 1)});
  stage.by_signature.emplace(signature, stage.lists.size() - 1);
  return stage.lists.size() - 1;
}

void Tally::add(std::size_t stage, std::size_t list_index,
                std::span<const std::uint16_t> lane_executions,
                std::span<const std::uint64_t> histogram) {
  List& list = stages_.at(stage).lists.at(list_index);
  for (std::size_t i = 0; i < list.lane_executions.size(); ++i)
    list.lane_executions[i] += lane_executions[i];
  for (std::size_t k = 0; k < list.histogram.size(); ++k) list.histogram[k] += histogram[k];
}

Counts Tally::counts() const {
  Counts counts(width_, stages_.size());
  for (std::size_t s = 0; s < stages_.size(); ++s)
    for (const List& list : stages_[s].lists) add_list(counts, s, list);
  return counts;
}

void Tally::add_list(Counts& counts, std::size_t stage_index, const List& list) const {
  StageCounts& stage = counts.stages[stage_index];
  std::uint64_t executions = 0;
  std::uint64_t active = 0;
  for (std::size_t k = 0; k < list.histogram.size(); ++k) {
    executions += list.histogram[k];
    active += list.histogram[k] * k;
  }
  std::uint64_t length = 0;
  for_each_issued(list.issued, [&](const InstructionInfo& info, std::uint64_t times,
                                   bool overhead) {
    length += times;
    const std::uint64_t issued = times * executions;
    const std::uint64_t lanes = times * charged_lanes(info.charge, executions, active, width_);
    counts.add(stage_index, {&info, issued, lanes, overhead ? issued : 0, overhead ? lanes : 0});
  });
  for (std::size_t k = 0; k < list.histogram.size(); ++k)
    stage.histogram[k] += list.histogram[k] * length;
  for (std::size_t i = 0; i < list.lane_executions.size(); ++i)
    stage.lane_active[i] += list.lane_executions[i] * length;
}

}  // namespace lanescope
