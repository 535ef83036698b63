// SPDX-License-Identifier: MIT
// The command line of a program with two kinds of work: ours, and one that only tests know.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/working_directory.h"

namespace lanescope::testing {
namespace {

class Kinds : public InEmptyDirectory {
 protected:
  Outcome program(const std::string& arguments, int status = 0) const {
    Outcome outcome =
        shell(std::string("'") + LANESCOPE_WITH_NUMBERS + "' " + arguments, directory());
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.errors;
    return outcome;
  }
  /// Expects one line, status 2 and nothing written.
  void refuses(const std::string& arguments, const std::string& complaint) const {
    const Outcome outcome = program(arguments, 2);
    EXPECT_EQ(outcome.errors, "lanescope: " + complaint + "\n");
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(entries(), std::set<std::string>{});
  }
};

TEST_F(Kinds, AreGroupsOfTheHelp) {
  const std::string help = program("run --help").output;
  for (const char* words :
       {"Kind of work: micropolygons:\n", "Kind of work: numbers:\n", "(.obj, .vox or .numbers)"})
    EXPECT_NE(help.find(words), std::string::npos) << words << "\n" << help;
}

TEST_F(Kinds, AreListed) {
  EXPECT_NE(program("list workloads").output.find("\nnumbers "), std::string::npos);
  EXPECT_NE(program("list kernels").output.find("takes numbers; W = 1 to 64\n"), std::string::npos);
  EXPECT_NE(program("list scenes").output.find("\nrising "), std::string::npos);
}

TEST_F(Kinds, AreNotMixedInACommand) {
  refuses("run --kernel lockstep,sum",
          "--kernel: lockstep takes micropolygons, and sum takes numbers; name kernels of one kind "
          "of work");
}

TEST_F(Kinds, HaveTheirOwnParametersScenesAndFiles) {
  refuses("run --kernel sum --msaa 4",
          "--msaa: sum does not take it; rastmp, lockstep and repack do");
  refuses("run --kernel sum,running_sum --resolution 48x30",
          "--resolution: sum and running_sum do not take it; rastmp, lockstep and repack do");
  refuses("run --kernel sum --scene teapot",
          "--scene: 'teapot' is not a scene of numbers; use scattered or rising, or name a number "
          "list file (.numbers)");
  refuses("run --kernel sum --scene thesis",
          "--scene: 'thesis' is not a scene of numbers; use scattered or rising, or name a number "
          "list file (.numbers)");
  refuses("run --kernel sum --mesh a.obj", "--mesh: 'a.obj' is not a number list file (.numbers)");
  refuses("trace --kernel sum --width 4 --region 1,2,3x4 --listing -",
          "--region: numbers have no regions; leave it out");
  refuses("render --kernel sum --width 4 -o x.png", "--show: output of sum is no picture");
}

TEST_F(Kinds, TheFirstRunsIfNoKernelIsNamed) {
  const auto report = nlohmann::json::parse(
      program("run --resolution 48x30 --width 8 --mode uncounted --json -").output);
  ASSERT_EQ(report["runs"].size(), 2u);
  for (const auto& run : report["runs"]) EXPECT_EQ(run["workload"], "micropolygons");
}

TEST_F(Kinds, EveryCommandTakesTheSecond) {
  program("run --kernel sum,running_sum --scene all --width 3,4 --observe-every 1 --json r.json");
  const auto report = nlohmann::json::parse(file("r.json"));
  EXPECT_EQ(report["runs"].size(), 8u);
  EXPECT_NE(program("show r.json").output.find("Instr./num"), std::string::npos);
  EXPECT_NE(program("annotate --from r.json --kernel sum --width 3").output.find("sum, W = 3"),
            std::string::npos);
  EXPECT_NE(program("trace --kernel sum --width 4 --batches 0:1 --listing -").output.find("# sum"),
            std::string::npos);
  program("report r.json -o r.html");
  program("csv r.json --rows runs");
}

}  // namespace
}  // namespace lanescope::testing
