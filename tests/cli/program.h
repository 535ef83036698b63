// SPDX-License-Identifier: MIT
// Runs the program as a user does.
#pragma once

#include <string>

namespace lanescope::testing {

struct Outcome {
  int status;  ///< Exit status; 128 + n if signal n ended the program.
  std::string output;
  std::string errors;
};

/// Runs `lanescope` with arguments as they are typed in a shell, in a directory.
Outcome lanescope_program(const std::string& arguments, const std::string& directory = ".");

/// Runs any command line in the same way.
Outcome shell(const std::string& command_line, const std::string& directory = ".");

}  // namespace lanescope::testing
