// SPDX-License-Identifier: MIT
// The page of `lanescope report`: what goes into it, without a browser; tests/html has one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "analysis/base/files.h"
#include "analysis/html/groups.h"
#include "analysis/html/guide.h"
#include "analysis/html/markup.h"
#include "analysis/html/packed.h"
#include "analysis/html/page.h"
#include "analysis/html/section.h"
#include "analysis/html/spec.h"
#include "analysis/html/table_html.h"
#include "analysis/pictures/image.h"
#include "analysis/tables/means.h"
#include "simulator/base/error.h"
#include "tests/analysis/charts.h"
#include "tests/analysis/sample_report.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;
using testing::last_of;
using testing::sample_report;

TEST(HtmlMarkup, EscapesWhatCouldEndATextOrAnAttribute) {
  EXPECT_EQ(html_escaped("a<b>&\"c\"'d'"), "a&lt;b&gt;&amp;&quot;c&quot;&#39;d&#39;");
  EXPECT_EQ(html_escaped("W = 8, 16"), "W = 8, 16");
}

TEST(HtmlMarkup, ScriptJsonCannotEndItsElement) {
  const Json value = {{"path", "</script><b>"}, {"open", "<!--<script>"}};
  const std::string text = script_json(value);
  EXPECT_EQ(text.find('<'), text.npos);
  EXPECT_EQ(Json::parse(text), value);
}

TEST(HtmlMarkup, ScriptJsonReplacesBytesThatAreNoText) {
  EXPECT_EQ(script_json("a\xff"), "\"a\xef\xbf\xbd\"");
}

TEST(HtmlMarkup, Base64AsInRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64(std::string_view("\xff\x00\xfe", 3)), "/wD+");
}

TEST(HtmlMarkup, PackedIsSmallAndLeavesOutNothing) {
  EXPECT_EQ(packed("").rfind("eN", 0), 0u);  // The header of zlib at its best compression.
  EXPECT_LT(packed(std::string(100'000, 'a')).size(), 500u);
  EXPECT_NE(packed("a"), packed("b"));
}

TEST(HtmlDataFrame, TakesTheRowsOfAnotherWithTheSameColumns) {
  DataFrame frame({{"stage", "Stage", ""}});
  frame.add({"Bound"});
  DataFrame other = frame;
  other.append(frame);
  EXPECT_EQ(other.rows().size(), 2u);
  EXPECT_THROW(other.append(DataFrame({{"kernel", "Kernel", ""}})), CheckError);
}

TEST(HtmlDataFrame, IsWrittenByColumns) {
  DataFrame frame({{"stage", "Stage", ""}, {"share", "Share", ".1%"}});
  frame.add({"Bound", 0.123456789});
  frame.add({"Test", nullptr});
  frame.add({"Bound", 3});
  const Json expected = Json::parse(R"({"rows": 3, "columns": [
      {"name": "stage", "title": "Stage", "format": "", "words": ["Bound", "Test"],
       "values": [0, 1, 0]},
      {"name": "share", "title": "Share", "format": ".1%", "words": [],
       "values": [0.12346, null, 3]}]})");
  EXPECT_EQ(frame.to_json(), expected);
}

TEST(HtmlDataFrame, RefusesRowsOfAnotherLength) {
  DataFrame frame({{"stage", "Stage", ""}});
  EXPECT_THROW(frame.add({"Bound", 1}), CheckError);
}

/// The sample with all runs at that many samples a pixel.
Report sample_at(std::uint64_t samples_per_pixel) {
  Report report = sample_report();
  for (RunRecord& run : report.runs)
    set_value(run.configuration, "samples_per_pixel", samples_per_pixel);
  return report;
}

TEST(HtmlGroups, OneSettingIsOneGroupWithoutAName) {
  const std::vector<Group> groups = groups_of({{"a.json", sample_report()}});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].name, "");
  EXPECT_EQ(groups[0].report.runs.size(), sample_report().runs.size());
  EXPECT_EQ(groups[0].report.instructions.size(), sample_report().instructions.size());
}

TEST(HtmlGroups, AreNamedByWhatVaries) {
  const std::vector<Group> groups =
      groups_of({{"a.json", sample_at(4)}, {"b.json", sample_at(16)}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].name, "samples_per_pixel = 4");
  EXPECT_EQ(groups[1].name, "samples_per_pixel = 16");
  EXPECT_EQ(groups[1].report.runs.size(), sample_report().runs.size());
}

TEST(HtmlGroups, ScenesAtDifferentFramesAreOneSetting) {
  Report report = sample_report();
  for (RunRecord& run : report.runs)
    if (run.configuration.scene == "columnpivot")
      set_value(run.configuration, "frame", std::uint64_t{7});
  EXPECT_EQ(groups_of({{"a.json", report}}).size(), 1u);
}

TEST(HtmlGroups, OneSceneAtTwoFramesIsTwoSettings) {
  Report report = sample_report();
  RunRecord later = report.runs.front();
  set_value(later.configuration, "frame", std::uint64_t{7});
  report.runs.push_back(later);
  const std::vector<Group> groups = groups_of({{"a.json", report}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[1].name, "frame = 7");
}

/// REPACK at two thresholds of the loading that LOCKSTEP does not do.
Report at_two_thresholds() {
  Report report = sample_report();
  const std::vector<RunRecord> runs = report.runs;
  for (RunRecord run : runs) {
    if (run.configuration.kernel != "repack") continue;
    set_value(run.configuration, "stream_load_threshold", 0.5f);
    report.runs.push_back(std::move(run));
  }
  return report;
}

TEST(HtmlGroups, ARunIsOfEverySettingOfAParameterThatItsKernelDoesNotTake) {
  const std::vector<Group> groups = groups_of({{"a.json", at_two_thresholds()}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].name, "stream_load_threshold = 0");
  EXPECT_EQ(groups[1].name, "stream_load_threshold = 0.5");
  for (const Group& group : groups) EXPECT_EQ(group.report.runs.size(), 12u) << group.name;
}

TEST(HtmlGroups, KindsOfWorkAreSettings) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) {
    if (run.configuration.kernel != "repack") continue;
    run.configuration.kernel = "unheard-of";
    run.workload = "others";
  }
  const std::vector<Group> groups = groups_of({{"a.json", report}});
  ASSERT_EQ(groups.size(), 3u);  // An unknown kernel has no facet: its parameter tells runs apart.
  EXPECT_EQ(groups[0].name, "workload = micropolygons");
  EXPECT_EQ(groups[1].name, "workload = others, micropolygon = triangle");
}

TEST(HtmlGroups, TheSameRunInTwoFilesIsAMistake) {
  try {
    groups_of({{"a.json", sample_report()}, {"b.json", sample_report()}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "b.json: has a run that a.json has, too: lockstep on ballroll, W = 8, "
                 "micropolygon = triangle; leave out one of the files");
  }
}

/// A view of the two scenes in which every stage was run.
ReportView two_scenes(const Report& report) {
  return ReportView(report, scenes_of(report, {"ballroll", "columnpivot"}));
}

Chart chart_of(const Report& report, std::string_view section_id, std::string_view chart_id) {
  return testing::chart_of(sections(), two_scenes(report), section_id, chart_id);
}

TEST(HtmlCharts, UtilizationIsTheMeanOverTheScenes) {
  const Chart chart = chart_of(sample_report(), "utilization", "lines");
  // 72 / (10 * 8) and 128 / (20 * 8).
  EXPECT_NEAR(last_of(chart, {"LOCKSTEP", "micropolygon = triangle", 8, "Bound"}).get<double>(),
              0.85, 1e-9);
  // 508 / (102 * 8) and 460 / (103 * 8).
  EXPECT_NEAR(
      last_of(chart, {"LOCKSTEP", "micropolygon = triangle", 8, "All stages"}).get<double>(),
      0.5904, 1e-4);
}

TEST(HtmlCharts, OverheadLeavesOutKernelsThatHaveNone) {
  const Chart chart = chart_of(sample_report(), "overhead", "shares");
  // 15 / 60 and 10 / 40.
  EXPECT_EQ(last_of(chart, {"REPACK", "micropolygon = triangle", 8, "Test"}), Json(0.25));
  for (const auto& row : chart.rows.rows()) EXPECT_EQ(row[0], Json("REPACK"));
}

TEST(HtmlCharts, HistogramsAreSharesOfTheStage) {
  Report report = sample_report();
  StageRecord& stage = report.runs[0].stages[1];
  ASSERT_EQ(stage.name, "Bound");
  stage.histogram = {0, 0, 0, 0, 0, 0, 0, 4, 6};
  stage.lane_active = {10, 10, 9, 9, 9, 9, 8, 8};
  EXPECT_EQ(last_of(chart_of(report, "active-lanes", "panels"),
                    {"LOCKSTEP", "micropolygon = triangle", 8, "ballroll", "Bound", 8}),
            Json(0.6));
  EXPECT_EQ(last_of(chart_of(report, "lanes", "panels"),
                    {"LOCKSTEP", "micropolygon = triangle", 8, "ballroll", "Bound", 7}),
            Json(0.8));
}

TEST(HtmlCharts, MixGathersByClassAndMnemonic) {
  const Report report = sample_report();
  EXPECT_EQ(last_of(chart_of(report, "mix", "classes"),
                    {"LOCKSTEP", "micropolygon = triangle", 8, "arithmetic", "Test"}),
            Json(4.5));
  EXPECT_EQ(last_of(chart_of(report, "mix", "mnemonics"),
                    {"LOCKSTEP", "micropolygon = triangle", 8, "add", "Test"}),
            Json(4.5));
}

TEST(HtmlCharts, MemoryIsLinesForEachExecution) {
  Report report = sample_report();
  for (RunRecord& run : report.runs)
    if (RunRecord& r = run; r.configuration.kernel == "repack")
      r.stages[1].memory = {{"scatter", 4, 16, 6, {0, 2, 2, 0, 0, 0, 0, 0, 0}, 1}};
  const Chart means = chart_of(report, "memory", "means");
  EXPECT_EQ(last_of(means, {"REPACK", "micropolygon = quad", 8, "Bound", "scatter"}), Json(0.0625));
  EXPECT_EQ(last_of(means, {"REPACK", "micropolygon = quad", 8, "Bound", "scatter"}, 2), Json(1.5));
  EXPECT_EQ(last_of(chart_of(report, "memory", "histograms"),
                    {"REPACK", "micropolygon = quad", 8, "Bound", "scatter", 2}),
            Json(0.5));
}

/// The sample at every W from 1 to 64.
Report at_all_widths() {
  Report report = sample_report();
  const std::vector<RunRecord> runs = report.runs;
  report.runs.clear();
  for (int width = 1; width <= 64; ++width)
    for (RunRecord run : runs) {
      run.configuration.width = width;
      report.runs.push_back(std::move(run));
    }
  return report;
}

TEST(HtmlCharts, OfFewWidthsAreLogarithmicWithAPointAtEach) {
  const Json spec = spec_from(R"({"x": "@lanes", "point": "@point"})", sample_report());
  EXPECT_EQ(spec["x"]["scale"]["type"], "log");
  EXPECT_EQ(spec["x"]["axis"]["values"], Json::array({8}));
  EXPECT_TRUE(spec["point"].is_object());
}

TEST(HtmlCharts, OfManyWidthsHaveRoomForTheirLabels) {
  const Report report = at_all_widths();
  const Json spec = spec_from(R"({"x": "@lanes", "bars": "@W", "point": "@point"})", report);
  EXPECT_FALSE(spec["x"]["scale"].contains("type"));  // Linear.
  EXPECT_EQ(spec["x"]["axis"]["values"], Json({1, 8, 16, 24, 32, 40, 48, 56, 64}));
  EXPECT_EQ(spec["bars"]["axis"]["values"], Json({1, 16, 32, 48, 64}));
  EXPECT_EQ(spec["point"], Json(false));
  EXPECT_EQ(few_widths(widths_of(report)), (std::vector<int>{1, 2, 4, 8, 16, 32, 64}));
  EXPECT_EQ(few_widths({3, 5, 7}), (std::vector<int>{3, 5, 7}));
}

TEST(HtmlCharts, PickColumnsOfTheirRows) {
  const Report report = sample_report();
  for (const Section* section : sections())
    for (const SectionBlock& block : section->build(two_scenes(report)))
      if (const Chart* chart = std::get_if<Chart>(&block)) {
        for (const Pick& pick : chart->picks)
          EXPECT_TRUE(std::any_of(chart->rows.columns().begin(), chart->rows.columns().end(),
                                  [&](const DataColumn& c) { return c.name == pick.column; }))
              << section->id << ' ' << chart->id << ' ' << pick.column;
      }
}

TEST(HtmlCharts, StagesHaveOneColourEverywhere) {
  std::map<std::string, std::set<std::string>> colours;
  const Report report = sample_report();
  for (const Section* section : sections())
    for (const SectionBlock& block : section->build(two_scenes(report)))
      if (const Chart* chart = std::get_if<Chart>(&block)) {
        const Json flat = chart->spec.flatten();
        for (const auto& [path, value] : flat.items())
          if (value == "stage" && path.ends_with("/color/field")) {
            const Json::json_pointer at(path.substr(0, path.size() - 5) + "scale");
            const Json& scale = chart->spec.at(at);
            for (std::size_t i = 0; i < scale["domain"].size(); ++i)
              colours[scale["domain"][i]].insert(scale["range"][i]);
          }
      }
  EXPECT_GT(colours.size(), 3u);
  for (const auto& [stage, of_stage] : colours) EXPECT_EQ(of_stage.size(), 1u) << stage;
}

TEST(HtmlTable, HasHeadingsForColumnsAndRows) {
  TableData data;
  data.title = "A < B";
  data.row_header = "Stage";
  data.columns = {"W = 8"};
  data.rows = {{"Group", {}}, {"Bound", {Cell{Figure{0.5, 0.4, &kPercent}, {}, {}}}}};
  const std::string html = table_html(data);
  for (const char* part : {"<caption>A &lt; B", "<th scope=\"col\">Stage</th>",
                           "<th scope=\"rowgroup\" colspan=\"4\">Group</th>",
                           "<th scope=\"row\">Bound</th><td>50.0%</td><td>40%</td><td>+10</td>"})
    EXPECT_NE(html.find(part), html.npos) << part << "\n" << html;
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The general page.
PagePlan general_plan(const Report&) { return {sections(), {"ballroll", "columnpivot"}}; }

/// The headings of a page, by their ids.
std::vector<std::string> headings(std::string_view page) {
  constexpr std::string_view kOpen = "<h2 id=\"";
  std::vector<std::string> ids;
  for (std::size_t at = page.find(kOpen); at != page.npos; at = page.find(kOpen, at + 1)) {
    const std::size_t begin = at + kOpen.size();
    ids.emplace_back(page.substr(begin, page.find('"', begin) - begin));
  }
  return ids;
}

TEST(HtmlPage, BeginsWithTheAnswerAndEndsWithWhatWasRun) {
  const std::string page = report_page({{"a.json", sample_report()}}, ".", general_plan);
  const std::vector<std::string> ids = headings(page);
  ASSERT_GT(ids.size(), 6u);
  EXPECT_EQ(ids[0], "answer");
  EXPECT_EQ(ids[1], "frames");
  EXPECT_EQ(ids[2], "headline");
  EXPECT_EQ(ids[ids.size() - 2], "runs");
  EXPECT_EQ(ids.back(), "downloads");
  EXPECT_EQ(page.find("<h3"), page.npos);
  EXPECT_NE(page.find("mean of ballroll, columnpivot"), page.npos);
  EXPECT_EQ(page.find("mean of ballroll, columnpivot, teapot"), page.npos);
}

TEST(HtmlPage, EachSectionOfThePlanIsThereOrSaidToHaveNoFigures) {
  const std::string page = report_page({{"a.json", sample_report()}}, ".", general_plan);
  const std::size_t note = page.find("The reports have no figures for: ");
  for (const Section* section : sections())
    EXPECT_EQ(count(page, fmt::format("<h2 id=\"{}\">", section->id)),
              page.find(section->title, note) == page.npos ? 1u : 0u)
        << section->id;
}

TEST(HtmlPage, TheDocsSayHowToReadEachChart) {
  for (const Section* section : sections()) {
    if (section->id == "answer") continue;
    EXPECT_NE(guide_html(section->title), "") << section->title;
  }
  EXPECT_EQ(guide_html("Nothing of this name"), "");
  EXPECT_NE(guide_html("Over a parameter").find("<em>All stages</em>"), std::string::npos);
  const std::string page = report_page({{"a.json", sample_report()}}, ".", general_plan);
  EXPECT_GT(count(page, "<details class=\"guide\">"), 5u);
}

TEST(HtmlPage, AnswersWhichKernelIsAheadWhere) {
  const Report report = sample_report();
  const std::string page = report_page({{"a.json", report}}, ".", general_plan);
  // LOCKSTEP's 102 and REPACK's instructions for 2 micropolygons, all stages.
  const ReportView view = two_scenes(report);
  const double lockstep = *mean_instructions(view, {"lockstep", "triangle"}, 8);
  const double repack = *mean_instructions(view, {"repack", "triangle"}, 8);
  const std::string ahead = lockstep < repack ? "LOCKSTEP" : "REPACK";
  EXPECT_NE(page.find(fmt::format("At W = 8 and micropolygon = triangle, {} is ahead: it needs "
                                  "{:.2f} instructions for each micropolygon",
                                  ahead, std::min(lockstep, repack))),
            page.npos);
  EXPECT_NE(page.find(fmt::format("<td><b>{}</b> {:.2f}<br>", ahead, std::min(lockstep, repack))),
            page.npos);
}

TEST(HtmlPage, AKernelThatLacksASceneHasAMeanOfTheOthersAndSaysSo) {
  Report report = sample_report();
  std::erase_if(report.runs, [](const RunRecord& run) {
    return run.configuration.kernel == "repack" && run.configuration.scene == "ballroll";
  });
  const ReportView view = two_scenes(report);
  const Series repack{"repack", "triangle"};
  EXPECT_EQ(view.missing_scenes(repack), std::vector<std::string>{"ballroll"});
  EXPECT_TRUE(view.missing_scenes({"lockstep", "triangle"}).empty());
  EXPECT_EQ(mean_instructions(view, repack, 8),
            mean_instructions(ReportView(report, "columnpivot"), repack, 8));
  const std::string page = report_page({{"a.json", report}}, ".", general_plan);
  EXPECT_NE(page.find("REPACK, micropolygon = triangle was not run on ballroll"), page.npos);
}

TEST(HtmlPage, NamesScenesWithTheirWork) {
  const std::string page = report_page({{"a.json", sample_report()}}, ".", general_plan);
  for (const char* part : {"<th scope=\"row\">ballroll, frame = 0</th>"
                           "<td>micropolygon = quad</td><td>0x0123456789abcdef</td><td>3</td>",
                           "<th scope=\"col\">patches_<wbr>culled</th>"})
    EXPECT_NE(page.find(part), page.npos) << part;
}

TEST(HtmlPage, HasOneCopyOfEachSectionAndControlsForTheSetting) {
  const std::string one = report_page({{"a", sample_at(4)}}, ".", general_plan);
  const std::string page =
      report_page({{"a", sample_at(1)}, {"b", sample_at(4)}}, ".", general_plan);
  EXPECT_EQ(count(one, "<form id=\"setting\">"), 0u);
  EXPECT_EQ(count(page,
                  "<select name=\"samples_per_pixel\"><option>1</option>"
                  "<option selected>4</option></select>"),
            1u);  // The default is first.
  std::vector<std::string> ids = headings(page);
  EXPECT_EQ(std::erase(ids, "over-samples_per_pixel"), 1u);
  EXPECT_EQ(ids, headings(one));
}

TEST(HtmlPage, OfAnotherSettingIsSmallerThanAPageOfItsOwn) {
  const std::string one = report_page({{"a", sample_at(4)}}, ".", general_plan);
  std::vector<NamedReport> sources;
  for (const std::uint64_t samples : {1, 4, 9, 16})
    sources.push_back({fmt::format("{}.json", samples), sample_at(samples)});
  const std::string page = report_page(sources, ".", general_plan);
  EXPECT_LT(page.size(), one.size() + 100'000);
}

TEST(HtmlPage, SaysAtWhichSettingAKernelNeedsFewest) {
  Report report = at_two_thresholds();
  for (RunRecord& run : report.runs)
    if (value_of(run.configuration, "stream_load_threshold") == Value(0.5f))
      for (StageRecord& stage : run.stages)
        for (InstructionRecord& counts : stage.instructions) counts.issued /= 2;
  const std::string page = report_page({{"a", report}}, ".", general_plan);
  EXPECT_NE(page.find("</b> at 0.5<br>"), page.npos);
  EXPECT_EQ(page.find("</b> at 0<br>"), page.npos);
}

TEST(HtmlPage, StringsOfTheReportAreHarmless) {
  const std::string plain = report_page({{"a.json", sample_report()}}, ".", general_plan);
  Report report = sample_report();
  const std::string evil = "</script><b onload=\"x\">&{{program}}'";
  report.command = report.commit = report.program_version = report.timing.host = evil;
  for (RunRecord& run : report.runs) {
    if (run.configuration.scene == "ballroll") run.configuration.scene = evil;
    for (StageRecord& stage : run.stages)
      if (stage.name == "Bound") stage.name = evil;
  }
  const std::string page = report_page({{evil, report}}, ".", general_plan);
  EXPECT_EQ(page.find("<b onload"), page.npos);
  EXPECT_EQ(count(page, "</script>"), count(plain, "</script>"));
}

TEST(HtmlPage, SaysWhichCommandDrawsAMissingPicture) {
  const std::string page = report_page({{"a.json", sample_report()}}, "somewhere", general_plan);
  EXPECT_NE(page.find("lanescope render --scene ballroll --frame 0 "), page.npos);
  EXPECT_NE(page.find("-o somewhere/frame-ballroll.png"), page.npos);
}

TEST(HtmlPage, EmbedsThePictures) {
  const testing::ScratchDirectory scratch;
  const std::string directory = scratch.path();
  write_file(directory + "/frame-ballroll.png", png({2, 1, {{255, 0, 0}, {0, 0, 255}}}));
  const std::string page = report_page({{"a.json", sample_report()}}, directory, general_plan);
  EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBOR"), 1u);
  write_file(directory + "/frame-ballroll.png", "no picture");
  EXPECT_THROW(report_page({{"a.json", sample_report()}}, directory, general_plan), InputError);
}

/// Nothing faced the viewer: every mean is of nothing.
TEST(HtmlPage, SaysThatThereIsNothingToCompare) {
  Report report = sample_report();
  for (RunRecord& run : report.runs)
    for (CounterRecord& counter : run.counters) counter.value = 0;
  const std::string page = report_page({{"a.json", report}}, ".", general_plan);
  EXPECT_EQ(count(page, "There is nothing to compare"), 1u);
  EXPECT_EQ(count(page, "These runs counted nothing"), 0u);
}

TEST(HtmlPage, RefusesReportsWithoutRuns) {
  EXPECT_THROW(report_page({{"a.json", Report{}}}, ".", general_plan), InputError);
}

TEST(HtmlPage, ReportsWithoutCountsSaySoAndHaveTimes) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) {
    run.stages.clear();
    run.counters.clear();
    run.source_lines.clear();
  }
  report.timing.kernel_ms.assign(report.runs.size(), 12.25);
  const std::string page = report_page({{"a.json", report}}, ".", general_plan);
  EXPECT_EQ(count(page, "<figure class=\"chart\""), 0u);
  EXPECT_EQ(count(page, "These runs counted nothing"), 1u);
  EXPECT_EQ(count(page, "<td>12.2</td>"), report.runs.size());
  EXPECT_EQ(count(page, "The reports have no figures for: "), 1u);
  EXPECT_EQ(headings(page), (std::vector<std::string>{"answer", "frames", "runs", "downloads"}));
}

TEST(HtmlPictures, ArePngFilesReadBack) {
  const Image image{2, 2, {{1, 2, 3}, {255, 0, 0}, {0, 255, 0}, {7, 7, 7}}};
  const Image read = read_png(png(image), "x.png");
  EXPECT_EQ(read.width_px, 2);
  EXPECT_EQ(read.height_px, 2);
  EXPECT_EQ(read.pixels, image.pixels);
  EXPECT_THROW(read_png("no picture", "x.png"), InputError);
  const std::string whole = png(image);
  EXPECT_THROW(read_png(std::string_view(whole).substr(0, whole.size() - 20), "x.png"), InputError);
}

TEST(HtmlPictures, AreNarrowedByAveragingLight) {
  // Black and white average to the square root of half the light: 255 / sqrt(2) = 180.3.
  const Image image{4,
                    2,
                    {{0, 0, 0},
                     {255, 255, 255},
                     {9, 9, 9},
                     {9, 9, 9},
                     {255, 0, 0},
                     {0, 255, 0},
                     {9, 9, 9},
                     {9, 9, 9}}};
  const Image small = narrowed(image, 2);
  EXPECT_EQ(small.width_px, 2);
  EXPECT_EQ(small.height_px, 1);
  // Red: 2 of 4 pixels. Green: 2 of 4. Blue: 1 of 4.
  EXPECT_EQ(small.pixels, (std::vector<Colour>{{180, 180, 128}, {9, 9, 9}}));
  EXPECT_EQ(narrowed(image, 4).pixels, image.pixels);
  EXPECT_EQ(narrowed(image, 3).pixels.size(), 6u);
}

}  // namespace
}  // namespace lanescope
