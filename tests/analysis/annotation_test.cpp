// SPDX-License-Identifier: MIT
#include "analysis/annotation/annotation.h"

#include <gtest/gtest.h>

#include "analysis/annotation/sources.h"
#include "tests/analysis/configured.h"

namespace lanescope {
namespace {

RunRecord run_of(const char* scene, int width, std::vector<SourceLineRecord> lines) {
  RunRecord run;
  run.configuration =
      testing::configured({{"kernel", "repack"}, {"width_lanes", static_cast<unsigned>(width)}});
  run.configuration.scene = scene;
  run.source.pieces = 32;
  run.source.pieces_observed = 2;
  run.source_lines = std::move(lines);
  return run;
}

Report two_scenes() {
  Report report;
  report.runs.push_back(run_of("one", 8,
                               {{"kernels/micropolygons/stages.h", 60, "Setup", 10, 80, 0},
                                {"kernels/micropolygons/stages.h", 60, "Bound", 10, 40, 5},
                                {"kernels/micropolygons/stages.h", 61, "Test", 30, 60, 0}}));
  report.runs.push_back(
      run_of("other", 8, {{"kernels/micropolygons/stages.h", 60, "Setup", 50, 400, 0}}));
  report.runs.push_back(
      run_of("one", 16, {{"kernels/micropolygons/stages.h", 61, "Test", 1, 16, 0}}));
  report.runs.push_back(run_of("unobserved", 32, {}));
  return report;
}

TEST(Annotate, SumsScenesAndStagesOfALineHottestFirst) {
  const auto annotations = annotate(two_scenes());
  ASSERT_EQ(annotations.size(), 2u);
  const Annotation& a = annotations.front();
  EXPECT_EQ(a.width, 8);
  EXPECT_EQ(a.title(), "repack, W = 8, triangle: one, other");
  EXPECT_EQ(a.scenes, (std::vector<std::string>{"one", "other"}));
  EXPECT_EQ(a.pieces, 64u);
  EXPECT_EQ(a.issued, 100u);
  ASSERT_EQ(a.lines.size(), 2u);
  EXPECT_EQ(a.lines[0].line, 60u);
  EXPECT_EQ(a.lines[0].stages, "Setup, Bound");
  EXPECT_EQ(a.lines[0].issued, 70u);
  EXPECT_EQ(a.lines[0].overhead, 5u);
  EXPECT_DOUBLE_EQ(*a.share(a.lines[0]).value(), 0.70);
  EXPECT_DOUBLE_EQ(*a.utilization(a.lines[0]).value(), 520.0 / (70 * 8));
  EXPECT_DOUBLE_EQ(*a.utilization(a.lines[1]).value(), 60.0 / (30 * 8));
  EXPECT_EQ(annotations[1].width, 16);
}

TEST(Annotate, KeepsFacetsApart) {
  Report report = two_scenes();
  set_value(report.runs[1].configuration, "micropolygon", std::string("quad"));
  const auto annotations = annotate(report);
  ASSERT_EQ(annotations.size(), 3u);
  EXPECT_EQ(annotations[0].title(), "repack, W = 8, triangle: one");
  EXPECT_EQ(annotations[1].title(), "repack, W = 8, quad: other");
}

TEST(Annotate, ShowsTheTextOfTheLine) {
  const Annotation a = annotate(two_scenes()).front();
  const TableData table = hottest_lines(a, 1);
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0].label, "kernels/micropolygons/stages.h:60");
  const std::string source(source_line("kernels/micropolygons/stages.h", 60));
  EXPECT_NE(source, "");
  EXPECT_NE(source.find(table.rows[0].cells.back().words), source.npos);
  EXPECT_EQ(hottest_lines(a, 10).rows.size(), 2u);
  EXPECT_EQ(table.caption, "4 of 64 pieces of work");
}

TEST(Annotate, PutsTheFiguresInTheMarginOfTheSource) {
  const std::string text = annotated_source(annotate(two_scenes()).front());
  EXPECT_NE(text.find("  70.0%   92.9%           70   60 | "), text.npos) << text.substr(0, 6000);
  EXPECT_NE(text.find("  30.0%   25.0%           30   61 | "), text.npos);
  EXPECT_EQ(text.find("kernels/micropolygons/repack.h"), text.npos) << "nothing was issued there";
}

TEST(Sources, HaveEveryLine) {
  EXPECT_EQ(source_line("kernels/micropolygons/stages.h", 1), "// SPDX-License-Identifier: MIT");
  EXPECT_EQ(source_line("kernels/micropolygons/stages.h", 100000), "");
  EXPECT_EQ(source_line("kernels/nothing.h", 1), "");
}

}  // namespace
}  // namespace lanescope
