// SPDX-License-Identifier: MIT
#include "analysis/machines/price.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "analysis/report/lane_groups.h"
#include "simulator/base/error.h"
#include "simulator/memory.h"

namespace lanescope {
namespace {

/// Keeps what a sequence issues.
class IssueRecorder final : public Observer {
 public:
  void issued(const IssueEvent& event) override {
    std::set<std::uint64_t> lines;
    for (const Touch& touch : event.touches) lines.insert(touch.byte / kLineBytes);
    issues.push_back({&event.info, event.active, lines.size()});
  }
  std::vector<SequenceTrials::Issue> issues;
};

std::vector<SequenceTrials::Issue> issues_of(const SequenceInfo& sequence, int width,
                                             std::uint64_t active) {
  IssueRecorder recorder;
  sequence.execute(width, active, recorder);
  return std::move(recorder.issues);
}

/// Whether an instruction is issued by its own sequence, or by those of what that issues.
class CycleSearch {
 public:
  explicit CycleSearch(const MachineDescription& machine) : machine_(machine) {}

  bool needs(const SlotFigure& figure, std::string_view wanted) {
    if (!figure.sequence || !seen_.insert(figure.sequence).second) return false;
    const auto& issues = trials_.of(*figure.sequence, 8);
    return std::any_of(issues.begin(), issues.end(), [&](const SequenceTrials::Issue& issue) {
      if (issue.info->mnemonic == wanted) return true;
      const SlotFigure* const next =
          machine_.find(issue.info->mnemonic, to_string(issue.info->instruction_class));
      return next && needs(*next, wanted);
    });
  }

 private:
  const MachineDescription& machine_;
  SequenceTrials trials_;
  std::set<const SequenceInfo*> seen_;
};

}  // namespace

double slots_of(const Price& price, const ByBasis& counted) {
  double sum = 0.0;
  for (std::size_t i = 0; i < counted.size(); ++i) sum += price.slots[i] * counted[i];
  return sum;
}

int groups_in(const MachineDescription& machine, int width) {
  const int lanes = machine.lanes.value_or(width);
  return (width + lanes - 1) / lanes;
}

ByBasis counted_once(const MachineDescription& machine, std::uint64_t mask, std::uint64_t lines) {
  const LaneGroups groups = lane_groups_of(mask);
  const std::size_t place = place_of_groups(machine.lanes);
  const auto active = static_cast<double>(groups.active[place]);
  ByBasis counted{};
  at(counted, SlotBasis::kInstruction) = 1.0;
  at(counted, SlotBasis::kEveryGroup) = active;
  at(counted, SlotBasis::kGroupPair) = active * active;
  at(counted, SlotBasis::kActiveGroup) = active;
  at(counted, SlotBasis::kDenseGroup) = static_cast<double>(groups.dense[place]);
  at(counted, SlotBasis::kLane) = static_cast<double>(std::popcount(mask));
  at(counted, SlotBasis::kLine) = static_cast<double>(lines);
  return counted;
}

const std::vector<SequenceTrials::Issue>& SequenceTrials::of(const SequenceInfo& sequence,
                                                             int width) {
  const auto [place, is_new] = trials_.try_emplace({&sequence, width});
  if (!is_new) return place->second;
  const std::uint64_t all = low_bits(width);
  place->second = issues_of(sequence, width, all);
  if (sequence.lane_by_lane) return place->second;
  // What runs under another mask if the sequence does.
  const std::vector<Issue> with_one_lane = issues_of(sequence, width, 1);
  LANESCOPE_CHECK(with_one_lane.size() == place->second.size(), "{} has branches", sequence.name);
  for (std::size_t i = 0; i < with_one_lane.size(); ++i)
    place->second[i].follows = place->second[i].mask == all && with_one_lane[i].mask == 1;
  return place->second;
}

const Price& Prices::of(std::string_view mnemonic, std::string_view instruction_class) {
  const auto known = prices_.find(mnemonic);
  if (known != prices_.end()) return known->second;
  return prices_.emplace(mnemonic, found(mnemonic, instruction_class)).first->second;
}

Price Prices::found(std::string_view mnemonic, std::string_view instruction_class) {
  Price price;
  const SlotFigure* const figure = machine_.find(mnemonic, instruction_class);
  if (!figure || !figure->known) {
    price.missing.emplace(mnemonic);
    return price;
  }
  price.slots = figure->slots;
  if (figure->sequence)
    add_sequence(price, *figure->sequence,
                 instruction_class == to_string(InstructionClass::kMemory));
  if (const auto factor = factors_.find(mnemonic); factor != factors_.end())
    for (double& slots : price.slots) slots *= factor->second;
  return price;
}

void Prices::add_sequence(Price& price, const SequenceInfo& sequence, bool is_memory) {
  double slots = 0.0;
  for (const SequenceTrials::Issue& issue : trials_.of(sequence, width_)) {
    Price each = of(issue.info->mnemonic, to_string(issue.info->instruction_class));
    price.missing.insert(each.missing.begin(), each.missing.end());
    if (issue.follows) {
      // Counted as the instruction is that the sequence stands for; of its lines, if it has any.
      double& of_lines = at(each.slots, SlotBasis::kLine);
      if (!is_memory) slots += std::exchange(of_lines, 0.0) * static_cast<double>(issue.lines);
      for (std::size_t i = 0; i < each.slots.size(); ++i) price.slots[i] += each.slots[i];
    } else {
      slots += slots_of(each, counted_once(machine_, issue.mask, issue.lines));
    }
  }
  if (sequence.lane_by_lane)
    at(price.slots, SlotBasis::kLane) += slots / width_;
  else
    at(price.slots, SlotBasis::kInstruction) += slots;
}

std::string sequence_that_needs_itself(const MachineDescription& machine) {
  for (const InstructionInfo* info : priced_instructions()) {
    const SlotFigure* const figure =
        machine.find(info->mnemonic, to_string(info->instruction_class));
    if (figure && CycleSearch(machine).needs(*figure, info->mnemonic))
      return std::string(info->mnemonic);
  }
  return {};
}

}  // namespace lanescope
