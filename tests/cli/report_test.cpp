// SPDX-License-Identifier: MIT
// `lanescope report` as a user runs it. What the page shows is tested in tests/analysis and
// tests/html.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "analysis/base/files.h"
#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

using testing::lanescope_program;
using testing::Outcome;

/// A directory with two small reports, of 4 and of 9 samples a pixel.
class ReportCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_.emplace();
    for (const int samples : {4, 9}) {
      const Outcome run = lanescope_program(
          fmt::format("run --scene teapot --resolution 24x16 --kernel lockstep,repack --width 8 "
                      "--msaa {0} --json {0}.json",
                      samples),
          directory());
      ASSERT_EQ(run.status, 0) << run.errors;
    }
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  static std::string directory() { return scratch_->path(); }

  void expect_mistake(const std::string& arguments, const std::string& complaint) {
    const Outcome outcome = lanescope_program("report " + arguments, directory());
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.errors, "lanescope: " + complaint + "\n");
    EXPECT_EQ(outcome.output, "");
    EXPECT_FALSE(std::filesystem::exists(directory() + "/never.html"));
  }

 private:
  inline static std::optional<testing::ScratchDirectory> scratch_;
};

TEST_F(ReportCommand, HelpHasAnExample) {
  const Outcome help = lanescope_program("report --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.output.find("Examples:\n  lanescope report "), std::string::npos);
}

TEST_F(ReportCommand, WritesOnePageThatNamesNoOtherFile) {
  const Outcome outcome = lanescope_program("report 4.json -o page.html", directory());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.output + outcome.errors, "");
  const std::string page = read_file(directory() + "/page.html");
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(page.find("<script src"), page.npos);
  EXPECT_EQ(page.find("rel=\"stylesheet\""), page.npos);
  EXPECT_NE(page.find("Redistributions in binary form must reproduce"), page.npos);
  EXPECT_LT(page.size(), 2'000'000u);
}

TEST_F(ReportCommand, WritesTheSamePageToStandardOutput) {
  ASSERT_EQ(lanescope_program("report 4.json -o page.html", directory()).status, 0);
  const Outcome outcome = lanescope_program("report 4.json -o -", directory());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(outcome.output == read_file(directory() + "/page.html"));
}

TEST_F(ReportCommand, IsWhatRunWritesAsHtml) {
  const Outcome run = lanescope_program(
      "run --scene teapot --resolution 24x16 --width 8 --json report.json --html run.html",
      directory());
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("lockstep on teapot"), run.output.npos);  // It prints its tables, too.
  ASSERT_EQ(lanescope_program("report report.json -o report.html", directory()).status, 0);
  // What was run stands at the end, with times in more digits than a file has.
  const auto figures = [](const std::string& file) {
    const std::string page = read_file(directory() + file);
    return page.substr(0, page.find("<h2 id=\"runs\">"));
  };
  EXPECT_TRUE(figures("/run.html") == figures("/report.html"));
}

TEST_F(ReportCommand, AndJsonOfARunCannotBothBeStandardOutput) {
  const Outcome run =
      lanescope_program("run --scene teapot --resolution 24x16 --json - --html -", directory());
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.errors, "lanescope: --html: standard output is taken by --json; name a file\n");
}

TEST_F(ReportCommand, PoolsReportsAndLetsTheirSettingsBePicked) {
  const Outcome outcome = lanescope_program("report 4.json 9.json -o both.html", directory());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const std::string page = read_file(directory() + "/both.html");
  EXPECT_NE(page.find("<select name=\"samples_per_pixel\"><option selected>4</option>"
                      "<option>9</option></select>"),
            page.npos);
}

TEST_F(ReportCommand, MistakesAreOneLineAndLeaveNoPage) {
  expect_mistake("-o never.html", "report: of what? Name a report, as `run --json` writes it");
  expect_mistake("4.json", "--output: is missing; name an HTML file");
  expect_mistake("4.json -o never.html --frames nowhere", "--frames: 'nowhere' is not a directory");
  expect_mistake("4.json 4.json -o never.html",
                 "4.json: has a run that 4.json has, too: lockstep on teapot, W = 8, "
                 "micropolygon = triangle; leave out one of the files");
  const Outcome missing = lanescope_program("report none.json -o never.html", directory());
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.errors.rfind("lanescope: none.json", 0), 0u) << missing.errors;
}

}  // namespace
}  // namespace lanescope
