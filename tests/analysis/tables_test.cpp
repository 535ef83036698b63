// SPDX-License-Identifier: MIT
// Tables of any report. Every figure here is computed by hand from the counts in sample_report.h.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/formats/format.h"
#include "analysis/report/figures.h"
#include "analysis/tables/run_summary.h"
#include "analysis/tables/series_rows.h"
#include "analysis/tables/table.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

const std::string kLockstep = "LOCKSTEP, micropolygon = triangle";
const std::string kRepack = "REPACK, micropolygon = triangle";

const Report& report() {
  static const Report sample = testing::sample_report();
  return sample;
}

/// Of the two scenes in which every stage was run.
ReportView two_scenes() {
  return ReportView(report(), std::vector<std::string>{"ballroll", "columnpivot"});
}

TableData table(std::string_view name, const ReportView& view = two_scenes()) {
  for (const Table* t : tables())
    if (t->name == name) return build_table(*t, view);
  ADD_FAILURE() << "no table " << name;
  return {};
}

/// The cell of the row of that label below the heading.
std::string cell(const TableData& data, const std::string& heading, const std::string& label,
                 std::size_t column = 0) {
  auto at = std::find_if(data.rows.begin(), data.rows.end(),
                         [&](const Row& r) { return r.label == heading; });
  at = std::find_if(at, data.rows.end(), [&](const Row& r) { return r.label == label; });
  EXPECT_NE(at, data.rows.end()) << data.name << " has no row " << label;
  return at == data.rows.end() ? "missing" : shown(at->cells.at(column));
}

bool has_row(const TableData& data, const std::string& label) {
  return std::any_of(data.rows.begin(), data.rows.end(),
                     [&](const Row& r) { return r.label == label; });
}

TEST(Tables, UtilizationIsTheMeanOfTheScenesRatios) {
  const TableData data = table("utilization");
  EXPECT_EQ(data.caption, "mean of ballroll, columnpivot");
  EXPECT_EQ(data.setting, "resolution = 1728x1080, msaa = 4, frame = 0, cull = on");
  ASSERT_EQ(data.columns, std::vector<std::string>{"W = 8"});
  EXPECT_EQ(cell(data, kLockstep, "Setup"), "75.0% (0.02)");         // (16/16 + 12/24) / 2
  EXPECT_EQ(cell(data, kLockstep, "Bound"), "85.0% (0.15)");         // (10/102 + 20/103) / 2
  EXPECT_EQ(cell(data, kLockstep, "Test"), "62.5% (0.59)");          // (60/102 + 60/103) / 2
  EXPECT_EQ(cell(data, kLockstep, "Process"), "37.5% (0.24)");       // (30/102 + 20/103) / 2
  EXPECT_EQ(cell(data, kLockstep, "Overall, all stages"), "59.0%");  // (508/816 + 460/824) / 2
  EXPECT_EQ(cell(data, kRepack, "Test Stream-load"), "20.0% (0.16)");
}

TEST(Tables, ShowEachKernelOnEachFacet) {
  const TableData data = table("utilization");
  std::vector<std::string> headings;
  for (const Row& row : data.rows)
    if (row.cells.empty()) headings.push_back(row.label);
  EXPECT_EQ(headings, (std::vector<std::string>{kLockstep, "LOCKSTEP, micropolygon = quad", kRepack,
                                                "REPACK, micropolygon = quad"}));
}

TEST(Tables, InstructionsAreOfEachElement) {
  const TableData data = table("instructions");
  EXPECT_EQ(cell(data, kLockstep, "Test"), "4.50");                        // (60/20 + 60/10) / 2
  EXPECT_EQ(cell(data, kLockstep, "Instr./mp, all stages"), "7.70");       // (102/20 + 103/10) / 2
  EXPECT_EQ(cell(data, "LOCKSTEP, micropolygon = quad", "Test"), "7.20");  // (48/10 + 48/5) / 2
}

TEST(Tables, OverheadIsOfTheStagesOwnInstructions) {
  const TableData data = table("overhead");
  EXPECT_EQ(cell(data, kRepack, "Bound"), "15.0%");  // (2/10 + 2/20) / 2
  EXPECT_EQ(cell(data, kRepack, "Test Stream-load"), "100.0%");
  EXPECT_EQ(cell(data, kRepack, "Test"), "25.0%");
  EXPECT_EQ(cell(data, kRepack, "Overall, all stages"), "34.6%");  // (41/102 + 24/83) / 2
  EXPECT_FALSE(has_row(data, kLockstep));
}

TEST(Tables, MixIsByClass) {
  const TableData data = table("mix", ReportView(report(), "ballroll"));
  EXPECT_EQ(cell(data, kLockstep, "arithmetic"), "5.05 (0.99)");  // 101/20, 101/102
  EXPECT_EQ(cell(data, kLockstep, "memory"), "0.05 (0.01)");      // The scatter of Process.
}

TEST(Tables, MemoryIsOfOneExecution) {
  const TableData data = table("memory");
  EXPECT_EQ(cell(data, kLockstep, "Process: scatter"), "1.00");
  EXPECT_EQ(cell(data, kLockstep, "Process: scatter, conflicts"), "62.500%");  // (1/2 + 3/4) / 2
}

TEST(Tables, MetricsAndCountersAreTheKernels) {
  EXPECT_EQ(cell(table("metrics"), kLockstep, "ste"), "0.2000");
  EXPECT_EQ(cell(table("counters"), kLockstep, "tests"), "150");  // (200 + 100) / 2
  EXPECT_EQ(cell(table("counters"), kRepack, "working_set_maximum"), "32");
  EXPECT_FALSE(has_row(table("counters", ReportView(report(), "ballroll")), "no_such_counter"));
}

TEST(Tables, SeriesAreAddedUpPlaceByPlace) {
  const TableData data = table("series");
  EXPECT_EQ(data.caption, "ballroll, columnpivot");
  const std::string heading = kRepack + ", W = 8";
  EXPECT_EQ(cell(data, heading, "box_candidates", 0), "3");
  EXPECT_EQ(cell(data, heading, "box_candidates", 1), "8");  // 2 x (0 + 3 + 1)
  EXPECT_EQ(cell(data, heading, "box_candidates", 2), "6");
  EXPECT_EQ(cell(data, heading, "box_candidates", 3), "1");
}

TEST(Tables, AreUndefinedWhereASceneLacksAStage) {
  EXPECT_EQ(cell(table("utilization", ReportView(report())), kLockstep, "Process"), "n/a (n/a)");
}

TEST(Tables, WithoutFiguresAreLeftOut) {
  const Report empty;
  EXPECT_TRUE(build_tables(tables(), ReportView(empty)).empty());
  Report uncounted = testing::sample_report();
  for (RunRecord& run : uncounted.runs) run.stages.clear();
  std::vector<std::string> names;
  for (const TableData& data : build_tables(tables(), ReportView(uncounted)))
    names.push_back(data.name);
  EXPECT_EQ(names, (std::vector<std::string>{"metrics", "counters", "series"}));
}

TEST(Tables, HaveACellForEachColumn) {
  Report wide = testing::sample_report();
  RunRecord other = wide.runs.front();
  other.configuration.width = 3;
  wide.runs.push_back(other);
  for (const Table* t : tables()) {
    const TableData data = table(t->name, ReportView(wide, "ballroll"));
    EXPECT_FALSE(data.rows.empty()) << t->name;
    for (const Row& r : data.rows)
      EXPECT_TRUE(r.cells.empty() || r.cells.size() == data.columns.size())
          << t->name << ": " << r.label;
  }
}

/// Kernels of another kind of work beside them change no mean, and have their own.
TEST(Tables, EachKindOfWorkHasItsOwnScenes) {
  Report both = testing::sample_report();
  RunRecord other = both.runs.front();
  other.configuration = {};
  other.configuration.kernel = "unheard-of";
  other.configuration.scene = "elsewhere";
  other.configuration.width = 8;
  other.workload = "others";
  other.element = {"micropolygons_rasterized", "other", "o"};
  both.runs.push_back(other);
  const TableData data =
      table("instructions",
            ReportView(both, std::vector<std::string>{"ballroll", "columnpivot", "elsewhere"}));
  EXPECT_EQ(cell(data, kLockstep, "Instr./mp, all stages"), "7.70");
  EXPECT_EQ(cell(data, "UNHEARD-OF", "Instr./o, all stages"), "5.10");  // 102/20
}

TEST(RunSummary, IsATableForEachKernelSceneAndFacet) {
  Report one = testing::sample_report();
  one.runs.resize(2);
  const std::vector<TableData> tables = run_summaries(one);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(find_format("text").write({tables.front()}),
            "lockstep on ballroll, micropolygon = triangle\n"
            "Of: resolution = 1728x1080, msaa = 4, frame = 0, cull = on\n"
            "\n"
            "                                  W = 8\n"
            "---------------------------------------\n"
            "Utilization (share of the instructions of all stages)\n"
            "Setup                     100.0% (0.02)\n"
            "Bound                      90.0% (0.10)\n"
            "Test                       75.0% (0.59)\n"
            "Process                    25.0% (0.29)\n"
            "Overall, all stages               62.3%\n"
            "Instructions for each element\n"
            "Instr./mp, all stages              5.10\n"
            "Metrics\n"
            "ste                              0.2000\n"
            "Counts\n"
            "micropolygons_seen                   40\n"
            "micropolygons_culled                 20\n"
            "micropolygons_rasterized             20\n"
            "tests                               200\n"
            "hits                                 40\n"
            "process_issued                       50\n"
            "conflict_invocations                  2\n"
            "conflict_hits                         1\n"
            "Counts in the output\n"
            "samples_covered                      10\n");
}

/// What was not counted is not shown as 0.
TEST(RunSummary, OfAnUncountedRunIsOfItsOutputAlone) {
  Report one = testing::sample_report();
  one.runs.resize(1);
  RunRecord& run = one.runs.front();
  run.configuration.mode = Mode::kUncounted;
  run.stages.clear();
  run.counters.clear();
  run.metrics.clear();
  EXPECT_EQ(find_format("text").write(run_summaries(one)),
            "lockstep on ballroll, micropolygon = triangle\n"
            "Of: resolution = 1728x1080, msaa = 4, frame = 0, cull = on\n"
            "\n"
            "                 W = 8\n"
            "----------------------\n"
            "Counts in the output\n"
            "samples_covered     10\n"
            "\n"
            "Nothing was counted while the kernel ran (mode uncounted).\n");
}

TEST(RunSummary, SaysWhatIsNotAsByDefault) {
  Report one = testing::sample_report();
  one.runs.resize(1);
  RunRecord& run = one.runs.front();
  set_value(run.configuration, "width_px", std::uint64_t{480});
  set_value(run.configuration, "edges", std::string("precomputed"));
  EXPECT_EQ(run_summaries(one).front().setting,
            "resolution = 480x1080, msaa = 4, frame = 0, cull = on, edges = precomputed");
  one.runs.push_back(run);
  set_value(one.runs.back().configuration, "width_lanes", std::uint64_t{16});
  EXPECT_EQ(run_summaries(one).size(), 1u);
  set_value(one.runs.back().configuration, "edges", std::string("inline"));
  EXPECT_EQ(run_summaries(one).size(), 2u);
}

std::string complaint_of(const Report& twice) {
  try {
    ReportView view(twice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ReportView, RefusesTwoRunsOfOneKindAndNamesWhatDiffers) {
  Report twice = testing::sample_report();
  twice.runs.push_back(twice.runs.front());
  EXPECT_EQ(complaint_of(twice),
            "report: has two runs of lockstep on ballroll at W = 8 that have the same parameters; "
            "a table needs one");
  set_value(twice.runs.back().configuration, "edges", std::string("precomputed"));
  EXPECT_EQ(complaint_of(twice),
            "report: has two runs of lockstep on ballroll at W = 8 that differ in edges (inline, "
            "precomputed); a table needs one");
  set_value(twice.runs.back().configuration, "samples_per_pixel", std::uint64_t{16});
  EXPECT_EQ(complaint_of(twice),
            "report: has two runs of lockstep on ballroll at W = 8 that differ in "
            "samples_per_pixel (4, 16) and edges (inline, precomputed); a table needs one");
}

TEST(ReportView, SuggestsASceneItHas) {
  try {
    ReportView view(report(), "balroll");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "report: has no run of the scene 'balroll'; did you mean 'ballroll'?");
  }
}

TEST(ReportView, AveragesAllScenesUnlessAsked) {
  EXPECT_EQ(ReportView(report()).caption(), "mean of ballroll, columnpivot, teapot");
  EXPECT_EQ(scenes_of(report(), {"teapot", "talking"}), std::vector<std::string>{"teapot"});
  EXPECT_EQ(scenes_of(report(), {"talking"}), scenes_of(report()));
}

TEST(ReportView, StatesTheSettingOfItsScenes) {
  Report two = report();
  EXPECT_EQ(ReportView(two).setting(), "resolution = 1728x1080, msaa = 4, frame = 0, cull = on");
  for (RunRecord& run : two.runs)
    if (run.configuration.scene == "ballroll") {
      set_value(run.configuration, "frame", std::uint64_t{3});
      set_value(run.configuration, "seed", std::uint64_t{7});
    }
  // Each scene has its own frame; what is special in some has its other values, too.
  EXPECT_EQ(ReportView(two).setting(),
            "resolution = 1728x1080, msaa = 4, cull = on, seed = 7 and 1");
  EXPECT_EQ(ReportView(two, "teapot").setting(),
            "resolution = 1728x1080, msaa = 4, frame = 0, cull = on");
  EXPECT_EQ(ReportView(two, "ballroll").setting(),
            "resolution = 1728x1080, msaa = 4, frame = 3, cull = on, seed = 7");
}

TEST(ReportView, ListsSeriesInTheOrderOfKernelsAndChoices) {
  Report turned = testing::sample_report();
  std::reverse(turned.runs.begin(), turned.runs.end());
  EXPECT_EQ(series_of(turned), (std::vector<Series>{{"repack", "triangle"},
                                                    {"repack", "quad"},
                                                    {"lockstep", "triangle"},
                                                    {"lockstep", "quad"}}));
}

TEST(Ratio, HasNoValueOverZero) {
  EXPECT_FALSE((Ratio{3, 0}.value()));
  EXPECT_EQ((Ratio{3, 4}.value()), 0.75);
}

}  // namespace
}  // namespace lanescope
