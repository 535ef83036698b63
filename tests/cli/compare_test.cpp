// SPDX-License-Identifier: MIT
// `lanescope compare` and `lanescope csv` as scripts use them.
#include "analysis/base/json_text.h"
#include "analysis/report/report_json.h"
#include "tests/analysis/sample_report.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using testing::Outcome;

/// Two reports, a.json and b.json, of which the second has 1% more tests in its first run.
class Reports : public testing::InEmptyDirectory {
 protected:
  Reports() {
    Report report = testing::sample_report();
    write("a.json", report_text(report));
    report.runs[0].counters[3].value = 202;
    write("b.json", report_text(report));
  }
};

TEST_F(Reports, CompareEndsWithAStatusForScripts) {
  EXPECT_EQ(run("compare a.json a.json", 0).output,
            "12 runs compared: 0 differ, 0 only in a.json, 0 only in a.json\n");
  const Outcome different = run("compare a.json b.json", 1);
  EXPECT_NE(different.output.find("tests  "), std::string::npos) << different.output;
  EXPECT_EQ(different.errors, "");
  for (const char* tolerance : {"1%", "0.01", "1.5%"})
    run(std::string("compare a.json b.json --fail-over ") + tolerance, 0);
  for (const char* tolerance : {"0.9%", "0.0099", "0"})
    run(std::string("compare a.json b.json --fail-over ") + tolerance, 1);
}

TEST_F(Reports, CompareRefusesWhatItCannotCompare) {
  write("cut.json", file("a.json").substr(0, 400));
  EXPECT_EQ(run("compare a.json cut.json", 2).errors.rfind("lanescope: cut.json:", 0), 0u);
  EXPECT_EQ(run("compare a.json none.json -o c.txt", 2).errors,
            "lanescope: none.json: cannot be read: No such file or directory\n");
  EXPECT_EQ(run("compare a.json b.json --ignore kernel", 2).errors,
            "lanescope: a.json: two runs have the same parameters but for those ignored: "
            "width_lanes=8 scene=ballroll micropolygon=triangle\n");
  EXPECT_EQ(
      run("compare a.json b.json --ignore sead", 2)
          .errors.rfind("lanescope: --ignore: 'sead' is not a parameter of a run in a.json or "
                        "b.json; use ",
                        0),
      0u);
  EXPECT_EQ(entries(), (std::set<std::string>{"a.json", "b.json", "cut.json"}));
}

TEST_F(Reports, CompareWritesEveryFormat) {
  run("compare a.json b.json --format json -o c.json", 1);
  const auto json = nlohmann::ordered_json::parse(file("c.json"));
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["runs"][0]["changes"][0]["figure"], "tests");
  EXPECT_NE(run("compare a.json b.json --format markdown --limit 1", 1)
                .output.find("| tests | 200 | 202 | +2 | +1% |\n\n... and 1 more\n"),
            std::string::npos);
}

TEST_F(Reports, RunsAtOneAndTwoThreadsCompareAsTheSame) {
  const std::string experiment = "run --scene teapot --width 8 --resolution 96x60 ";
  run(experiment + "--threads 1 --json one.json");
  run(experiment + "--threads 2 --json two.json");
  EXPECT_EQ(run("compare one.json two.json", 0).output,
            "2 runs compared: 0 differ, 0 only in one.json, 0 only in two.json\n");
  run(experiment + "--seed 2 --json seed.json");
  run("compare one.json seed.json", 1);
  EXPECT_NE(run("compare one.json seed.json --ignore seed", 1).output.find("results_hash"),
            std::string::npos);
}

TEST_F(Reports, CsvIsWrittenForEachKindOfRow) {
  const std::string header = run("csv a.json").output.substr(0, 28);
  EXPECT_EQ(header, "report,run,kernel,width_lane");
  run("csv a.json b.json --rows runs -o runs.csv");
  const std::string runs = file("runs.csv");
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 25);
  EXPECT_EQ(run("csv a.json --rows stages").output.rfind("report,", 0), 0u);
  run("run --scene teapot --width 8 --resolution 48x30 --mode uncounted --json u.json");
  EXPECT_EQ(run("csv u.json --rows stages", 2).errors,
            "lanescope: --rows: there are no stages in these reports; use runs\n");
}

}  // namespace
}  // namespace lanescope
