// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "analysis/base/files.h"

namespace lanescope::testing {

Outcome shell(const std::string& command_line, const std::string& directory) {
  const std::string stem = fmt::format("{}lanescope-program-{}", ::testing::TempDir(), ::getpid());
  const std::string command = fmt::format("cd '{}' && {} >'{}.out' 2>'{}.err' </dev/null",
                                          directory, command_line, stem, stem);
  const int ended = std::system(command.c_str());
  Outcome outcome{WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended),
                  read_file(stem + ".out"), read_file(stem + ".err")};
  std::filesystem::remove(stem + ".out");
  std::filesystem::remove(stem + ".err");
  return outcome;
}

Outcome lanescope_program(const std::string& arguments, const std::string& directory) {
  return shell(fmt::format("'{}' {}", LANESCOPE_BINARY, arguments), directory);
}

std::string made_small(const std::string& arguments) {
  static const std::regex kResolution(" --resolution [0-9x]+");
  const std::string help =
      lanescope_program(arguments.substr(0, arguments.find(' ')) + " --help").output;
  if (help.find("--resolution") == help.npos || arguments.find("--from") != arguments.npos)
    return arguments;
  return std::regex_replace(arguments, kResolution, "") + " --resolution 96x60";
}

}  // namespace lanescope::testing
