// SPDX-License-Identifier: MIT
// Runs the program as a user does.
#pragma once

#include <string>
#include <vector>

namespace lanescope::testing {

struct Outcome {
  int status;  ///< Exit status; 128 + n if signal n ended the program.
  std::string output;
  std::string errors;
};

/// Every command, in the order of the program's help.
inline const std::vector<std::string> kCommands{"run",    "sweep",   "merge", "tables",
                                                "report", "compare", "csv",   "annotate",
                                                "trace",  "render",  "list",  "schema"};

/// Runs `lanescope` with arguments as they are typed in a shell, in a directory.
Outcome lanescope_program(const std::string& arguments, const std::string& directory = ".");

/// Runs any command line in the same way.
Outcome shell(const std::string& command_line, const std::string& directory = ".");

/// Arguments with the resolution that takes no time, if the command has one to give.
std::string made_small(const std::string& arguments);

}  // namespace lanescope::testing
