// SPDX-License-Identifier: MIT
// Every figure here is computed by hand from the counts below.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/studies/littlest/figures.h"
#include "analysis/studies/littlest/study.h"
#include "workloads/voxels/options.h"

namespace lanescope::littlest {
namespace {

StageRecord stage(const char* name, std::uint64_t issued, std::uint64_t active) {
  StageRecord stage;
  stage.name = name;
  stage.instructions = {{"bit_or", issued, active, 0, 0}};
  return stage;
}

RunRecord run_of(const char* kernel, const char* scene, int width, SkyProjection projection) {
  RunRecord run;
  run.configuration.kernel = kernel;
  run.configuration.scene = scene;
  run.configuration.width = width;
  run.configuration.arguments.set("projection", std::string(name_of(kProjections, projection)));
  run.workload = "voxels";
  run.element = {"probes", "probe", "probe"};
  return run;
}

/// `scan`, `merge` and `project` instructions at W = 8, all with half of the lanes on; 10 probes
/// with 40 octants.
RunRecord program(const char* kernel, const char* scene, SkyProjection projection,
                  std::uint64_t scan, std::uint64_t merge, std::uint64_t project) {
  RunRecord run = run_of(kernel, scene, 8, projection);
  run.stages = {stage("Scan", scan, 4 * scan), stage("Merge", merge, 4 * merge),
                stage("Project", project, 4 * project)};
  run.counters = {{"probes", "", "", 10},
                  {"octants_rendered", "", "", 40},
                  {"octants_full", "", "", 4},
                  {"samples_taken", "", "", 1000},
                  {"samples_occluded", "", "", 250}};
  run.source.counters = {
      {"bricks", "", "", 1}, {"cubes_seen", "", "", 200}, {"cubes_seen_filled", "", "", 30}};
  return run;
}

/// Errors of 10 probes with 60 lights.
RunRecord errors(const char* scene, SkyProjection projection, std::uint64_t sampling) {
  RunRecord run = run_of("sky_error", scene, 1, projection);
  run.counters = {{"probes", "", "", 10},
                  {"lights", "", "", 60},
                  {"squared_sampling_error", "", "", sampling},
                  {"squared_order_error", "", "", 54'000'000},
                  {"squared_total_error", "", "", 60'000'000},
                  {"squared_harmonics_error", "", "", 1'000'000}};
  return run;
}

const Report& report() {
  static const Report sample = [] {
    Report report;
    for (const char* scene : {"hills", "scattered5", "scattered20"}) {
      report.runs.push_back(program("across_image", scene, SkyProjection::kFaces, 400, 800, 2800));
      report.runs.push_back(
          program("across_cameras", scene, SkyProjection::kFaces, 800, 800, 1600));
      report.runs.push_back(
          program("across_image", scene, SkyProjection::kDirections, 400, 400, 28));
      report.runs.push_back(
          program("across_cameras", scene, SkyProjection::kDirections, 800, 400, 16));
      report.runs.push_back(errors(scene, SkyProjection::kFaces, 6'000'000));
      report.runs.push_back(errors(scene, SkyProjection::kDirections, 24'000'000));
    }
    return report;
  }();
  return sample;
}

TableData table(std::string_view name) {
  for (const Table* t : littlest_tables())
    if (t->name == name) return build_table(*t, view_of(study_littlest, report()));
  ADD_FAILURE() << "no table " << name;
  return {};
}

/// The cell of the first row of that label below the heading.
std::string cell(const TableData& data, const std::string& heading, const std::string& label,
                 std::size_t column) {
  auto row = std::find_if(data.rows.begin(), data.rows.end(),
                          [&](const Row& r) { return r.label == heading; });
  row = std::find_if(row, data.rows.end(), [&](const Row& r) { return r.label == label; });
  if (row == data.rows.end()) return "no such row";
  const Cell& found = row->cells.at(column);
  return found.figure ? shown(found) : found.words;
}

TEST(LittlestTables, HaveUtilizationAndInstructionsOfThePrograms) {
  const TableData data = table("utilization");
  EXPECT_EQ(data.columns, std::vector<std::string>{"W = 8"}) << "sky_error has no column";
  const std::string image = "ACROSS_IMAGE, projection = faces";
  EXPECT_EQ(cell(data, image, "Project", 0), "50.0% (0.70)");             // 2800 of 4000
  EXPECT_EQ(cell(data, image, "Instr./probe, all stages", 0), "400.00");  // 4000 / 10
  EXPECT_EQ(cell(data, image, "Instr./octant, all stages", 0), "100.0");  // 4000 / 40
}

TEST(LittlestTables, AreOverHowFullTheWorldIs) {
  const TableData data = table("fill");
  EXPECT_EQ(data.columns, (std::vector<std::string>{"5% filled", "20% filled"}));
  EXPECT_EQ(cell(data, "ACROSS_CAMERAS, projection = faces", "W = 8", 1), "80.0");
  EXPECT_EQ(cell(table("fill_utilization"), "ACROSS_CAMERAS, projection = faces", "W = 8", 0),
            "50.0%");
}

TEST(LittlestTables, NameTheProgramOfTheFewestInstructions) {
  const TableData data = table("winners");
  EXPECT_EQ(cell(data, "projection = faces", "hills", 0), "ACROSS_CAMERAS 80.0");
  EXPECT_EQ(cell(data, "projection = directions", "scattered20", 0), "ACROSS_IMAGE 20.7");
}

/// Also in a table of one scattered world by itself.
TEST(LittlestTables, HaveEachWorldOnce) {
  const ReportView view(report(), std::string("scattered5"));
  EXPECT_EQ(scenes_and_filled(view), (std::vector<std::string>{"scattered5", "scattered20"}));
}

TEST(LittlestTables, HaveWhatTheConversionTakes) {
  const TableData data = table("project");
  const std::string image = "ACROSS_IMAGE, projection = faces";
  EXPECT_EQ(cell(data, image, "Project, instr./octant", 0), "70.0");
  EXPECT_EQ(cell(data, image, "Project, share of all", 0), "70.0%");
}

TEST(LittlestTables, HaveRootMeanSquareErrors) {
  const TableData data = table("errors");
  EXPECT_EQ(data.columns, (std::vector<std::string>{"hills", "scattered5", "scattered20"}));
  EXPECT_EQ(cell(data, "projection = faces", "light, by the samples", 0), "1.0%");  // 1e-4
  EXPECT_EQ(cell(data, "projection = directions", "light, by the samples", 0), "2.0%");
  EXPECT_EQ(cell(data, "projection = faces", "light, by ending at the first order", 0), "3.0%");
  EXPECT_EQ(cell(data, "projection = faces", "harmonics, by the samples", 0), "1.0%");
}

TEST(LittlestTables, TellOfTheWorlds) {
  const TableData data = table("worlds");
  const auto figure = [&](std::size_t column) { return cell(data, "hills", "hills", column); };
  EXPECT_EQ(figure(0), "10");
  EXPECT_EQ(figure(1), "15.0%");
  EXPECT_EQ(figure(2), "4.0000");
  EXPECT_EQ(figure(3), "25.0%");
  EXPECT_EQ(figure(4), "10.0%");
}

TEST(LittlestTables, JudgeWhatTheArticleSays) {
  const TableData data = table("claims");
  const auto row = [&](std::string_view words) {
    const auto found = std::find_if(data.rows.begin(), data.rows.end(), [&](const Row& r) {
      return r.label.find(words) != std::string::npos;
    });
    return found == data.rows.end() ? std::string("none")
                                    : shown(found->cells[0]) + ' ' + found->cells[1].words;
  };
  EXPECT_EQ(row("its share, ACROSS_IMAGE"), "70.0% yes");
  EXPECT_EQ(row("its share, ACROSS_CAMERAS"), "50.0% no");
  EXPECT_EQ(row("cheaper: times, ACROSS_IMAGE"), "100.00x yes");
  EXPECT_EQ(row("16 x 16 pixels"), "1.0% yes");
}

TEST(LittlestStudy, IsAboutItsKernelsAlone) {
  EXPECT_TRUE(study_littlest.is_about(report()));
  EXPECT_FALSE(study_littlest.is_about(Report()));
}

}  // namespace
}  // namespace lanescope::littlest
