// SPDX-License-Identifier: MIT
// Every figure here is computed by hand from the counts in sample_report.h; see sample_of_study.h.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/studies/luong/figures.h"
#include "analysis/studies/luong/study.h"
#include "tests/analysis/studies/luong/sample_of_study.h"

namespace lanescope::luong {
namespace {

const Report& report() {
  static const Report sample = sample_of_study();
  return sample;
}

/// The sample with a parameter of all runs set.
Report with(std::string_view parameter, const Value& value) {
  Report changed = report();
  for (RunRecord& run : changed.runs) set_value(run.configuration, parameter, value);
  return changed;
}

TableData table(std::string_view name, const ReportView& view = view_of(study_luong, report())) {
  for (const Table* t : luong_tables())
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

TEST(LuongTables, AverageTheRatiosOfTheStudysScenes) {
  const TableData data = table("utilization_lockstep_triangle");
  EXPECT_EQ(data.caption, "mean of ballroll, columnpivot, tigerjump, talking");
  EXPECT_EQ(data.setting, "resolution = 1728x1080, msaa = 4, frame = 0, cull = on");
  ASSERT_EQ(data.columns, std::vector<std::string>{"W = 8"});
  EXPECT_EQ(cell(data, "Bound"), "85.0% (0.15)");    // (72/80 + 128/160) / 2, (10 + 20) / 200
  EXPECT_EQ(cell(data, "Test"), "62.5% (0.60)");     // (360/480 + 240/480) / 2
  EXPECT_EQ(cell(data, "Process"), "37.5% (0.25)");  // (60/240 + 80/160) / 2, (.3 + .2) / 2
  EXPECT_EQ(cell(data, "Overall, without Setup"), "58.8%");   // (492/800 + 448/800) / 2
  EXPECT_EQ(cell(data, "Instr./mp, without Setup"), "7.50");  // (100/20 + 100/10) / 2
}

TEST(LuongTables, KeepSetupInRowsOfItsOwn) {
  const TableData data = table("utilization_lockstep_triangle");
  EXPECT_EQ(cell(data, "Setup *"), "75.0% (0.02)");  // (16/16 + 12/24) / 2, (2/102 + 3/103) / 2
  EXPECT_EQ(cell(data, "Overall, all stages"), "59.0%");   // (508/816 + 460/824) / 2
  EXPECT_EQ(cell(data, "Instr./mp, all stages"), "7.70");  // (102/20 + 103/10) / 2
  EXPECT_FALSE(row(data, "Setup *").cells[0].figure->paper);
}

TEST(LuongTables, StandBesideTheThesis) {
  const TableData data = table("utilization_lockstep_triangle");
  const Figure& bound = *row(data, "Bound").cells[0].figure;
  EXPECT_EQ(shown_paper(bound), "98%");
  EXPECT_EQ(shown_difference(bound), "-13");
  const Figure& share = *row(data, "Bound").cells[0].share;
  EXPECT_EQ(shown_paper(share), "0.10");
  EXPECT_EQ(shown_difference(share), "+5");
  EXPECT_EQ(shown_paper(row(data, "Bound").cells[0]), "98% (0.10)");
  EXPECT_EQ(shown_difference(row(data, "Bound").cells[0]), "-13 (+5)");
  const Figure& instructions = *row(data, "Instr./mp, without Setup").cells[0].figure;
  EXPECT_EQ(shown_paper(instructions), "61.94");
  EXPECT_EQ(shown_difference(instructions), "-88%");  // 7.5 / 61.94
}

TEST(LuongTables, OfOneSceneByItself) {
  const TableData data =
      table("utilization_lockstep_triangle", ReportView(report(), "columnpivot"));
  EXPECT_EQ(data.caption, "columnpivot");
  EXPECT_EQ(cell(data, "Bound"), "80.0% (0.20)");
  EXPECT_EQ(cell(data, "Instr./mp, without Setup"), "10.00");
}

TEST(LuongTables, AreUndefinedWhereAStageIsMissing) {
  const TableData data = table("utilization_lockstep_triangle", ReportView(report(), "teapot"));
  EXPECT_EQ(cell(data, "Process"), "n/a (n/a)");
  EXPECT_EQ(cell(data, "Test"), "100.0% (0.50)");
}

TEST(LuongTables, StreamLoadIsAStageOfRepack) {
  const TableData data = table("utilization_repack_triangle");
  EXPECT_EQ(cell(data, "Test Stream-load"), "20.0% (0.16)");  // both 20%; (20/100 + 10/80) / 2
  EXPECT_EQ(shown_paper(*row(data, "Test Stream-load").cells[0].figure), "20%");
}

TEST(LuongTables, QuadsHaveTheirOwn) {
  EXPECT_EQ(cell(table("utilization_lockstep_quad"), "Instr./mp, without Setup"),
            "12.00");  // 7.5 * .8 * 2
  EXPECT_EQ(cell(table("utilization_repack_quad"), "Test Stream-load"),
            "19.1% (0.16)");  // (25/128 + 12/64) / 2
}

TEST(LuongTables, OverheadIsOfTheStagesOwnInstructions) {
  const TableData data = table("overhead");
  EXPECT_EQ(cell(data, "Bound"), "15.0%");  // (2/10 + 2/20) / 2
  EXPECT_EQ(cell(data, "Test Stream-load"), "100.0%");
  EXPECT_EQ(cell(data, "Test"), "25.0%");
  EXPECT_EQ(cell(data, "Process", 1), "30.0%");  // The mean over the one width.
  EXPECT_EQ(shown_paper(*row(data, "Process").cells[1].figure), "35%");
}

TEST(LuongTables, QuadsAgainstTriangles) {
  const TableData data = table("quads_vs_triangles");
  EXPECT_EQ(data.rows[0].label,
            "Triangles: STE 20.0% (thesis 19%), 0.00 M micropolygons (thesis 5.50 M)");
  EXPECT_EQ(cell(data, "Bound"), "1.2");  // (10/20 + 20/10) / 2 = 1.25, to even
  EXPECT_EQ(cell(data, "Total, without Setup", 0, "Quads: "), "12.0");
  EXPECT_EQ(cell(data, "Total, without Setup", 0, "Quads against"), "1.60x");
}

TEST(LuongTables, TotalInstructionsAreOfEachScene) {
  const TableData data = table("total_instructions");
  EXPECT_EQ(data.title, "Figure 4.2: LOCKSTEP, W = 8: instructions of each scene");
  EXPECT_EQ(cell(data, "ballroll, triangles", 3), "0.00 M (1.00)");
  EXPECT_EQ(cell(data, "ballroll, quads", 3), "0.00 M (0.80)");
  EXPECT_EQ(cell(data, "columnpivot, triangles", 1), "0.00 M (0.60)");
}

TEST(LuongTables, SampleTestsDescribeTheScenes) {
  const TableData data = table("sample_tests");
  EXPECT_EQ(data.columns,
            (std::vector<std::string>{"ballroll", "columnpivot", "tigerjump", "talking", "Mean"}));
  EXPECT_EQ(cell(data, "STE", 4), "20.0%");
  EXPECT_EQ(cell(data, "STE", 4, "Quads"), "30.0%");
  EXPECT_EQ(cell(data, "Facing away", 0), "50.0%");
  EXPECT_EQ(cell(data, "Hits/covered sample", 0), "4.00");  // 40 / 10
}

TEST(LuongTables, WorkingSetIsOverTheWidth) {
  const TableData data = table("working_set");
  EXPECT_EQ(cell(data, "Average, triangles"), "3.50 W");  // 280 / 10 / 8
  EXPECT_EQ(cell(data, "Maximum, triangles"), "4.00 W");
  EXPECT_EQ(shown_difference(*row(data, "Maximum, triangles").cells[0].figure), "+0.0");
}

TEST(LuongTables, ConflictsNameTheirDenominators) {
  const TableData data = table("conflicts");
  EXPECT_EQ(cell(data, "lockstep, triangles", 0, "Of all invocations"), "4.000%");  // 2 / 50
  EXPECT_EQ(cell(data, "lockstep, triangles", 0, "Of all hits"), "3.750%");  // (1/40 + 1/20) / 2
}

TEST(LuongTables, ClaimsAreCheckedAtTheirWidth) {
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

TEST(LuongTables, LarrabeeUnitsAreOfInstructionsAndOfSlots) {
  Report wide = report();
  for (RunRecord& run : wide.runs) run.configuration.width = 16;
  const TableData data = table("larrabee_units", view_of(study_luong, wide));
  const auto figure = [&](std::size_t place, std::size_t column) {
    return data.rows.at(place).cells.at(column).figure->ours.value_or(-1);
  };
  // A hundred instructions a frame, of a slot each: one is a scatter to one line.
  EXPECT_EQ(data.rows[1].label, "LOCKSTEP, triangles");
  EXPECT_NEAR(figure(1, 0), 100 * 60, 1e-6);
  EXPECT_NEAR(figure(1, 1), 6000 / 1.1e9, 1e-15);
  EXPECT_NEAR(figure(1, 2), 100 * 60, 1e-6);
  // Half of all micropolygons are culled.
  EXPECT_EQ(data.rows[6].label, "LOCKSTEP, triangles");
  EXPECT_NEAR(figure(6, 0), 2 * 6000, 1e-6);
  EXPECT_NEAR(figure(6, 3), 2 * 6000 / 1.1e9, 1e-15);
}

TEST(LuongTables, DeviationIsOfRoundedPercents) {
  const TableData data = table("deviation");
  // 85 - 98, 63 - 83 (62.5 rounds away from zero), 38 - 25.
  EXPECT_EQ(cell(data, "Stages of 4.1", 0), "3");
  EXPECT_EQ(cell(data, "Stages of 4.1", 1), "20.00");
  EXPECT_EQ(cell(data, "Stages of 4.1", 2), "15.68");  // sqrt((169 + 400 + 169) / 3)
  EXPECT_EQ(cell(data, "Stages of 4.1", 3), "15.76");  // sqrt((169 + 420.25 + 156.25) / 3)
  EXPECT_EQ(cell(data, "Stages of 4.1", 4), "Test at W = 8 of 4.1");
  // Shares: 15 - 10, 60 - 68, 25 - 23.
  EXPECT_EQ(cell(data, "Shares of 4.1", 0), "3");
  EXPECT_EQ(cell(data, "Shares of 4.1", 1), "8.00");
  EXPECT_EQ(cell(data, "Shares of 4.1", 2), "5.57");  // sqrt((25 + 64 + 4) / 3)
  EXPECT_EQ(cell(data, "Shares of 4.1", 4), "Test at W = 8 of 4.1");
  EXPECT_EQ(cell(data, "Shares, triangles", 0), "7");
}

/// The last of the notes.
std::string reason(const TableData& data) { return data.notes.empty() ? "" : data.notes.back(); }

TEST(LuongTables, CompareWithNothingThatIsNotTheThesiss) {
  const Report small = with("width_px", std::uint64_t{64});
  const TableData data = table("utilization_lockstep_triangle", view_of(study_luong, small));
  EXPECT_EQ(reason(data),
            "Not comparable with the thesis: resolution is 64x1080 (thesis: 1728x1080).");
  const Cell& bound = row(data, "Bound").cells[0];
  EXPECT_EQ(shown(bound), "85.0% (0.15)");
  EXPECT_EQ(shown_paper(bound), "not comparable");
  EXPECT_EQ(shown_difference(bound), "");
}

TEST(LuongTables, NameEachSettingThatIsNotTheThesiss) {
  const auto reason_of = [](std::string_view parameter, const Value& value) {
    const Report changed = with(parameter, value);
    return reason(table("overhead", view_of(study_luong, changed)));
  };
  const std::string begin = "Not comparable with the thesis: ";
  EXPECT_EQ(reason_of("samples_per_pixel", std::uint64_t{16}), begin + "msaa is 16 (thesis: 4).");
  EXPECT_EQ(reason_of("cull_backfaces", false), begin + "backface culling is off (thesis: on).");
  EXPECT_EQ(reason_of("dice_area_px", 2.0f), begin + "quad area px is 2.0 (thesis: 1.0).");
}

/// Where nothing of the thesis stands, there is nothing to say.
TEST(LuongTables, WithoutFiguresOfTheThesisSayNothingOfIt) {
  const Report small = with("width_px", std::uint64_t{64});
  EXPECT_EQ(table("total_instructions", view_of(study_luong, small)).notes.size(), 1u);
}

/// What the thesis does not say is ours to choose.
TEST(LuongTables, CompareWhatTheThesisLeavesOpen) {
  const Report turned = with("turn_degrees", 12.0f);
  const TableData data = table("overhead", view_of(study_luong, turned));
  EXPECT_EQ(shown_difference(row(data, "Process").cells[1]), "-5");  // 30 - 35.
  EXPECT_EQ(data.setting, "resolution = 1728x1080, msaa = 4, frame = 0, turn = 12, cull = on");
}

TEST(LuongTables, CompareNoSceneAlone) {
  const TableData data = table("sample_tests", ReportView(report(), "ballroll"));
  EXPECT_EQ(shown_paper(row(data, "STE").cells[0]), "not comparable");
  EXPECT_EQ(reason(data),
            "Not comparable with the thesis: scenes: ballroll (thesis: the mean of its four, for "
            "which ballroll, columnpivot, tigerjump, talking stand in).");
}

TEST(LuongTables, JudgeNoClaimByAnotherSetting) {
  const Report small = with("height_px", std::uint64_t{40});
  const ReportView view = view_of(study_luong, small);
  for (const Row& r : table("claims", view).rows) {
    EXPECT_TRUE(r.cells.empty() || r.cells.back().words == "not comparable") << r.label;
  }
  for (const Row& r : table("deviation", view).rows) {
    EXPECT_EQ(r.cells.back().words, "not comparable") << r.label;
    EXPECT_FALSE(r.cells.front().figure) << r.label;
  }
  EXPECT_EQ(table("quads_vs_triangles", view).rows[0].label,
            "Triangles: STE 20.0%, 0.00 M micropolygons");
}

TEST(LuongTables, OfAnEmptyReportAreUndefined) {
  const Report empty;
  for (const Table* t : luong_tables()) {
    SCOPED_TRACE(t->name);
    const TableData data = build_table(*t, ReportView(empty));
    for (const Row& r : data.rows)
      for (const Cell& c : r.cells)
        EXPECT_FALSE(c.figure && c.figure->unit != &kCount && c.figure->ours) << r.label;
  }
}

TEST(LuongTables, HaveACellForEachColumn) {
  for (const Table* t : luong_tables()) {
    const TableData data = table(t->name);
    for (const Row& r : data.rows)
      EXPECT_TRUE(r.cells.empty() || r.cells.size() == data.columns.size())
          << t->name << ": " << r.label;
  }
}

/// With all of its scenes if it has none of the thesis's.
TEST(LuongTables, OfOtherScenesAverageThemAll) {
  Report others = report();
  std::erase_if(others.runs,
                [](const RunRecord& run) { return run.configuration.scene != "teapot"; });
  EXPECT_EQ(table("conflicts", view_of(study_luong, others)).caption, "teapot");
}

}  // namespace
}  // namespace lanescope::luong
