// SPDX-License-Identifier: MIT
// Machines made by hand.
#pragma once

#include <string>

#include "analysis/machines/description.h"

namespace lanescope::testing {

/// Reads a description that may inherit from the program's machines.
inline MachineDescription machine_from(const std::string& text) {
  const auto& shipped = shipped_machines();
  return read_machine(
      text, "m.json",
      [&](std::string_view name) -> const MachineDescription* {
        for (const MachineDescription& machine : shipped)
          if (machine.name == name) return &machine;
        return nullptr;
      },
      names_of(shipped));
}

/// Of 4 lanes: every class takes a slot for each group, but those that `members` say otherwise of:
/// `, "instructions": {...}`.
inline MachineDescription four_lanes(const std::string& members = "") {
  std::string classes;
  for (const InstructionClass each : kInstructionClasses)
    classes += fmt::format(R"({}"{}": {{"slots": {{"every_group": 1}}, "source": "assumed"}})",
                           classes.empty() ? "" : ", ", to_string(each));
  return machine_from(
      fmt::format(R"({{"name": "four", "summary": "four lanes", "lanes": 4, "classes": {{{}}}{}}})",
                  classes, members));
}

}  // namespace lanescope::testing
