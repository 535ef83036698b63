// SPDX-License-Identifier: MIT
// The options of commands that lay reports on machines.
#pragma once

#include <string>
#include <vector>

#include "analysis/cli/options.h"
#include "analysis/formats/format.h"
#include "analysis/html/groups.h"
#include "analysis/machines/description.h"

namespace lanescope {

/// What the options hold.
struct MachineArguments {
  std::vector<std::string> machines;
  std::string format = "text";
};

/// What is asked for.
struct MachineRequest {
  std::vector<MachineDescription> machines;
  const Format* format = nullptr;  ///< Null for JSON.
};

/// Declares `--machine` and `--format`.
void add_machine_options(CommandOptions& options, MachineArguments& arguments);

/// The request; every machine of the program if none is named. Throws InputError for names that
/// there are not, for machines that are named twice, and for files that hold none.
MachineRequest resolve_machines(const MachineArguments& arguments);

/// The settings of a report of which something was counted: tables compare runs that differ in
/// nothing else. Throws InputError, beginning with the report's name, if there are none.
std::vector<Group> counted_groups(const NamedReport& report);

}  // namespace lanescope
