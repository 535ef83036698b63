// SPDX-License-Identifier: MIT
// The study's sections of the page: charts and where they stand.
#include "tests/analysis/charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/html/guide.h"
#include "analysis/studies/luong/study.h"
#include "analysis/tables/crossing.h"
#include "tests/analysis/studies/luong/sample_of_study.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;
using lanescope::testing::last_of;
using lanescope::testing::sample_report;

TEST(LuongCrossing, InterpolatesOverTheLogarithmOfW) {
  // Halfway between 8 and 16 on a logarithmic scale is sqrt(8 * 16).
  EXPECT_NEAR(*crossing_point({{8, 1.25}, {16, 0.75}}), std::sqrt(128.0), 1e-9);
  // A quarter of two octaves: 8 * 2^0.5.
  EXPECT_NEAR(*crossing_point({{8, 1.25}, {32, 0.25}}), 8.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(*crossing_point({{4, 1.5}, {8, 1.25}, {16, 0.75}}), std::sqrt(128.0), 1e-9);
}

TEST(LuongCrossing, FromEitherSideAndAtAWidth) {
  EXPECT_NEAR(*crossing_point({{8, 0.75}, {16, 1.25}}), std::sqrt(128.0), 1e-9);
  EXPECT_EQ(crossing_point({{8, 1.5}, {16, 1.0}, {32, 0.5}}), 16.0);
  EXPECT_EQ(crossing_point({{8, 1.0}}), 8.0);
}

TEST(LuongCrossing, IsNoneOnOneSide) {
  EXPECT_EQ(crossing_point({{8, 1.5}, {16, 1.1}}), std::nullopt);
  EXPECT_EQ(crossing_point({{8, 0.9}}), std::nullopt);
  EXPECT_EQ(crossing_point({}), std::nullopt);
}

Chart chart_of(const Report& report, std::string_view section_id, std::string_view chart_id) {
  return lanescope::testing::chart_of(luong_sections(), view_of(study_luong, report), section_id,
                                      chart_id);
}

TEST(LuongCharts, UtilizationIsSummedWithoutSetup) {
  const Chart chart = chart_of(sample_report(), "utilization", "lines");
  // 492 / (100 * 8) and 448 / (100 * 8).
  EXPECT_NEAR(
      last_of(chart, {"LOCKSTEP", "micropolygon = triangle", 8, "All but Setup"}).get<double>(),
      0.5875, 1e-9);
}

TEST(LuongCharts, OverheadStandsBesideTable43) {
  const Chart chart = chart_of(sample_of_study(), "overhead", "shares");
  // 15 / 60 and 10 / 40, beside the 26% of table 4.3.
  EXPECT_EQ(last_of(chart, {"REPACK", "micropolygon = triangle", 8, "Test"}, 1), Json(0.25));
  EXPECT_EQ(last_of(chart, {"REPACK", "micropolygon = triangle", 8, "Test"}), Json(0.26));
  EXPECT_EQ(last_of(chart, {"REPACK", "micropolygon = quad", 8, "Test"}), Json(nullptr));
  for (const auto& row : chart.rows.rows()) EXPECT_EQ(row[0], Json("REPACK"));
}

TEST(LuongCharts, CrossingComparesInstructionsForEachMicropolygon) {
  const Report report = sample_report();
  const Chart stages = chart_of(report, "crossing", "stages");
  // 60 / 20 and 60 / 10.
  EXPECT_EQ(last_of(stages, {"LOCKSTEP", "triangles", 8, "Test"}), Json(4.5));
  for (const auto& row : stages.rows.rows()) EXPECT_NE(row[3], Json("Setup"));
  // LOCKSTEP 100 / 20 and 100 / 10; REPACK 100 / 20 and 80 / 10.
  EXPECT_NEAR(last_of(chart_of(report, "crossing", "ratio"), {"triangles", 8}).get<double>(),
              6.5 / 7.5, 1e-5);
}

TEST(LuongCharts, QuadsAreRelativeToTheTrianglesOfTheScene) {
  const Chart chart = chart_of(sample_report(), "quads", "scenes");
  // 48 of 100.
  EXPECT_EQ(last_of(chart, {"LOCKSTEP", "quads", 8, "ballroll", "Test"}), Json(0.48));
  EXPECT_EQ(last_of(chart, {"LOCKSTEP", "triangles", 8, "teapot", "Test"}), Json(0.5));
}

TEST(LuongCharts, WorkingSetAddsUpThePacketsOfItsScenes) {
  Report report = sample_report();
  for (RunRecord& run : report.runs)
    if (run.configuration.kernel == "repack")
      run.series = {{"working_set_course_sum", "", "", "", {16, 30}},
                    {"working_set_course_packets", "", "", "", {2, 1}},
                    {"working_set_histogram", "", "", "", {0, 1, 3}}};
  const Chart course = chart_of(report, "working-set", "course");
  EXPECT_EQ(last_of(course, {"REPACK", "triangles", 8, 1}), Json(1.0));
  EXPECT_EQ(last_of(course, {"REPACK", "triangles", 8, 2}), Json(3.75));
  EXPECT_EQ(last_of(chart_of(report, "working-set", "histogram"), {"REPACK", "triangles", 8, 0.25}),
            Json(0.75));
}

TEST(LuongCharts, TheMapHasTheRoundedDifferencesOfTheTables) {
  const Chart chart = chart_of(sample_of_study(), "against-thesis", "map");
  // 85% against 98%.
  EXPECT_EQ(last_of(chart, {"Table 4.1: LOCKSTEP, triangles", "Bound", "W = 8"}, 1), Json(-13.0));
}

/// Two scenes are not the four of the thesis.
TEST(LuongCharts, CompareWithNothingThatIsNotTheThesiss) {
  const Report two_scenes = sample_report();
  const Chart overhead = chart_of(two_scenes, "overhead", "shares");
  for (const auto& row : overhead.rows.rows())
    for (const Json& value : row) EXPECT_NE(value, Json(0.26));
  for (const Section* section : luong_sections()) {
    if (section->id != "against-thesis") continue;
    EXPECT_TRUE(section->build(view_of(study_luong, two_scenes)).empty());
  }
}

TEST(LuongPage, ItsSectionsTakeTheirPlacesAmongTheGeneralOnes) {
  const PagePlan plan = page_plan(sample_report(), {&study_luong});
  std::vector<std::string> ids;
  for (const Section* section : plan.sections) ids.emplace_back(section->id);
  EXPECT_EQ(ids, (std::vector<std::string>{"answer", "headline", "utilization", "overhead",
                                           "active-lanes", "lanes", "mix", "memory", "machines",
                                           "hot-lines", "crossing", "quads", "working-set",
                                           "against-thesis"}));
  EXPECT_EQ(plan.sections.front(), luong_sections().front());
  EXPECT_EQ(plan.scenes,
            (std::vector<std::string>{"ballroll", "columnpivot", "tigerjump", "talking"}));
}

TEST(LuongPage, OfOtherKernelsIsTheGeneralOne) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) run.configuration.kernel = "unheard-of";
  const PagePlan plan = page_plan(report, {&study_luong});
  EXPECT_EQ(plan.sections, sections());
  EXPECT_TRUE(plan.scenes.empty());
}

TEST(LuongPage, HasFourteenSectionsAndSixteenCharts) {
  Report report = sample_of_study();
  for (RunRecord& run : report.runs)
    if (run.configuration.kernel == "repack")
      run.series = {{"working_set_course_sum", "", "", "", {16, 30}},
                    {"working_set_course_packets", "", "", "", {2, 1}},
                    {"working_set_histogram", "", "", "", {0, 1, 3}}};
  const std::vector<NamedReport> sources{{"a.json", report}};
  const std::string page = report_page(
      sources, ".", [](const Report& setting) { return page_plan(setting, {&study_luong}); });
  const auto count = [&](std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = page.find(part); at != page.npos; at = page.find(part, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<h2 id="), 3u + 14u);
  EXPECT_EQ(count("<figure class=\"chart\""), 16u);
  EXPECT_EQ(count("The reports have no figures for"), 0u);
}

TEST(LuongPage, TheDocsSayHowToReadEachOfItsSections) {
  for (const Section* section : luong_sections()) {
    if (section->id == "answer") continue;
    EXPECT_NE(guide_html(section->title), "") << section->title;
  }
}

TEST(LuongPage, BeginsWithTheCrossingAndTheThesis) {
  const std::string page =
      report_page({{"a.json", sample_report()}}, ".",
                  [](const Report& setting) { return page_plan(setting, {&study_luong}); });
  const std::string answer = page.substr(page.find("<h2 id=\"answer\">"));
  const std::string above = answer.substr(0, answer.find("</section>"));
  EXPECT_NE(above.find("On triangles, REPACK issues "), above.npos) << above;  // At W = 8 alone.
  EXPECT_NE(above.find("On quads, LOCKSTEP keeps "), above.npos);
  EXPECT_EQ(above.find("Against the thesis"), above.npos);  // Not all of its scenes.
}

TEST(LuongPage, OfRunsThatCountedNothingIsTheGeneralOne) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) run.stages.clear();
  EXPECT_EQ(page_plan(report, {&study_luong}).sections, sections());
}

TEST(LuongPage, OtherKindsOfWorkBesideItHaveTheGeneralSections) {
  Report both = sample_report();
  RunRecord other = both.runs.front();
  other.configuration.kernel = "unheard-of";
  other.workload = "others";
  both.runs.push_back(other);
  const std::string page = report_page({{"a.json", both}}, ".", [](const Report& setting) {
    return page_plan(setting, {&study_luong});
  });
  EXPECT_NE(page.find("<h2 id=\"crossing\">"), page.npos);
  EXPECT_NE(page.find("<option selected>micropolygons</option><option>others</option>"), page.npos);
}

/// The scenes are in the study's experiment and its kernels are the program's.
TEST(LuongStudy, NamesWhatTheProgramHas) {
  for (const std::string_view kernel : study_luong.kernels) {
    ASSERT_NE(known_kernel(kernel), nullptr) << kernel;
    for (const std::string_view scene : study_luong.scenes)
      EXPECT_NE(known_kernel(kernel)->workload->find_scene(scene), nullptr) << scene;
    const std::vector<Parameter> parameters = parameters_of(*known_kernel(kernel));
    for (const Study::Axis& axis : study_luong.axes)
      EXPECT_TRUE(std::any_of(parameters.begin(), parameters.end(), [&](const Parameter& p) {
        return p.name() == axis.parameter;
      })) << axis.parameter;
  }
}

}  // namespace
}  // namespace lanescope::luong
