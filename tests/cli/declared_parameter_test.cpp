// SPDX-License-Identifier: MIT
// A parameter that is declared once, in a kernel that only tests know, is found everywhere: the
// program here is ours with the kind of work `numbers` and its kernels beside it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/cli/working_directory.h"

namespace lanescope::testing {
namespace {

Outcome program(const std::string& arguments, const std::string& directory = ".") {
  return shell(std::string("'") + LANESCOPE_WITH_NUMBERS + "' " + arguments, directory);
}

using Json = nlohmann::json;

class DeclaredParameter : public InEmptyDirectory {};

Json report_of(const std::string& arguments) {
  const Outcome run = program(arguments + " --json -");
  EXPECT_EQ(run.status, 0) << run.errors;
  return Json::parse(run.output);
}

TEST_F(DeclaredParameter, IsAnOptionWithHelp) {
  const Outcome help = program("run --help");
  EXPECT_NE(help.output.find("--start"), help.output.npos) << help.output;
  EXPECT_NE(help.output.find("What the sum starts with"), help.output.npos);
}

TEST_F(DeclaredParameter, IsListedWithItsDefaultRangeAndTakers) {
  const Outcome list = program("list parameters");
  const auto at = list.output.find("\nstart ");
  ASSERT_NE(at, list.output.npos) << list.output;
  const std::string line = list.output.substr(at + 1, list.output.find('\n', at + 1) - at - 1);
  for (const char* part : {"--start", "an integer from 0 to 1048576", "running_sum"})
    EXPECT_NE(line.find(part), line.npos) << line;
}

TEST_F(DeclaredParameter, IsInTheReport) {
  const Json report = report_of("run --kernel running_sum --width 4 --start 7");
  EXPECT_EQ(report["runs"][0]["parameters"]["start"], 7);
  EXPECT_EQ(report["runs"][0]["workload"], "numbers");
}

TEST_F(DeclaredParameter, IsNoPartOfOtherKernels) {
  const Json report = report_of("run --kernel sum --width 4");
  EXPECT_FALSE(report["runs"][0]["parameters"].contains("start"));
  const Outcome refused = program("run --kernel sum --start 7");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("running_sum"), refused.errors.npos) << refused.errors;
}

TEST_F(DeclaredParameter, IsRefusedOutsideItsRange) {
  const Outcome refused = program("run --kernel running_sum --start 1048577");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("--start: '1048577' is not an integer from 0 to 1048576"),
            refused.errors.npos)
      << refused.errors;
}

TEST_F(DeclaredParameter, IsAList) {
  EXPECT_EQ(report_of("run --kernel running_sum --width 4 --start 1,2,3")["runs"].size(), 3u);
}

TEST_F(DeclaredParameter, IsAnAxisOfSweepsAndIdentifiesCells) {
  write("spec.json", R"({"schema": {"name": "lanescope-sweep", "version": 1},
    "parameters": {"kernel": ["sum", "running_sum"], "width_lanes": 4, "start": [1, 2, 3]}})");
  const Outcome cells = program("sweep spec.json --out cells --dry-run", directory());
  EXPECT_EQ(cells.status, 0) << cells.errors;
  // One cell of `sum`, which does not take it, and three of `running_sum`.
  EXPECT_NE(cells.output.find("4 cells"), cells.output.npos) << cells.output;
  EXPECT_NE(cells.output.find("start=2"), cells.output.npos) << cells.output;
}

TEST_F(DeclaredParameter, IsInTheSchema) {
  const Outcome schema = program("schema");
  const Json document = Json::parse(schema.output);
  const std::string parameters = document["$defs"]["parameters"].dump();
  EXPECT_NE(parameters.find("\"start\""), parameters.npos);
  EXPECT_NE(parameters.find("What the sum starts with"), parameters.npos);
}

TEST_F(DeclaredParameter, TellsRunsApartInComparisons) {
  for (const char* start : {"1", "2"}) {
    const Outcome run = program(std::string("run --kernel running_sum --width 4 --start ") + start +
                                    " --json " + start + ".json",
                                directory());
    ASSERT_EQ(run.status, 0) << run.errors;
  }
  const Outcome different = program("compare 1.json 2.json", directory());
  EXPECT_EQ(different.status, 1);
  EXPECT_NE((different.output + different.errors).find("start"), std::string::npos);
  const Outcome merged = program("merge 1.json 2.json -o both.json", directory());
  EXPECT_EQ(merged.status, 0) << merged.errors;
}

}  // namespace
}  // namespace lanescope::testing
