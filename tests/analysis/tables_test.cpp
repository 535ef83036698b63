// SPDX-License-Identifier: MIT
// Every figure here is computed by hand from the counts in sample_report.h.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/tables/table.h"
#include "analysis/tables/thesis_figures.h"
#include "simulator/base/error.h"
#include "tests/analysis/sample_report.h"

namespace lanescope {
namespace {

const Report& report() {
  static const Report sample = testing::sample_report();
  return sample;
}

TableData table(std::string_view name, const ReportView& view = ReportView(report())) {
  for (const Table* t : tables())
    if (t->name == name) return build_table(*t, view);
  ADD_FAILURE() << "no table " << name;
  return {};
}

/// The first row of that label below the heading (or from the top).
const Row& row(const TableData& data, const std::string& label, const std::string& heading = "") {
  auto at = data.rows.begin();
  if (!heading.empty())
    at = std::find_if(at, data.rows.end(),
                      [&](const Row& r) { return r.label.rfind(heading, 0) == 0; });
  at = std::find_if(at, data.rows.end(), [&](const Row& r) { return r.label == label; });
  static const Row none{"missing", {Cell{{}, {}, "missing"}}};
  EXPECT_NE(at, data.rows.end()) << data.name << " has no row " << label;
  return at == data.rows.end() ? none : *at;
}

std::string cell(const TableData& data, const std::string& label, std::size_t column = 0,
                 const std::string& heading = "") {
  return shown(row(data, label, heading).cells.at(column));
}

TEST(Tables, AverageTheRatiosOfThesisLikeScenes) {
  const TableData data = table("utilization_lockstep_triangle");
  EXPECT_EQ(data.caption, "mean of first, second");
  ASSERT_EQ(data.columns, std::vector<std::string>{"W = 8"});
  EXPECT_EQ(cell(data, "Bound"), "85.0% (0.15)");    // (72/80 + 128/160) / 2, (10 + 20) / 200
  EXPECT_EQ(cell(data, "Test"), "62.5% (0.60)");     // (360/480 + 240/480) / 2
  EXPECT_EQ(cell(data, "Process"), "37.5% (0.25)");  // (60/240 + 80/160) / 2, (.3 + .2) / 2
  EXPECT_EQ(cell(data, "Overall"), "58.8%");         // (492/800 + 448/800) / 2
  EXPECT_EQ(cell(data, "Instr./mp"), "7.50");        // (100/20 + 100/10) / 2
}

TEST(Tables, KeepSetupInRowsOfItsOwn) {
  const TableData data = table("utilization_lockstep_triangle");
  EXPECT_EQ(cell(data, "Setup *"), "75.0% (0.02)");  // (16/16 + 12/24) / 2, (2/102 + 3/103) / 2
  EXPECT_EQ(cell(data, "Overall *"), "59.0%");       // (508/816 + 460/824) / 2
  EXPECT_EQ(cell(data, "Instr./mp *"), "7.70");      // (102/20 + 103/10) / 2
  EXPECT_FALSE(row(data, "Setup *").cells[0].figure->thesis);
}

TEST(Tables, StandBesideTheThesis) {
  const TableData data = table("utilization_lockstep_triangle");
  const Figure& bound = *row(data, "Bound").cells[0].figure;
  EXPECT_EQ(shown_thesis(bound), "98%");
  EXPECT_EQ(shown_difference(bound), "-13");
  const Figure& share = *row(data, "Bound").cells[0].share;
  EXPECT_EQ(shown_thesis(share), "0.10");
  const Figure& instructions = *row(data, "Instr./mp").cells[0].figure;
  EXPECT_EQ(shown_thesis(instructions), "61.94");
  EXPECT_EQ(shown_difference(instructions), "-88%");  // 7.5 / 61.94
}

TEST(Tables, OfOneSceneByItself) {
  const TableData data = table("utilization_lockstep_triangle", ReportView(report(), "second"));
  EXPECT_EQ(data.caption, "second");
  EXPECT_EQ(cell(data, "Bound"), "80.0% (0.20)");
  EXPECT_EQ(cell(data, "Instr./mp"), "10.00");
}

TEST(Tables, AreUndefinedWhereAStageIsMissing) {
  const TableData data = table("utilization_lockstep_triangle", ReportView(report(), "third"));
  EXPECT_EQ(cell(data, "Process"), "n/a (n/a)");
  EXPECT_EQ(cell(data, "Test"), "100.0% (0.50)");
}

TEST(Tables, StreamLoadIsAStageOfRepack) {
  const TableData data = table("utilization_repack_triangle");
  EXPECT_EQ(cell(data, "Test Stream-load"), "20.0% (0.16)");  // both 20%; (20/100 + 10/80) / 2
  EXPECT_EQ(shown_thesis(*row(data, "Test Stream-load").cells[0].figure), "20%");
}

TEST(Tables, QuadsHaveTheirOwn) {
  EXPECT_EQ(cell(table("utilization_lockstep_quad"), "Instr./mp"), "12.00");  // 7.5 * .8 * 2
  EXPECT_EQ(cell(table("utilization_repack_quad"), "Test Stream-load"),
            "19.1% (0.16)");  // (25/128 + 12/64) / 2
}

TEST(Tables, OverheadIsOfTheStagesOwnInstructions) {
  const TableData data = table("overhead");
  EXPECT_EQ(cell(data, "Bound"), "15.0%");  // (2/10 + 2/20) / 2
  EXPECT_EQ(cell(data, "Test Stream-load"), "100.0%");
  EXPECT_EQ(cell(data, "Test"), "25.0%");
  EXPECT_EQ(cell(data, "Process", 1), "30.0%");  // The mean over the one width.
  EXPECT_EQ(shown_thesis(*row(data, "Process").cells[1].figure), "35%");
}

TEST(Tables, QuadsAgainstTriangles) {
  const TableData data = table("quads_vs_triangles");
  EXPECT_EQ(data.rows[0].label,
            "Triangles: STE 20.0% (thesis 19%), 0.00 M micropolygons (thesis 5.50 M)");
  EXPECT_EQ(cell(data, "Bound"), "1.2");  // (10/20 + 20/10) / 2 = 1.25, to even
  EXPECT_EQ(cell(data, "Total", 0, "Quads: "), "12.0");
  EXPECT_EQ(cell(data, "Total", 0, "Quads against"), "1.60x");
}

TEST(Tables, TotalInstructionsAreOfEachScene) {
  const TableData data = table("total_instructions");
  EXPECT_EQ(data.title, "Figure 4.2: LOCKSTEP, W = 8: instructions of each scene");
  EXPECT_EQ(cell(data, "first, triangles", 3), "0.00 M (1.00)");
  EXPECT_EQ(cell(data, "first, quads", 3), "0.00 M (0.80)");
  EXPECT_EQ(cell(data, "second, triangles", 1), "0.00 M (0.60)");
}

TEST(Tables, SampleTestsDescribeTheScenes) {
  const TableData data = table("sample_tests");
  EXPECT_EQ(data.columns, (std::vector<std::string>{"first", "second", "Mean"}));
  EXPECT_EQ(cell(data, "STE", 2), "20.0%");
  EXPECT_EQ(cell(data, "STE", 2, "Quads"), "30.0%");
  EXPECT_EQ(cell(data, "Facing away", 0), "50.0%");
  EXPECT_EQ(cell(data, "Hits/covered sample", 0), "4.00");  // 40 / 10
}

TEST(Tables, WorkingSetIsOverTheWidth) {
  const TableData data = table("working_set");
  EXPECT_EQ(cell(data, "Average, triangles"), "3.50 W");  // 280 / 10 / 8
  EXPECT_EQ(cell(data, "Maximum, triangles"), "4.00 W");
  EXPECT_EQ(shown_difference(*row(data, "Maximum, triangles").cells[0].figure), "+0.0");
}

TEST(Tables, ConflictsNameTheirDenominators) {
  const TableData data = table("conflicts");
  EXPECT_EQ(cell(data, "lockstep, triangles", 0, "Of all invocations"), "4.000%");  // 2 / 50
  EXPECT_EQ(cell(data, "lockstep, triangles", 0, "Of all hits"), "3.750%");  // (1/40 + 1/20) / 2
}

TEST(Tables, ClaimsAreCheckedAtTheirWidth) {
  const TableData data = table("claims");
  EXPECT_EQ(cell(data, "REPACK overtakes, triangles"),
            "up to W = 8 (thesis: between W = 32 and 64)");
  EXPECT_EQ(cell(data, "REPACK overtakes, triangles", 1), "no");
  EXPECT_EQ(cell(data, "STE, quads / triangles"), "1.50x");
  EXPECT_EQ(cell(data, "STE, quads / triangles", 1), "yes");
  EXPECT_EQ(cell(data, "As table 4.2 implies, W = 8"), "80.1%");  // (488/640 + 336/400) / 2
  EXPECT_EQ(cell(data, "Instructions saved, lockstep"), "n/a");   // There is no W = 16.
  EXPECT_EQ(cell(data, "Instructions saved, lockstep", 1), "n/a");
}

TEST(Tables, DeviationIsOfRoundedPercents) {
  const TableData data = table("deviation");
  // 85 - 98, 63 - 83 (62.5 rounds away from zero), 38 - 25.
  EXPECT_EQ(cell(data, "Stages of 4.1", 0), "3");
  EXPECT_EQ(cell(data, "Stages of 4.1", 1), "20.00");
  EXPECT_EQ(cell(data, "Stages of 4.1", 2), "15.68");  // sqrt((169 + 400 + 169) / 3)
  EXPECT_EQ(cell(data, "Stages of 4.1", 3), "15.76");  // sqrt((169 + 420.25 + 156.25) / 3)
  EXPECT_EQ(cell(data, "Stages of 4.1", 4), "Test at W = 8 of 4.1");
}

TEST(Tables, OfAnEmptyReportAreUndefined) {
  const Report empty;
  for (const Table* t : tables()) {
    SCOPED_TRACE(t->name);
    const TableData data = build_table(*t, ReportView(empty));
    for (const Row& r : data.rows)
      for (const Cell& c : r.cells)
        EXPECT_FALSE(c.figure && c.figure->unit != &kCount && c.figure->ours) << r.label;
  }
}

TEST(Tables, HaveACellForEachColumn) {
  for (const Table* t : tables()) {
    const TableData data = table(t->name);
    for (const Row& r : data.rows)
      EXPECT_TRUE(r.cells.empty() || r.cells.size() == data.columns.size())
          << t->name << ": " << r.label;
  }
}

TEST(ReportView, RefusesTwoRunsOfOneKind) {
  Report twice = testing::sample_report();
  twice.runs.push_back(twice.runs.front());
  try {
    ReportView view(twice);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "report: has two runs of lockstep on first, W = 8, triangle; a table needs one");
  }
}

TEST(ReportView, SuggestsASceneItHas) {
  try {
    ReportView view(report(), "secund");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "report: has no run of the scene 'secund'; did you mean 'second'?");
  }
}

TEST(Ratio, HasNoValueOverZero) {
  EXPECT_FALSE((Ratio{3, 0}.value()));
  EXPECT_EQ((Ratio{3, 4}.value()), 0.75);
}

}  // namespace
}  // namespace lanescope
