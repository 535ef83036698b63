// SPDX-License-Identifier: MIT
#include "analysis/comparison/compare.h"

#include <gtest/gtest.h>

#include "analysis/base/json_text.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// Two reports, equal until a test changes one.
class Compare : public ::testing::Test {
 protected:
  Compare() { before.report = after.report = testing::sample_report(); }

  Comparison result() const { return compare(before, after, options); }
  ComparisonDocument document(const Comparison& comparison, std::size_t limit = 20) const {
    return {before, after, options, comparison, limit};
  }
  /// The counter `tests` of the first run: 200.
  std::uint64_t& tests() { return after.report.runs[0].counters[3].value; }

  NamedReport before{"a.json", {}};
  NamedReport after{"b.json", {}};
  CompareOptions options;
};

const Change* find(const RunChanges& run, const std::string& stage, const std::string& figure) {
  for (const Change& change : run.changes)
    if (change.stage == stage && change.figure == figure) return &change;
  return nullptr;
}

TEST_F(Compare, AReportIsTheSameAsItself) {
  const Comparison same = result();
  EXPECT_TRUE(same.same());
  EXPECT_EQ(same.compared, 12u);
  EXPECT_TRUE(same.runs.empty());
  EXPECT_EQ(document(same).text(false),
            "12 runs compared: 0 differ, 0 only in a.json, 0 only in b.json\n");
}

TEST_F(Compare, TimingAndMakerDoNotMatterButMakersAreNamed) {
  after.report.timing.wall_ms = 1e6;
  after.report.timing.threads = 64;
  after.report.commit = "fedcba987654";
  after.report.command = "lanescope run";
  const Comparison same = result();
  EXPECT_TRUE(same.same());
  EXPECT_NE(document(same).text(false).find(
                "a.json is of lanescope 0.1.0, commit 0123456789ab; b.json is of lanescope 0.1.0, "
                "commit fedcba987654\n"),
            std::string::npos);
}

TEST_F(Compare, AChangedCounterChangesItselfAndItsMetrics) {
  tests() = 220;
  const Comparison comparison = result();
  EXPECT_FALSE(comparison.same());
  ASSERT_EQ(comparison.runs.size(), 1u);
  const RunChanges& run = comparison.runs[0];
  EXPECT_EQ(run.run, "kernel=lockstep width_lanes=8 scene=ballroll micropolygon=triangle");
  ASSERT_EQ(run.changes.size(), 2u);
  const Change* changed = find(run, "", "tests");
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->before, 200);
  EXPECT_EQ(changed->after, 220);
  EXPECT_EQ(changed->difference, 20.0);
  EXPECT_EQ(changed->relative, 0.1);
  const Change* metric = find(run, "", "ste");
  ASSERT_TRUE(metric);
  EXPECT_EQ(metric->before, 0.2);
  EXPECT_NEAR(*metric->relative, -1.0 / 11.0, 1e-12);
  EXPECT_EQ(document(comparison).text(false),
            "12 runs compared: 1 differ, 0 only in a.json, 0 only in b.json; largest change +10% "
            "(tests of kernel=lockstep width_lanes=8 scene=ballroll micropolygon=triangle)\n\n"
            "kernel=lockstep width_lanes=8 scene=ballroll micropolygon=triangle\n"
            "  Figure     old     new   change  relative\n"
            "  tests      200     220      +20      +10%\n"
            "  ste     0.2000  0.1818  -0.0182    -9.09%\n");
}

TEST_F(Compare, AChangedInstructionChangesItsStageAndTheWhole) {
  InstructionRecord& add = after.report.runs[0].stages[2].instructions[0];  // Test: 60 / 360.
  add.issued += 15;
  const Comparison comparison = result();
  ASSERT_EQ(comparison.runs.size(), 1u);
  const RunChanges& run = comparison.runs[0];
  EXPECT_EQ(*find(run, "Test", "issued")->relative, 0.25);
  EXPECT_EQ(*find(run, "All stages", "issued")->difference, 15.0);
  EXPECT_EQ(find(run, "Test", "utilization")->before, 0.75);
  EXPECT_EQ(find(run, "Test", "utilization")->after, 0.6);
  EXPECT_EQ(*find(run, "Test", "issued_per_element")->difference, 0.75);
  EXPECT_TRUE(find(run, "Test", "add issued")->is_detail);
  EXPECT_FALSE(find(run, "Test", "active"));
  EXPECT_TRUE(run.changes.back().is_detail);
  for (std::size_t i = 1; i < run.changes.size(); ++i)
    if (run.changes[i].is_detail == run.changes[i - 1].is_detail) {
      EXPECT_LE(std::abs(*run.changes[i].relative), std::abs(*run.changes[i - 1].relative));
    }
  EXPECT_NE(document(comparison).text(false).find("-15 points"), std::string::npos);
}

TEST_F(Compare, LanesThatMoveAreADifferenceEvenIfTheirSumStays) {
  auto& lanes = after.report.runs[0].stages[2].lane_active;
  lanes[0] -= 6;
  lanes[7] += 6;
  const Comparison comparison = result();
  ASSERT_EQ(comparison.runs.size(), 1u);
  ASSERT_EQ(comparison.runs[0].changes.size(), 1u);
  EXPECT_EQ(comparison.runs[0].changes[0].figure, "lane_active");
  EXPECT_EQ(comparison.runs[0].changes[0].difference, 12.0);
  EXPECT_EQ(comparison.runs[0].changes[0].relative, 12.0 / 360.0);
}

TEST_F(Compare, MemoryAndSeriesAreCompared) {
  after.report.runs[0].stages[3].memory[0].conflicts = 0;
  after.report.runs[1].series[0].values[1] = 4;
  const Comparison comparison = result();
  ASSERT_EQ(comparison.runs.size(), 2u);
  EXPECT_EQ(find(comparison.runs[0], "Process", "scatter conflicts")->relative, -1.0);
  EXPECT_EQ(find(comparison.runs[1], "", "box_candidates")->relative, 0.25);
}

TEST_F(Compare, CountersOfSourceAndOutputAreCompared) {
  after.report.runs[0].source.counters[3].value = 8;
  after.report.runs[0].source.pieces = 6;
  after.report.runs[1].output.counters[0].value = 5;
  const Comparison comparison = result();
  ASSERT_EQ(comparison.runs.size(), 2u);
  EXPECT_EQ(comparison.runs[0].changes.size(), 2u);
  EXPECT_EQ(find(comparison.runs[0], "Source", "grids")->relative, 1.0);
  EXPECT_EQ(find(comparison.runs[0], "Source", "pieces")->relative, 1.0);
  EXPECT_EQ(comparison.runs[1].changes.size(), 1u);
  EXPECT_EQ(find(comparison.runs[1], "Output", "samples_covered")->relative, -0.5);
}

TEST_F(Compare, FiguresOfOneNameAreComparedEachWithItsOwn) {
  for (Report* report : {&before.report, &after.report}) {
    report->runs[0].series[0].name = "tests";
    report->runs[0].metrics.push_back(
        {"hits", "a ratio of the name of a counter", "hits", "tests"});
  }
  EXPECT_TRUE(result().same());
  after.report.runs[0].series[0].values[1] = 4;
  const Comparison comparison = result();
  ASSERT_EQ(comparison.runs.size(), 1u);
  ASSERT_EQ(comparison.runs[0].changes.size(), 1u);
  EXPECT_EQ(comparison.runs[0].changes[0].before, 4);
  EXPECT_EQ(comparison.runs[0].changes[0].after, 5);
}

TEST_F(Compare, TheToleranceIncludesItself) {
  tests() = 202;
  options.tolerance = 0.01;
  EXPECT_TRUE(result().same());
  EXPECT_EQ(result().runs.size(), 1u) << "is still shown";
  EXPECT_NE(document(result()).text(false).find("1 differ (1 within 1%), "), std::string::npos);
  EXPECT_NE(document(result()).text(false).find("+1% (tolerated)"), std::string::npos);
  tests() = 203;
  EXPECT_FALSE(result().same());
  tests() = 198;
  options.tolerance = 0.0101;  // The metric is 1/99 larger.
  EXPECT_FALSE(result().same());
  options.tolerance = 0.0102;
  EXPECT_TRUE(result().same());
}

TEST_F(Compare, NothingIsWithinAToleranceOfNothing) {
  before.report.runs[0].counters[6].value = 0;  // conflict_invocations
  options.tolerance = 1000.0;
  const Comparison comparison = result();
  EXPECT_FALSE(comparison.same());
  EXPECT_FALSE(comparison.runs[0].changes[0].relative);
  EXPECT_NE(document(comparison).text(false).find("from 0"), std::string::npos);
}

TEST_F(Compare, HashesFailUnlessDifferencesAreTolerated) {
  after.report.runs[3].output.hash = 1;
  EXPECT_FALSE(result().same());
  EXPECT_EQ(result().runs[0].changes[0].figure, "output_hash");
  EXPECT_NE(document(result()).text(false).find("differs\n"), std::string::npos);
  options.tolerance = 1e-6;
  EXPECT_TRUE(result().same());
}

TEST_F(Compare, FiguresOfOneReportOnlyAreDifferences) {
  after.report.runs[0].counters.push_back({"later", "something new", "things", 3});
  after.report.runs[0].stages[3].instructions.pop_back();
  options.tolerance = 1000.0;
  const Comparison comparison = result();
  EXPECT_FALSE(comparison.same());
  EXPECT_TRUE(find(comparison.runs[0], "", "later")->before.is_null());
  EXPECT_TRUE(find(comparison.runs[0], "Process", "scatter issued")->after.is_null());
  const std::string text = document(comparison).text(false);
  EXPECT_NE(text.find("appears"), std::string::npos);
}

TEST_F(Compare, RunsOfOneReportOnlyAreNamed) {
  after.report.runs.erase(after.report.runs.begin());
  set_value(after.report.runs[0].configuration, "seed", std::uint64_t{5});
  const Comparison comparison = result();
  EXPECT_FALSE(comparison.same());
  EXPECT_EQ(comparison.compared, 10u);
  ASSERT_EQ(comparison.only_before.size(), 2u);
  ASSERT_EQ(comparison.only_after.size(), 1u);
  EXPECT_EQ(comparison.only_after[0].run,
            "kernel=repack width_lanes=8 scene=ballroll micropolygon=triangle seed=5");
  EXPECT_NE(document(comparison).text(false).find("\nOnly in b.json:\n  kernel=repack"),
            std::string::npos);
}

TEST_F(Compare, IgnoredParametersMayDiffer) {
  for (RunRecord& run : after.report.runs) set_value(run.configuration, "seed", std::uint64_t{5});
  EXPECT_EQ(result().compared, 0u);
  options.ignored = {"seed"};
  EXPECT_EQ(result().compared, 12u);
  EXPECT_TRUE(result().same());
}

TEST_F(Compare, RunsMatchWhateverTheOrderOfTheirParameters) {
  for (RunRecord& run : after.report.runs) {
    Arguments reversed;
    const auto& all = run.configuration.arguments.all();
    for (auto argument = all.rbegin(); argument != all.rend(); ++argument)
      reversed.set(argument->name, argument->value);
    run.configuration.arguments = reversed;
  }
  EXPECT_EQ(result().compared, 12u);
  EXPECT_TRUE(result().same());
}

/// LOCKSTEP has no stream_load_threshold.
TEST_F(Compare, KernelsAreComparedByWhatBothTake) {
  std::erase_if(before.report.runs,
                [](const RunRecord& run) { return run.configuration.kernel != "lockstep"; });
  std::erase_if(after.report.runs,
                [](const RunRecord& run) { return run.configuration.kernel != "repack"; });
  EXPECT_EQ(result().compared, 0u);
  options.ignored = {"kernel"};
  const Comparison comparison = result();
  EXPECT_EQ(comparison.compared, 6u);
  EXPECT_TRUE(comparison.only_before.empty());
  EXPECT_TRUE(comparison.only_after.empty());
}

std::string complaint(const NamedReport& before, const NamedReport& after,
                      const CompareOptions& options) {
  try {
    compare(before, after, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(Compare, AParameterOfNoRunCannotBeIgnored) {
  options.ignored = {"seeds"};
  const std::string text = complaint(before, after, options);
  EXPECT_EQ(text.rfind("--ignore: 'seeds' is not a parameter of a run in a.json or b.json; use "
                       "kernel, width_lanes, scene, ",
                       0),
            0u)
      << text;
  EXPECT_NE(text.find("; did you mean 'seed'?"), std::string::npos) << text;
  after.report.runs[5].configuration.arguments.set("seeds", std::uint64_t{1});
  EXPECT_EQ(complaint(before, after, options), "") << "one of the reports has it";
}

TEST_F(Compare, WhatIsObservedIsLeftOutIfOtherPiecesWere) {
  for (RunRecord& run : after.report.runs) {
    run.configuration.observe_every = 0;
    run.source.pieces_observed = 0;
    for (StageRecord& stage : run.stages) stage.memory.clear();
  }
  options.ignored = {"observe_every"};
  EXPECT_TRUE(result().same());
}

TEST_F(Compare, RunsThatCannotBeToldApartAreRefused) {
  options.ignored = {"kernel"};
  try {
    result();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "a.json: two runs have the same parameters but for those ignored: width_lanes=8 "
                 "scene=ballroll micropolygon=triangle");
  }
}

TEST_F(Compare, TheSummaryNamesTheLargestChangeThatIsNoDetail) {
  after.report.runs[0].stages[3].instructions[0].issued += 29;  // add: 29; all: 30.
  EXPECT_NE(document(result()).text(false).find("; largest change +96.7% (Process: issued"),
            std::string::npos)
      << document(result()).text(false);
}

TEST_F(Compare, LongListsAreCut) {
  after.report.runs[0].stages[2].instructions[0].issued += 15;
  const Comparison comparison = result();
  const std::size_t all = comparison.runs[0].changes.size();
  ASSERT_GT(all, 2u);
  EXPECT_NE(document(comparison, 2).text(false).find(fmt::format("  ... and {} more\n", all - 2)),
            std::string::npos);
  EXPECT_EQ(document(comparison, 0).text(false).find("more"), std::string::npos);
}

TEST_F(Compare, MarkdownHasTables) {
  tests() = 220;
  EXPECT_NE(document(result()).text(true).find(
                "### kernel=lockstep width\\_lanes=8 scene=ballroll micropolygon=triangle\n\n"
                "| Figure | old | new | change | relative |\n"
                "| --- | ---: | ---: | ---: | ---: |\n"
                "| tests | 200 | 220 | +20 | +10% |\n"),
            std::string::npos);
}

TEST_F(Compare, JsonHasEveryChange) {
  tests() = 220;
  after.report.runs.pop_back();
  const Json json = Json::parse(json_text(document(result(), 1).json()));
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["runs_compared"], 11);
  EXPECT_EQ(json["only_in_old"][0]["kernel"], "repack");
  EXPECT_EQ(json["old"]["report"], "a.json");
  EXPECT_EQ(json["runs"][0]["parameters"]["scene"], "ballroll");
  ASSERT_EQ(json["runs"][0]["changes"].size(), 2u);
  EXPECT_EQ(json["runs"][0]["changes"][0].dump(),
            R"({"stage":null,"figure":"tests","old":200,"new":220,"difference":20.0,)"
            R"("relative":0.1,"within_tolerance":false})");
}

}  // namespace
}  // namespace lanescope
