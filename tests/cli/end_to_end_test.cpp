// SPDX-License-Identifier: MIT
// Whole runs of the program on small frames.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/base/json_text.h"
#include "analysis/configuration/configuration.h"
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
  for (const char* words :
       {"lockstep on teapot, micropolygon = triangle", "repack on teapot, micropolygon = triangle",
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
      "--grid-overlap 0.25 --observe-every 2 --json r.json");
  const Configuration c = parse_report(file("r.json"), "r.json").runs.front().configuration;
  const std::vector<std::pair<std::string, Value>> expected{{"kernel", std::string("repack")},
                                                            {"width_lanes", std::uint64_t{8}},
                                                            {"scene", std::string("teapot")},
                                                            {"mode", std::string("checked")},
                                                            {"observe_every", std::uint64_t{2}},
                                                            {"micropolygon", std::string("quad")},
                                                            {"width_px", std::uint64_t{64}},
                                                            {"height_px", std::uint64_t{40}},
                                                            {"samples_per_pixel", std::uint64_t{9}},
                                                            {"dice_area_px", 2.0f},
                                                            {"grid_limit", std::uint64_t{8}},
                                                            {"packet_capacity", std::uint64_t{100}},
                                                            {"grid_overlap_px", 0.25f},
                                                            {"frame", std::uint64_t{3}},
                                                            {"mesh_patches", {}},
                                                            {"turn_degrees", -12.0f},
                                                            {"cull_backfaces", false},
                                                            {"edges", std::string("precomputed")},
                                                            {"stream_load_threshold", 0.5f},
                                                            {"jitter", false},
                                                            {"seed", std::uint64_t{5}}};
  for (const auto& [name, value] : expected)
    EXPECT_EQ(value_of(c, name), value) << name << " is " << value_text(value_of(c, name));
  EXPECT_EQ(expected.size(), parameters_of(find_kernel("repack")).size());
}

/// The values that runs of a report have for some parameters, in the order of the runs.
std::vector<std::string> values_in(const Report& report, const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const RunRecord& run : report.runs) {
    std::string text;
    for (const std::string& name : names)
      text += (text.empty() ? "" : " ") + value_text(value_of(run.configuration, name));
    all.push_back(text);
  }
  return all;
}

/// Widths are of kernels that have lanes, and the scene says which kernels run.
TEST_F(EndToEnd, KernelsAndWidthsFollowFromWhatIsNamed) {
  const auto runs_of = [&](const std::string& arguments) {
    const std::string small = " --world-size 16 --mode uncounted --observe-every 0 --json -";
    return values_in(parse_report(run("run " + arguments + small).output, "-"),
                     {"kernel", "width_lanes"});
  };
  EXPECT_EQ(runs_of("--scene stones --kernel voxel_rays,across_cameras --width 8,24"),
            (std::vector<std::string>{"voxel_rays 1", "across_cameras 8", "across_cameras 24"}));
  EXPECT_EQ(runs_of("--scene stones --width 8"),
            (std::vector<std::string>{"across_image 8", "across_cubes 8", "across_cameras 8",
                                      "repacked_cameras 8"}));
}

TEST_F(EndToEnd, EveryParameterTakesAList) {
  const std::string uncounted = " --mode uncounted --observe-every 0 --json -";
  const auto report_of = [&](const std::string& arguments) {
    return parse_report(run("run " + arguments + uncounted).output, "-");
  };
  // Scene, then the kind of work, then kernel, its parameters, width.
  EXPECT_EQ(
      values_in(
          report_of("--scene teapot,ballroll --msaa 1,4 --width 9,4 --kernel lockstep" + kSmall),
          {"scene", "samples_per_pixel", "width_lanes"}),
      (std::vector<std::string>{"teapot 1 9", "teapot 1 4", "teapot 4 9", "teapot 4 4",
                                "ballroll 1 9", "ballroll 1 4", "ballroll 4 9", "ballroll 4 4"}));
  // A kernel has no more runs for parameters that it does not take.
  EXPECT_EQ(values_in(report_of("--stream-load-threshold 0,0.5 --jitter on,off --width 8" + kSmall),
                      {"kernel", "stream_load_threshold", "jitter"}),
            (std::vector<std::string>{"lockstep none on", "lockstep none off", "repack 0 on",
                                      "repack 0 off", "repack 0.5 on", "repack 0.5 off"}));
  // Parameters of one option go together.
  EXPECT_EQ(
      values_in(report_of("--resolution 48x30,32x20 --width 8 --kernel repack --seed 3:5"),
                {"width_px", "height_px", "seed"}),
      (std::vector<std::string>{"48 30 3", "48 30 4", "48 30 5", "32 20 3", "32 20 4", "32 20 5"}));
  // What a scene does not have makes no further runs.
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(values_in(report_of("--scene teapot,flat.obj --frame 1,2 --patches linear,pn --width 8 "
                                "--kernel repack" +
                                kSmall),
                      {"scene", "frame", "mesh_patches"}),
            (std::vector<std::string>{"teapot 1 none", "teapot 2 none", "flat.obj none linear",
                                      "flat.obj none pn"}));
}

TEST_F(EndToEnd, WidthsTakeRanges) {
  const Report report = parse_report(
      run("run --kernel lockstep --scene teapot --width 1:4,7,62:64 --json -" + kSmall).output,
      "-");
  EXPECT_EQ(values_in(report, {"width_lanes"}),
            (std::vector<std::string>{"1", "2", "3", "4", "7", "62", "63", "64"}));
  for (const RunRecord& r : report.runs) EXPECT_EQ(r.results_hash, report.runs[0].results_hash);
  EXPECT_EQ(
      report.command,
      "lanescope run --kernel lockstep --width 1:4,7,62:64 --scene teapot --resolution 96x60");
}

TEST_F(EndToEnd, AGroupOfScenesHasAWord) {
  const auto scenes = [&](const std::string& word) {
    return values_in(
        parse_report(run("run --kernel lockstep --width 8 --mode uncounted --observe-every 0 "
                         "--json - --scene " +
                         word + kSmall)
                         .output,
                     "-"),
        {"scene"});
  };
  EXPECT_EQ(scenes("all"), testing::listed("scenes", "; frames "));
  EXPECT_EQ(scenes("thesis"), testing::listed("scenes", "; one of `thesis`"));
  EXPECT_LT(scenes("thesis").size(), scenes("all").size());
}

TEST_F(EndToEnd, ReferenceRunsAtItsOwnWidth) {
  const Outcome outcome = run("run --kernel rastmp,lockstep --scene teapot --json -" + kSmall);
  const Report report = parse_report(outcome.output, "-");
  ASSERT_GT(report.runs.size(), 1u);
  EXPECT_EQ(report.runs[0].configuration.width, 1);
  for (const RunRecord& r : report.runs) EXPECT_EQ(r.results_hash, report.runs[0].results_hash);
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

TEST_F(EndToEnd, TablesAreTheFirstStudy) {
  const Outcome tables = run("tables --scene talking --out a --threads 1" + kSmall);
  const Outcome study = run("study luong --scene talking --out b --threads 1" + kSmall);
  EXPECT_EQ(study.output, tables.output);
  EXPECT_EQ(entries("a"), entries("b"));
  for (const std::string& name : entries("a")) {
    if (name.ends_with(".json")) continue;  // Those name their command.
    EXPECT_EQ(file("a/" + name), file("b/" + name)) << name;
  }
  const Report report = parse_report(file("b/report.json"), "report.json");
  EXPECT_EQ(report.command, "lanescope study luong --scene talking --resolution 96x60");
  EXPECT_EQ(parse_report(file("a/report.json"), "report.json").command,
            "lanescope tables --scene talking --resolution 96x60");
  EXPECT_EQ(report.runs.size(), 16u);
}

TEST_F(EndToEnd, StudiesAreListed) {
  EXPECT_EQ(run("study").output, run("list studies").output);
  EXPECT_NE(run("study luong --help").output.find("Usage: lanescope study luong"),
            std::string::npos);
}

TEST_F(EndToEnd, StudiesTakeOtherParameters) {
  run("study luong --scene teapot --width 5 --kernel repack --micropolygon quad --json r.json" +
      kSmall);
  EXPECT_EQ(values_in(parse_report(file("r.json"), "r.json"),
                      {"kernel", "width_lanes", "scene", "micropolygon"}),
            std::vector<std::string>{"repack 5 teapot quad"});
}

TEST_F(EndToEnd, ShowPrintsTheTablesOfAnyRun) {
  run("run --scene ballroll,teapot --width 8,16 --json r.json" + kSmall);
  const std::string all = run("show r.json").output;
  for (const char* words : {"Test Stream-load", "W = 16", "sample_test_efficiency", "frame_merge"})
    EXPECT_NE(all.find(words), std::string::npos) << words << "\n" << all;
  const std::string one = run("show r.json --table utilization").output;
  EXPECT_NE(all.find(one.substr(0, 200)), std::string::npos) << one;
  EXPECT_LT(one.size(), all.size());
  EXPECT_NE(run("show r.json --table utilization --per-scene").output.find("Of: teapot"),
            std::string::npos);
  EXPECT_EQ(run("show r.json --table utilization --format markdown").output.rfind("### ", 0), 0u);
  // A table for each setting of what was varied.
  run("run --scene teapot --width 8 --msaa 1,4 --json s.json" + kSmall);
  const std::string settings = run("show s.json --table utilization").output;
  for (const char* words : {"samples_per_pixel = 1", "samples_per_pixel = 4"})
    EXPECT_NE(settings.find(words), std::string::npos) << words << "\n" << settings;
  run("run --scene teapot --width 8 --mode uncounted --json u.json" + kSmall);
  for (const char* command : {"show u.json --table utilization", "study luong --from u.json"})
    EXPECT_EQ(run(command, 2).errors, "lanescope: u.json: has no figures for these tables\n");
}

TEST_F(EndToEnd, AnnotateSelectsRunsByAnyParameter) {
  run("run --scene ballroll,teapot --width 8,16 --msaa 1,4 --observe-every 1 --json r.json" +
      kSmall);
  const std::string annotate = "annotate --from r.json ";
  EXPECT_NE(run(annotate + "--kernel repack --width 8 --msaa 4 --scene teapot")
                .output.find("repack, W = 8"),
            std::string::npos);
  EXPECT_EQ(run(annotate + "--msaa 4 --scene all").output, run(annotate + "--msaa 4").output);
  const auto complaint = [&](const std::string& options) {
    return run(annotate + options, 2).errors;
  };
  EXPECT_EQ(complaint("--width 24"),
            "lanescope: --width: '24' selects no run of r.json; its runs have 8 or 16\n");
  EXPECT_EQ(complaint("--msaa 9 --kernel repack"),
            "lanescope: --msaa: '9' selects no run of r.json; those that other options select have "
            "1 or 4\n");
  EXPECT_EQ(complaint("--resolution 48x30"),
            "lanescope: --resolution: '48x30' selects no run of r.json; its runs have 96x60\n");
  EXPECT_EQ(complaint("--scene talking"),
            "lanescope: --scene: 'talking' selects no run of r.json; its runs have ballroll or "
            "teapot\n");
  EXPECT_EQ(complaint("--threads 1"), "lanescope: --threads excludes --from\n");
  run("run --scene teapot --width 8 --observe-every 0 --json none.json" + kSmall);
  EXPECT_EQ(
      run("annotate --from none.json", 2).errors,
      "lanescope: none.json: no run that was asked for has observed source lines; run it with "
      "--observe-every 1, in counting mode\n");
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
  EXPECT_GT(report.runs[0].output.counters.front().value, 0u);
  EXPECT_NE(report.command.find("--mesh 'a tetra.obj'"), std::string::npos);
}

TEST_F(EndToEnd, AFileIsASceneAmongOthers) {
  write("tetra.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  run("run --scene tetra.OBJ,teapot --kernel repack --width 8 --json r.json" + kSmall);
  run("run --mesh tetra.OBJ --kernel repack --width 8 --json s.json" + kSmall);
  const Report both = parse_report(file("r.json"), "r.json");
  EXPECT_EQ(values_in(both, {"scene"}), (std::vector<std::string>{"tetra.OBJ", "teapot"}));
  EXPECT_EQ(both.runs[0].output.hash, parse_report(file("s.json"), "s.json").runs[0].output.hash);
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
