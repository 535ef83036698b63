// SPDX-License-Identifier: MIT
// Whole runs of the program on small frames.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/base/json_text.h"
#include "analysis/report/report_json.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using testing::lanescope_program;
using testing::Outcome;

class EndToEnd : public testing::InEmptyDirectory {};

const std::string kSmall = " --resolution 96x60 ";

/// The report without what depends on the clock and the host.
std::string comparable(const std::string& text) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(text);
  json.erase("timing");
  return json_text(json);
}

TEST_F(EndToEnd, ReportsAreTheSameAtAnyNumberOfThreadsAndTwice) {
  const std::string experiment =
      "run --scene ballroll,teapot --micropolygon triangle,quad --width 8,64 --json -" + kSmall;
  const std::string once = comparable(run(experiment + "--threads 1").output);
  EXPECT_EQ(comparable(run(experiment + "--threads 2").output), once);
  EXPECT_EQ(comparable(run(experiment + "--threads 2").output), once);
}

TEST_F(EndToEnd, RunPrintsASummaryAndWritesAReport) {
  const Outcome outcome = run("run --scene teapot --width 8 --json r.json" + kSmall);
  for (const char* words : {"lockstep on teapot, triangles", "repack on teapot, triangles",
                            "Test Stream-load", "Instr./mp", "sample_test_efficiency"})
    EXPECT_NE(outcome.output.find(words), std::string::npos) << words << "\n" << outcome.output;
  const Report report = parse_report(file("r.json"), "r.json");
  EXPECT_EQ(report.runs.size(), 2u);
  EXPECT_EQ(report.command, "lanescope run --width 8 --scene teapot --resolution 96x60");
  EXPECT_EQ(entries(), std::set<std::string>{"r.json"});
}

TEST_F(EndToEnd, EveryOptionReachesTheReport) {
  run("run --kernel repack --scene teapot --frame 3 --turn -12 --resolution 64x40 --dice-area 2 "
      "--grid 8 --drain 100 --msaa 9 --jitter off --seed 5 --edges precomputed "
      "--stream-load-threshold 0.5 --cull off --mode checked --width 8 --micropolygon quad "
      "--json r.json");
  const Configuration c = parse_report(file("r.json"), "r.json").runs.front().configuration;
  EXPECT_EQ(c.kernel, "repack");
  EXPECT_EQ(c.scene, "teapot");
  EXPECT_EQ(c.frame, 3);
  EXPECT_EQ(c.turn_degrees, -12.0f);
  EXPECT_EQ(c.tessellation.width_px, 64);
  EXPECT_EQ(c.tessellation.height_px, 40);
  EXPECT_EQ(c.tessellation.dice_area_px, 2.0f);
  EXPECT_EQ(c.tessellation.grid_limit, 8);
  EXPECT_EQ(c.tessellation.packet_capacity, 100);
  EXPECT_EQ(c.samples_per_pixel, 9);
  EXPECT_FALSE(c.jitter);
  EXPECT_EQ(c.seed, 5u);
  EXPECT_EQ(c.options.edges, Edges::kPrecomputed);
  EXPECT_EQ(c.options.stream_load_threshold, 0.5f);
  EXPECT_FALSE(c.options.cull_backfaces);
  EXPECT_EQ(c.mode, Mode::kChecked);
  EXPECT_EQ(c.shape(), Micropolygon::kQuad);
}

TEST_F(EndToEnd, ReferenceRunsAtItsOwnWidth) {
  const Outcome outcome = run("run --kernel rastmp,lockstep --scene teapot --json -" + kSmall);
  const Report report = parse_report(outcome.output, "-");
  ASSERT_GT(report.runs.size(), 1u);
  EXPECT_EQ(report.runs[0].configuration.width, 1);
  for (const RunRecord& r : report.runs) EXPECT_EQ(r.hits_hash, report.runs[0].hits_hash);
}

TEST_F(EndToEnd, TablesWriteADirectory) {
  const Outcome outcome = run("tables --scene ballroll,teapot --out a/out" + kSmall);
  EXPECT_EQ(entries("a/out"), (std::set<std::string>{"report.json", "tables.json", "tables.txt",
                                                     "tables.md", "tables.csv", "tables.tex",
                                                     "frame-ballroll.png", "frame-teapot.png"}));
  EXPECT_EQ(file("a/out/frame-teapot.png").substr(1, 3), "PNG");
  EXPECT_NE(outcome.errors.find(" runs took "), std::string::npos);
  EXPECT_NE(outcome.errors.find("results are in a/out/"), std::string::npos);
  EXPECT_NE(outcome.output.find("Table 4.1: "), std::string::npos);
  EXPECT_EQ(file("a/out/tables.txt").rfind(outcome.output.substr(0, 500), 0), 0u);
}

TEST_F(EndToEnd, TablesFromAReportAreThoseOfTheRun) {
  const Outcome first = run("tables --scene talking --json r.json" + kSmall);
  const Outcome again = run("tables --from r.json --json s.json");
  EXPECT_EQ(again.output, first.output);
  EXPECT_EQ(file("s.json"), file("r.json"));
  EXPECT_EQ(again.errors, "");
}

TEST_F(EndToEnd, OneTableInEachFormat) {
  run("tables --scene talking --json r.json" + kSmall);
  const std::string from = "tables --from r.json --table overhead --format ";
  EXPECT_EQ(run(from + "text").output.rfind("Table 4.3: REPACK", 0), 0u);
  EXPECT_EQ(run(from + "markdown").output.rfind("### Table 4.3", 0), 0u);
  EXPECT_EQ(run(from + "csv").output.rfind("table,scenes,", 0), 0u);
  EXPECT_EQ(run(from + "latex").output.rfind("% Table 4.3", 0), 0u);
  EXPECT_NE(run("tables --from r.json --format json").output.find("\"table_4_6\""),
            std::string::npos);
  EXPECT_NE(run(from + "text --table claims --per-scene").output.find("Of: talking"),
            std::string::npos);
}

TEST_F(EndToEnd, RenderDrawsAPicture) {
  run("render --scene teapot -o teapot.png" + kSmall);
  EXPECT_EQ(file("teapot.png").substr(1, 3), "PNG");
  EXPECT_EQ(entries(), std::set<std::string>{"teapot.png"});
}

TEST_F(EndToEnd, MeshesAreScenes) {
  write("a tetra.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const Outcome outcome =
      run("run --mesh 'a tetra.obj' --patches linear --width 8 --json r.json" + kSmall);
  const Report report = parse_report(file("r.json"), "r.json");
  EXPECT_EQ(report.runs[0].configuration.scene, "a tetra.obj");
  EXPECT_GT(report.runs[0].samples_covered, 0u);
  EXPECT_NE(report.command.find("--mesh 'a tetra.obj'"), std::string::npos);
}

TEST_F(EndToEnd, NothingIsHalfWrittenWhenTheRunFails) {
  write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  write("r.json", "old");
  const Outcome outcome = lanescope_program("run --mesh bad.obj --json r.json", directory());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors.rfind("lanescope: bad.obj:", 0), 0u) << outcome.errors;
  EXPECT_EQ(file("r.json"), "old");
  EXPECT_EQ(entries(), (std::set<std::string>{"bad.obj", "r.json"}));
}

TEST_F(EndToEnd, ABrokenReportIsRefusedWithItsPlace) {
  run("run --scene teapot --width 8 --json r.json" + kSmall);
  write("cut.json", file("r.json").substr(0, 400));
  const Outcome cut = lanescope_program("tables --from cut.json --json s.json", directory());
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.errors.rfind("lanescope: cut.json:", 0), 0u) << cut.errors;
  EXPECT_EQ(entries(), (std::set<std::string>{"r.json", "cut.json"}));
}

}  // namespace
}  // namespace lanescope
