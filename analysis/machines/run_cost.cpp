// SPDX-License-Identifier: MIT
#include "analysis/machines/run_cost.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/figures.h"

namespace lanescope {
namespace {

/// How often what was observed was issued in all.
double scale_of(std::uint64_t issued, std::uint64_t observed) {
  return static_cast<double>(issued) / static_cast<double>(observed);
}

template <class Record>
const Record* find_record(const std::vector<Record>& records, std::string_view mnemonic) {
  const auto found = std::find_if(records.begin(), records.end(), [&](const Record& record) {
    return record.mnemonic == mnemonic;
  });
  return found == records.end() ? nullptr : &*found;
}

/// The explanations of the instructions of a report.
using Entries = std::map<std::string, const InstructionEntry*, std::less<>>;

/// Adds up the costs of one run.
class RunPricer {
 public:
  RunPricer(const RunRecord& run, const MachineDescription& machine, const Entries& entries,
            Prices& prices)
      : run_(run), machine_(machine), entries_(entries), prices_(prices) {}

  RunCost cost() {
    for (const StageRecord& stage : run_.stages) {
      SlotSum& sum = cost_.stages.emplace_back();
      for (const InstructionRecord& counts : stage.instructions) sum += slots(stage, counts);
    }
    return std::move(cost_);
  }

 private:
  SlotSum slots(const StageRecord& stage, const InstructionRecord& counts) {
    const auto entry = entries_.find(counts.mnemonic);
    const Price& price = prices_.of(
        counts.mnemonic, entry == entries_.end() ? "" : entry->second->instruction_class);
    cost_.missing.insert(price.missing.begin(), price.missing.end());
    if (!price.missing.empty()) return {};
    const ByBasis counted = counted_in(stage, counts, price);
    return {slots_of(price, counted), slots_of(price, useful(counted, counts))};
  }

  double native_lanes() const {
    return static_cast<double>(machine_.lanes.value_or(run_.configuration.width));
  }

  ByBasis counted_in(const StageRecord& stage, const InstructionRecord& counts,
                     const Price& price) {
    const auto issued = static_cast<double>(counts.issued);
    const auto groups = static_cast<double>(groups_in(machine_, run_.configuration.width));
    ByBasis counted{};
    at(counted, SlotBasis::kInstruction) = issued;
    at(counted, SlotBasis::kEveryGroup) = issued * groups;
    at(counted, SlotBasis::kGroupPair) = issued * groups * groups;
    const auto needs = [&](SlotBasis basis) { return at(price.slots, basis) != 0.0; };
    if (needs(SlotBasis::kActiveGroup) || needs(SlotBasis::kDenseGroup))
      add_groups(counted, stage, counts);
    if (needs(SlotBasis::kLane)) add_lanes(counted, stage, counts);
    if (needs(SlotBasis::kLine)) add_lines(counted, stage, counts);
    return counted;
  }

  /// The groups of an instruction; where no piece that was observed issued it, as those of the
  /// stage.
  std::optional<LaneGroupRecord> groups_of(const StageRecord& stage, std::string_view mnemonic) {
    cost_.from_observed = true;
    if (const auto* own = find_record(stage.lane_groups, mnemonic); own && own->issued > 0)
      return *own;
    LaneGroupRecord all;
    for (const LaneGroupRecord& record : stage.lane_groups) all += record;
    if (all.issued > 0) return all;
    cost_.missing.insert(
        fmt::format("masks of {} in {}, which was not observed", mnemonic, stage.name));
    return std::nullopt;
  }

  void add_groups(ByBasis& counted, const StageRecord& stage, const InstructionRecord& counts) {
    const auto record = groups_of(stage, counts.mnemonic);
    if (!record) return;
    const double scale = scale_of(counts.issued, record->issued);
    const std::size_t place = place_of_groups(machine_.lanes);
    at(counted, SlotBasis::kActiveGroup) =
        scale * static_cast<double>(record->groups.active[place]);
    at(counted, SlotBasis::kDenseGroup) = scale * static_cast<double>(record->groups.dense[place]);
  }

  /// The lanes charged are those that were on, unless the instruction is charged others.
  void add_lanes(ByBasis& counted, const StageRecord& stage, const InstructionRecord& counts) {
    const auto entry = entries_.find(counts.mnemonic);
    const bool charges_active =
        entry != entries_.end() && entry->second->charge == to_string(Charge::kActiveLanes);
    double lanes = static_cast<double>(counts.active);
    if (!charges_active) {
      const auto record = groups_of(stage, counts.mnemonic);
      if (!record) return;
      lanes = scale_of(counts.issued, record->issued) *
              static_cast<double>(record->groups.active.front());
    }
    at(counted, SlotBasis::kLane) = lanes;
  }

  /// The lines of an instruction; where no piece that was observed issued it, as those of the other
  /// memory instructions of the stage.
  void add_lines(ByBasis& counted, const StageRecord& stage, const InstructionRecord& counts) {
    cost_.from_observed = true;
    const auto* own = find_record(stage.memory, counts.mnemonic);
    const MemoryRecord record = own && own->issued > 0 ? *own : stage.memory_total();
    if (record.issued == 0) {
      cost_.missing.insert(
          fmt::format("lines of {} in {}, which was not observed", counts.mnemonic, stage.name));
      return;
    }
    at(counted, SlotBasis::kLine) =
        scale_of(counts.issued, record.issued) * static_cast<double>(record.lines);
  }

  /// The same lanes in full vectors: a share of what is of whole vectors, all of what is of lanes.
  ByBasis useful(ByBasis counted, const InstructionRecord& counts) const {
    const auto lanes = static_cast<double>(counts.active);
    const auto groups = static_cast<double>(groups_in(machine_, run_.configuration.width));
    at(counted, SlotBasis::kInstruction) = lanes / static_cast<double>(run_.configuration.width);
    at(counted, SlotBasis::kEveryGroup) = lanes / native_lanes();
    at(counted, SlotBasis::kGroupPair) = lanes / native_lanes() * groups;
    if (at(counted, SlotBasis::kActiveGroup) > 0.0)
      at(counted, SlotBasis::kActiveGroup) = lanes / native_lanes();
    if (at(counted, SlotBasis::kDenseGroup) > 0.0)
      at(counted, SlotBasis::kDenseGroup) = lanes / native_lanes();
    return counted;
  }

  const RunRecord& run_;
  const MachineDescription& machine_;
  const Entries& entries_;
  Prices& prices_;
  RunCost cost_;
};

Entries entries_of(const Report& report) {
  Entries entries;
  for (const InstructionEntry& entry : report.instructions) entries[entry.mnemonic] = &entry;
  return entries;
}

std::optional<double> per_element(const RunRecord& run, const std::optional<SlotSum>& sum) {
  const auto elements = run.elements();
  if (!sum || !elements || *elements == 0) return std::nullopt;
  return sum->slots / static_cast<double>(*elements);
}

}  // namespace

SlotSum& SlotSum::operator+=(const SlotSum& other) {
  slots += other.slots;
  useful += other.useful;
  return *this;
}

std::optional<double> SlotSum::utilization() const {
  if (slots == 0.0) return std::nullopt;
  return useful / slots;
}

std::optional<SlotSum> RunCost::total() const {
  if (!missing.empty() || stages.empty()) return std::nullopt;
  SlotSum sum;
  for (const SlotSum& stage : stages) sum += stage;
  return sum;
}

ReportCosts::ReportCosts(const Report& report, const MachineDescription& machine,
                         SequenceTrials& trials, const CostFactors& factors)
    : report_(report), machine_(machine) {
  const Entries entries = entries_of(report);
  std::map<int, Prices> by_width;
  for (const RunRecord& run : report.runs) {
    const int width = run.configuration.width;
    Prices& prices = by_width.try_emplace(width, machine, width, trials, factors).first->second;
    costs_.emplace(&run, RunPricer(run, machine, entries, prices).cost());
  }
}

std::optional<SlotSum> ReportCosts::stage_sum(const RunRecord& run, std::string_view stage) const {
  const RunCost& cost = of(run);
  if (!cost.missing.empty()) return std::nullopt;
  for (std::size_t i = 0; i < run.stages.size(); ++i)
    if (run.stages[i].name == stage) return cost.stages[i];
  return std::nullopt;
}

std::optional<double> ReportCosts::slots_per_element(const RunRecord& run) const {
  return per_element(run, of(run).total());
}

std::optional<double> ReportCosts::slots_per_element(const RunRecord& run,
                                                     std::string_view stage) const {
  return per_element(run, stage_sum(run, stage));
}

std::optional<double> ReportCosts::utilization(const RunRecord& run) const {
  const auto sum = of(run).total();
  return sum ? sum->utilization() : std::nullopt;
}

std::optional<double> ReportCosts::utilization(const RunRecord& run, std::string_view stage) const {
  const auto sum = stage_sum(run, stage);
  return sum ? sum->utilization() : std::nullopt;
}

std::set<std::string> ReportCosts::missing() const {
  std::set<std::string> all;
  for (const auto& [run, cost] : costs_) all.insert(cost.missing.begin(), cost.missing.end());
  return all;
}

bool ReportCosts::from_observed() const {
  return std::any_of(costs_.begin(), costs_.end(),
                     [](const auto& cost) { return cost.second.from_observed; });
}

std::set<std::string> ReportCosts::priced_by_class() const {
  std::set<std::string> of_set, by_class;
  for (const InstructionInfo* info : priced_instructions()) of_set.emplace(info->mnemonic);
  for (const InstructionEntry& entry : report_.instructions)
    if (!of_set.contains(entry.mnemonic) && !machine_.names(entry.mnemonic) &&
        machine_.find(entry.mnemonic, entry.instruction_class))
      by_class.insert(entry.mnemonic);
  return by_class;
}

}  // namespace lanescope
