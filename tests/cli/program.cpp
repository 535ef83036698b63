// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "analysis/base/files.h"
#include "tests/scratch_directory.h"

namespace lanescope::testing {

Outcome shell(const std::string& command_line, const std::string& directory) {
  const ScratchDirectory scratch;
  const std::string output = scratch / "output", errors = scratch / "errors";
  const std::string command =
      fmt::format("cd '{}' && {} >'{}' 2>'{}' </dev/null", directory, command_line, output, errors);
  const int ended = std::system(command.c_str());
  return {WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended), read_file(output),
          read_file(errors)};
}

Outcome lanescope_program(const std::string& arguments, const std::string& directory) {
  return shell(fmt::format("'{}' {}", LANESCOPE_BINARY, arguments), directory);
}

std::vector<std::string> listed(const std::string& what, const std::string& words) {
  const Outcome list = lanescope_program("list " + what);
  EXPECT_EQ(list.status, 0) << list.errors;
  std::vector<std::string> names;
  std::istringstream lines(list.output);
  for (std::string line; std::getline(lines, line);)
    if (line.find(words) != line.npos) names.push_back(line.substr(0, line.find(' ')));
  return names;
}

std::vector<std::string> commands_and_studies() {
  std::vector<std::string> names = listed("commands");
  for (const std::string& study : listed("studies")) names.push_back("study " + study);
  return names;
}

std::string made_small(const std::string& arguments) {
  static const std::regex kResolution(" --resolution [0-9x]+");
  const bool is_study = arguments.starts_with("study ");
  const std::size_t end = arguments.find(' ', is_study ? std::string("study ").size() : 0);
  const std::string help = lanescope_program(arguments.substr(0, end) + " --help").output;
  if (arguments.find("--from") != arguments.npos) return arguments;
  static const std::regex kWorldSize(" --world-size [0-9]+");
  if (arguments.find("--world-size") != arguments.npos)
    return std::regex_replace(arguments, kWorldSize, " --world-size 16");
  if (is_study && help.find("--world-size") != help.npos)
    return arguments + " --world-size 16 --width 8,24 --scene scattered1";
  if (help.find("--resolution") == help.npos) return arguments;
  return std::regex_replace(arguments, kResolution, "") + " --resolution 96x60";
}

}  // namespace lanescope::testing
