// SPDX-License-Identifier: MIT
#include "analysis/annotation/annotation.h"

#include <fmt/format.h>
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
                               {{"kernels/micropolygons/stages.h", 61, "Setup", 10, 80, 0},
                                {"kernels/micropolygons/stages.h", 61, "Bound", 10, 40, 5},
                                {"kernels/micropolygons/stages.h", 62, "Test", 30, 60, 0}}));
  report.runs.push_back(
      run_of("other", 8, {{"kernels/micropolygons/stages.h", 61, "Setup", 50, 400, 0}}));
  report.runs.push_back(
      run_of("one", 16, {{"kernels/micropolygons/stages.h", 62, "Test", 1, 16, 0}}));
  report.runs.push_back(run_of("unobserved", 32, {}));
  return report;
}

TEST(Annotate, SumsScenesOfALineInAStageHottestFirst) {
  const auto annotations = annotate(two_scenes());
  ASSERT_EQ(annotations.size(), 2u);
  const Annotation& a = annotations.front();
  EXPECT_EQ(a.width, 8);
  EXPECT_EQ(a.title(), "repack, W = 8, triangle: one, other");
  EXPECT_EQ(a.scenes, (std::vector<std::string>{"one", "other"}));
  EXPECT_EQ(a.pieces, 64u);
  EXPECT_EQ(a.issued, 100u);
  ASSERT_EQ(a.lines.size(), 3u);
  EXPECT_EQ(a.lines[0].place, (SourcePlace{"kernels/micropolygons/stages.h", 61}));
  EXPECT_EQ(a.lines[0].stage, "Setup");
  EXPECT_EQ(a.lines[0].issued, 60u);
  EXPECT_DOUBLE_EQ(*a.share(a.lines[0]).value(), 0.60);
  EXPECT_DOUBLE_EQ(*a.utilization(a.lines[0]).value(), 1.0);
  EXPECT_DOUBLE_EQ(*a.utilization(a.lines[1]).value(), 60.0 / (30 * 8));
  EXPECT_EQ(a.lines[2].place, a.lines[0].place);
  EXPECT_EQ(a.lines[2].stage, "Bound");
  EXPECT_EQ(a.lines[2].overhead, 5u);
  EXPECT_EQ(annotations[1].width, 16);
}

/// A line of a helper is one for each block that called it; reports of earlier programs do not say.
TEST(Annotate, KeepsBlocksApart) {
  const std::string file = "kernels/micropolygons/stages.h";
  const SourcePlace testing{"kernels/micropolygons/repack.h", 10};
  const SourcePlace ruling{"kernels/micropolygons/repack.h", 20};
  Report report;
  report.runs = {
      run_of("one", 8,
             {{file, 61, "Test", 10, 80, 0, testing}, {file, 61, "Test", 2, 4, 0, ruling}}),
      run_of("other", 8, {{file, 61, "Test", 5, 40, 0, testing}, {file, 61, "Test", 1, 1, 0, {}}})};
  const Annotation a = annotate(report).front();
  ASSERT_EQ(a.lines.size(), 3u);
  EXPECT_EQ(a.lines[0].block, testing);
  EXPECT_EQ(a.lines[0].issued, 15u);
  EXPECT_EQ(a.lines[1].block, ruling);
  EXPECT_EQ(a.lines[2].block, std::nullopt);
  const TableData table = hottest_lines(a, 3);
  EXPECT_EQ(table.rows[0].cells.back().words,
            fmt::format("repack.h:10: {}", source_line(testing.file, testing.line)));
  EXPECT_EQ(table.rows[2].cells.back().words, "");
  EXPECT_NE(annotated_source(a).find(" 100.0%   86.8%           18   61 | "), std::string::npos);
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
  EXPECT_EQ(table.rows[0].label, "kernels/micropolygons/stages.h:61");
  const std::string source(source_line("kernels/micropolygons/stages.h", 61));
  EXPECT_NE(source, "");
  const std::string& shown_source = table.rows[0].cells[4].words;
  EXPECT_NE(shown_source, "");
  EXPECT_NE(source.find(shown_source), source.npos);
  EXPECT_EQ(hottest_lines(a, 10).rows.size(), 3u);
  EXPECT_EQ(table.caption, "4 of 64 pieces of work");
  EXPECT_EQ(table.setting, "resolution = 1728x1080, msaa = 4, frame = 26, cull = on");
}

TEST(Annotate, PutsTheFiguresInTheMarginOfTheSource) {
  const std::string text = annotated_source(annotate(two_scenes()).front());
  EXPECT_NE(text.find("  70.0%   92.9%           70   61 | "), text.npos) << text.substr(0, 6000);
  EXPECT_NE(text.find("  30.0%   25.0%           30   62 | "), text.npos);
  EXPECT_EQ(text.find("kernels/micropolygons/repack.h"), text.npos) << "nothing was issued there";
}

TEST(Sources, HaveEveryLine) {
  EXPECT_EQ(source_line("kernels/micropolygons/stages.h", 1), "// SPDX-License-Identifier: MIT");
  EXPECT_EQ(source_line("kernels/micropolygons/stages.h", 100000), "");
  EXPECT_EQ(source_line("kernels/nothing.h", 1), "");
}

}  // namespace
}  // namespace lanescope
