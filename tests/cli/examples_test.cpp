// SPDX-License-Identifier: MIT
// Every example that --help shows works, in a directory that has the files they name.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;
using testing::lanescope_program;

/// The examples at the end of a command's help, without `lanescope `.
std::vector<std::string> examples_in(const std::string& help) {
  std::vector<std::string> examples;
  std::istringstream lines(help.substr(help.find("Examples:")));
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("  lanescope ", 0) == 0) examples.push_back(line.substr(12));
  return examples;
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// The files that examples name.
void furnish(const fs::path& directory) {
  write(directory / "model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write(directory / "examples" / "small-sweep.json",
        R"({"schema": {"name": "lanescope-sweep", "version": 1},
            "parameters": {"width_px": 48, "height_px": 30, "width_lanes": [8, 16]}})");
  write(directory / "mine.json", R"({"name": "mine", "summary": "mine", "inherits": "avx2"})");
  fs::create_directories(directory / "out");
  const std::string run = "run --scene teapot --resolution 48x30 --width 8,16 --json ";
  for (const char* report : {"report.json", "a.json", "b.json"})
    ASSERT_EQ(lanescope_program(run + report, directory).status, 0);
  // Of all studies.
  ASSERT_EQ(
      lanescope_program("run --scene town --world-size 16 --json town.json", directory).status, 0);
  ASSERT_EQ(lanescope_program("merge report.json town.json -o out/report.json", directory).status,
            0);
  ASSERT_EQ(
      lanescope_program("run --scene ballroll --resolution 48x30 --json other.json", directory)
          .status,
      0);
}

TEST(Examples, OfEveryCommandWork) {
  const testing::ScratchDirectory scratch;
  const fs::path& directory = scratch.path();
  furnish(directory);
  for (const std::string& name : testing::commands_and_studies()) {
    const auto examples = examples_in(lanescope_program(name + " --help").output);
    EXPECT_FALSE(examples.empty()) << name;
    for (const std::string& example : examples) {
      const auto outcome = lanescope_program(testing::made_small(example), directory);
      EXPECT_EQ(outcome.status, 0) << example << "\n" << outcome.errors;
    }
  }
}

}  // namespace
}  // namespace lanescope
