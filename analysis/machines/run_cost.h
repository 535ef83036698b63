// SPDX-License-Identifier: MIT
// What runs of a report take on a machine: from the integer counts of the report, without running
// anything. What the counts do not say (groups of lanes, lines of memory) is taken from the pieces
// of work that were observed, in proportion to what was issued.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/machines/price.h"
#include "analysis/tables/report_view.h"

namespace lanescope {

/// Of a stage, or of all.
struct SlotSum {
  double slots = 0.0;
  /// Slots that the lanes which were on would have taken side by side in full native vectors.
  double useful = 0.0;

  SlotSum& operator+=(const SlotSum& other);
  std::optional<double> utilization() const;
};

struct RunCost {
  std::vector<SlotSum> stages;    ///< In the order of the run.
  std::set<std::string> missing;  ///< What is not known; if anything, there is no sum.
  bool from_observed = false;     ///< Masks or addresses of the observed pieces were needed.

  /// Of all stages; none if anything is missing.
  std::optional<SlotSum> total() const;
};

/// The costs of the runs of one report on one machine. Keeps references to the report and to the
/// machine.
class ReportCosts {
 public:
  ReportCosts(const Report& report, const MachineDescription& machine, SequenceTrials& trials,
              const CostFactors& factors = {});

  const MachineDescription& machine() const { return machine_; }
  /// Requires a run of the report.
  const RunCost& of(const RunRecord& run) const { return costs_.at(&run); }

  /// Slots for each element; of a stage, or of all. None where something is missing, nothing was
  /// counted, or the run has no such stage.
  std::optional<double> slots_per_element(const RunRecord& run) const;
  std::optional<double> slots_per_element(const RunRecord& run, std::string_view stage) const;
  std::optional<double> utilization(const RunRecord& run) const;
  std::optional<double> utilization(const RunRecord& run, std::string_view stage) const;

  /// What is missing for some run, and whether some run needed what was observed.
  std::set<std::string> missing() const;
  bool from_observed() const;
  /// Instructions that have the figure of their class, as the machine does not know them by name:
  /// those from outside the set.
  std::set<std::string> priced_by_class() const;

 private:
  std::optional<SlotSum> stage_sum(const RunRecord& run, std::string_view stage) const;

  const Report& report_;
  const MachineDescription& machine_;
  std::map<const RunRecord*, RunCost> costs_;
};

}  // namespace lanescope
