// SPDX-License-Identifier: MIT
// Tables of what runs take on machines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/machines/run_cost.h"
#include "analysis/tables/table.h"

namespace lanescope {

inline constexpr Unit kSlots{"slots/element", 1.0, "", 2, 2, Difference::kRelative};

/// `avx2 (8 lanes, 0x0123456789abcdef)`.
std::string shown_machine(const MachineDescription& machine);

/// What a reader of a table of this machine must know: what is missing, what came from the pieces
/// observed, what has the figure of its class.
std::vector<std::string> notes_on(const ReportCosts& costs);

/// Slots for each element by stage and width, and in parentheses the utilization under the machine.
TableData cost_table(const ReportView& view, const ReportCosts& costs);

/// The same as one document: for each run and stage slots, slots for each element and utilization.
nlohmann::ordered_json cost_json(const Report& report, const ReportCosts& costs);

/// Name, hash and lanes of a machine, as documents have them.
nlohmann::ordered_json machine_json(const MachineDescription& machine);

/// What an instruction of the set takes on the shipped machines, in slots or by a sequence: an item
/// of a Markdown list, a line. Machines on which it takes the same stand together.
std::string machine_prices(const InstructionInfo& instruction);

}  // namespace lanescope
