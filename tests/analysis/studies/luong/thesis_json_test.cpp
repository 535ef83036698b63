// SPDX-License-Identifier: MIT
#include "analysis/studies/luong/thesis_json.h"

#include <gtest/gtest.h>

#include "analysis/studies/luong/study.h"
#include "analysis/studies/luong/thesis.h"
#include "tests/analysis/sample_report.h"

namespace lanescope::luong {
namespace {

using Json = nlohmann::ordered_json;

/// Checks that two documents have the same members, in the same order, and lists of one length.
void expect_same_shape(const Json& theirs, const Json& ours, const std::string& where) {
  if (theirs.is_object()) {
    ASSERT_TRUE(ours.is_object()) << where;
    std::vector<std::string> expected, found;
    for (const auto& [key, value] : theirs.items()) expected.push_back(key);
    for (const auto& [key, value] : ours.items()) found.push_back(key);
    EXPECT_EQ(found, expected) << where;
    for (const std::string& key : expected)
      if (ours.contains(key)) expect_same_shape(theirs[key], ours[key], where + "/" + key);
  } else if (theirs.is_array()) {
    ASSERT_TRUE(ours.is_array()) << where;
    EXPECT_EQ(ours.size(), theirs.size()) << where;
  } else if (theirs.is_string()) {
    EXPECT_TRUE(ours.is_string()) << where;
  } else if (theirs.is_number()) {
    EXPECT_TRUE(ours.is_number() || ours.is_null()) << where;
  }
}

/// The sample report with the four scenes of the study.
Report four_scenes() {
  Report report = lanescope::testing::sample_report();
  for (RunRecord& run : report.runs)
    if (run.configuration.scene == "teapot") run.configuration.scene = "talking";
  const std::vector<RunRecord> runs = report.runs;
  for (RunRecord run : runs) {
    if (run.configuration.scene != "ballroll") continue;
    run.configuration.scene = "tigerjump";
    report.runs.push_back(std::move(run));
  }
  return report;
}

TEST(ThesisJson, HasTheShapeOfTheThesis) {
  const Report report = four_scenes();
  expect_same_shape(thesis(), thesis_json(view_of(study_luong, report)), "");
}

TEST(ThesisJson, HoldsOurFigures) {
  const Report report = lanescope::testing::sample_report();
  const Json json = thesis_json(view_of(study_luong, report));
  EXPECT_EQ(json["table_4_1"]["utilization"]["Test"].dump(), "[0.625,null,null,null]");
  EXPECT_EQ(json["table_4_1"]["ops_per_mp"].dump(), "[7.5,null,null,null]");
  EXPECT_EQ(json["table_4_3"]["overhead"]["Test"], 0.25);
  EXPECT_EQ(json["table_4_6"]["quad"]["ste"], 0.3);
  EXPECT_EQ(json["setup"]["averaged_over_scenes"].dump(), R"(["ballroll","columnpivot"])");
  EXPECT_EQ(json["text_claims"]["triangle_bytes"], 84);
  EXPECT_EQ(json["setup"]["resolution"].dump(), "[1728,1080]");
  EXPECT_EQ(json["setup"]["triangle_area_px"], 0.5);
  EXPECT_EQ(json["setup"]["backface_culling"], true);
}

TEST(ThesisJson, OfAnEmptyReportHasItsShape) {
  const Report empty;
  expect_same_shape(thesis()["table_4_2"], thesis_json(ReportView(empty))["table_4_2"], "");
}

TEST(Thesis, GivesItsNumbers) {
  EXPECT_EQ(thesis_value({"table_4_2", "utilization", "Test Stream-load"}, 16), 0.15);
  EXPECT_EQ(thesis_value({"table_4_6", "triangle", "ste"}), 0.19);
  EXPECT_FALSE(thesis_value({"table_4_1", "utilization", "Test Stream-load"}, 16));
  EXPECT_FALSE(thesis_value({"table_4_1", "utilization", "Test"}, 24));
  EXPECT_FALSE(thesis_value({"table_4_9"}));
}

}  // namespace
}  // namespace lanescope::luong
