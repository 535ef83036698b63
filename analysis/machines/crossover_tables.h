// SPDX-License-Identifier: MIT
// Crossovers of two kernels on machines, as a table and as a document.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/machines/crossover.h"
#include "analysis/tables/table.h"

namespace lanescope {

/// A crossover on a machine, and what moves it: sensitivities that change anything, most first.
struct MachineCrossover {
  MachineDescription machine;
  KernelPair pair;
  Crossover crossover;
  std::vector<Sensitivity> sensitivities;
  std::vector<std::string> notes;  ///< As notes_on() has them.
  std::set<std::string> missing;   ///< As ReportCosts has it.
};

/// Of each pair of the kernels in the view on each machine, by pair.
std::vector<MachineCrossover> crossovers(const ReportView& view, const std::string& first,
                                         const std::string& second,
                                         const std::vector<MachineDescription>& machines);

/// For each pair and machine: the crossing, the instruction that moves it most, and the ratio at
/// each width.
TableData crossover_table(const ReportView& view, const std::vector<MachineCrossover>& all);

nlohmann::ordered_json crossover_json(const MachineCrossover& one);

}  // namespace lanescope
