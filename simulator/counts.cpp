// SPDX-License-Identifier: MIT
#include "simulator/counts.h"

#include <algorithm>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

void add(std::vector<InstructionCounts>& to, const InstructionCounts& counts) {
  const auto place = std::lower_bound(to.begin(), to.end(), counts,
                                      [](const InstructionCounts& a, const InstructionCounts& b) {
                                        return a.info->mnemonic < b.info->mnemonic;
                                      });
  if (place == to.end() || place->info->mnemonic != counts.info->mnemonic) {
    to.insert(place, counts);
    return;
  }
  LANESCOPE_CHECK(place->info == counts.info, "two instructions are named '{}'",
                  counts.info->mnemonic);
  *place += counts;
}

void add(std::vector<std::uint64_t>& to, const std::vector<std::uint64_t>& from) {
  std::transform(to.begin(), to.end(), from.begin(), to.begin(), std::plus<>());
}

}  // namespace

InstructionCounts& InstructionCounts::operator+=(const InstructionCounts& other) {
  issued += other.issued;
  active += other.active;
  overhead_issued += other.overhead_issued;
  overhead_active += other.overhead_active;
  return *this;
}

InstructionCounts StageCounts::total() const {
  InstructionCounts sum;
  for (const InstructionCounts& counts : instructions) sum += counts;
  return sum;
}

StageCounts& StageCounts::operator+=(const StageCounts& other) {
  for (const InstructionCounts& counts : other.instructions) add(instructions, counts);
  add(lane_active, other.lane_active);
  add(histogram, other.histogram);
  return *this;
}

Counts::Counts(int width, std::size_t stage_count) : width(width), stages(stage_count) {
  for (StageCounts& stage : stages) {
    stage.lane_active.resize(static_cast<std::size_t>(width));
    stage.histogram.resize(static_cast<std::size_t>(width) + 1);
  }
}

void Counts::add(std::size_t stage, const InstructionCounts& counts) {
  lanescope::add(stages.at(stage).instructions, counts);
}

Counts& Counts::operator+=(const Counts& other) {
  LANESCOPE_CHECK(width == other.width && stages.size() == other.stages.size(),
                  "W = {} and {}, {} and {} stages", width, other.width, stages.size(),
                  other.stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) stages[i] += other.stages[i];
  return *this;
}

}  // namespace lanescope
