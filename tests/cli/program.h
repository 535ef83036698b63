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

/// Runs `lanescope` with arguments as they are typed in a shell, in a directory.
Outcome lanescope_program(const std::string& arguments, const std::string& directory = ".");

/// The first words of the lines that `lanescope list <what>` prints, of those with `words` in them.
std::vector<std::string> listed(const std::string& what, const std::string& words = "");

/// Every command that has examples: those of the program, and its studies as `study <name>`.
std::vector<std::string> commands_and_studies();

/// Runs any command line in the same way.
Outcome shell(const std::string& command_line, const std::string& directory = ".");

/// Arguments with the resolution that takes no time, if the command has one to give.
std::string made_small(const std::string& arguments);

}  // namespace lanescope::testing
