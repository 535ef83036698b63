// SPDX-License-Identifier: MIT
#include "analysis/sweep/sweep_spec.h"

#include <gtest/gtest.h>

#include "analysis/configuration/configuration_json.h"
#include "simulator/base/error.h"
#include "workloads/micropolygons/surface_scene.h"

namespace lanescope {
namespace {

using Names = std::vector<std::string>;

/// A spec of the members that follow `schema`.
std::string spec(const std::string& members) {
  return R"({"schema": {"name": "lanescope-sweep", "version": 1}, )" + members + "}";
}

std::vector<Configuration> parse(const std::string& members) {
  return parse_sweep_spec(spec(members), "s.json");
}

/// Each cell as its values of these parameters, separated by spaces.
Names cells(const std::string& members, const Names& parameters) {
  Names all;
  for (const Configuration& c : parse(members)) {
    std::string cell;
    for (const std::string& name : parameters)
      cell += (cell.empty() ? "" : " ") + value_text(value_of(c, name));
    all.push_back(cell);
  }
  return all;
}

TEST(SweepSpec, IsACrossProductInWhichTheLastParameterVariesFastest) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["lockstep", "repack"], "width_lanes": 8,
                                    "seed": [3, 1, 2]})",
                  {"kernel", "width_lanes", "seed"}),
            (Names{"lockstep 8 3", "lockstep 8 1", "lockstep 8 2", "repack 8 3", "repack 8 1",
                   "repack 8 2"}));
}

TEST(SweepSpec, WhatIsNotNamedIsAsOnTheCommandLine) {
  const std::vector<Configuration> all = parse(R"("parameters": {})");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.front(), resolved({}));
  EXPECT_EQ(all.front().kernel, "lockstep");
  EXPECT_EQ(all.front().width, 16);
}

TEST(SweepSpec, EveryParameterCanBeNamed) {
  const std::string named = R"({"kernel": "repack", "width_lanes": 8, "micropolygon": "quad",
      "scene": "teapot", "mesh_patches": null, "frame": 3, "turn_degrees": -12.5,
      "mode": "checked", "cull_backfaces": false, "edges": "precomputed",
      "stream_load_threshold": 0.3, "width_px": 64, "height_px": 40, "samples_per_pixel": 9,
      "jitter": false, "seed": 18446744073709551615, "dice_area_px": 0.01, "grid_limit": 8,
      "packet_capacity": 100, "grid_overlap_px": 0.25, "observe_every": 3})";
  const std::vector<Configuration> all = parse("\"parameters\": " + named);
  ASSERT_EQ(all.size(), 1u);
  // Whatever their order.
  EXPECT_EQ(nlohmann::json(configuration_json(all.front())), nlohmann::json::parse(named));
}

TEST(SweepSpec, ExcludeDropsCellsThatMatchAllMembersOfAnEntry) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["lockstep", "repack"], "seed": [1, 2, 3]},
                     "exclude": [{"kernel": "repack", "seed": [1, 3]}, {"seed": 2,
                                  "kernel": "lockstep", "edges": "inline"}, {"seed": 7}])",
                  {"kernel", "seed"}),
            (Names{"lockstep 1", "lockstep 3", "repack 2"}));
}

TEST(SweepSpec, ExcludeSeesDefaultFrames) {
  const int frame = find_surface_scene("teapot").default_frame;
  EXPECT_EQ(cells(fmt::format(R"("parameters": {{"scene": ["teapot", "ballroll"]}},
                                 "exclude": [{{"scene": "teapot", "frame": {}}}])",
                              frame),
                  {"scene"}),
            (Names{"ballroll"}));
}

TEST(SweepSpec, ExcludedCellsNeedNotBePossible) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["rastmp", "lockstep"], "width_lanes": [1, 8]},
                     "exclude": [{"kernel": "rastmp", "width_lanes": 8},
                                 {"kernel": "lockstep", "width_lanes": 1}])",
                  {"kernel", "width_lanes"}),
            (Names{"rastmp 1", "lockstep 8"}));
}

TEST(SweepSpec, IncludeTakesWhatItDoesNotNameFromSingleValuesOrDefaults) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["repack", "lockstep"], "width_lanes": [8],
                                    "grid_limit": 4},
                     "exclude": [{"kernel": "repack"}],
                     "include": [{"seed": [5, 6]}, {"kernel": "repack", "grid_limit": 2}])",
                  {"kernel", "width_lanes", "grid_limit", "seed"}),
            (Names{"lockstep 8 4 1", "lockstep 8 4 5", "lockstep 8 4 6", "repack 8 2 1"}));
}

TEST(SweepSpec, CellsThatAreEqualAreOne) {
  EXPECT_EQ(cells(R"("parameters": {"seed": [1, 2, 1]}, "include": [{"seed": [2, 3]}])", {"seed"}),
            (Names{"1", "2", "3"}));
  EXPECT_EQ(cells(R"("parameters": {"dice_area_px": [1, 1.0]})", {"dice_area_px"}), Names{"1"});
}

TEST(SweepSpec, MeshesAreScenesThatEndInObj) {
  EXPECT_EQ(cells(R"("parameters": {"scene": ["teapot", "m/a.obj"],
                                    "mesh_patches": ["pn", "phong"]})",
                  {"scene", "mesh_patches"}),
            (Names{"teapot none", "m/a.obj pn", "m/a.obj phong"}));
  EXPECT_EQ(cells(R"("parameters": {"scene": "a.obj"})", {"mesh_patches", "frame"}),
            Names{"pn none"});
}

TEST(SweepSpec, CellsDifferOnlyInWhatTheyTake) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["lockstep", "repack"],
                                    "stream_load_threshold": [0, 0.5]})",
                  {"kernel", "stream_load_threshold"}),
            (Names{"lockstep none", "repack 0", "repack 0.5"}));
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["sum", "running_sum"], "start": [0, 5]})",
                  {"kernel", "start"}),
            (Names{"sum none", "running_sum 0", "running_sum 5"}));
  EXPECT_EQ(cells(R"("parameters": {"kernel": "sum", "scene": ["rising", "a.numbers"],
                                    "segments": [1, 2]})",
                  {"scene", "segments"}),
            (Names{"rising 1", "rising 2", "a.numbers none"}));
}

TEST(SweepSpec, OfSeveralKinds) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["lockstep", "sum"], "width_px": [64, 32],
                                    "piece_size": 5})",
                  {"kernel", "width_px", "piece_size"}),
            (Names{"lockstep 64 none", "lockstep 32 none", "sum none 5"}));
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["lockstep", "sum"], "scene": ["teapot", "rising"]},
                     "exclude": [{"kernel": "lockstep", "scene": "rising"},
                                 {"kernel": "sum", "scene": "teapot"}])",
                  {"kernel", "scene"}),
            (Names{"lockstep teapot", "sum rising"}));
  EXPECT_EQ(cells(R"("parameters": {"kernel": "lockstep", "start": 3},
                     "include": [{"kernel": "running_sum"}])",
                  {"kernel", "start"}),
            (Names{"lockstep none", "running_sum 3"}));
}

TEST(SweepSpec, DefaultsExcludeCellsThatCannotBe) {
  EXPECT_EQ(cells(R"("parameters": {"kernel": ["rastmp", "lockstep"], "width_lanes": 8},
                     "exclude": [{"kernel": "rastmp", "scene": "ballroll", "edges": "inline"}])",
                  {"kernel"}),
            (Names{"lockstep"}));
}

TEST(SweepSpec, TellsWhatVaries) {
  EXPECT_EQ(varying_parameters(parse(R"("parameters": {"scene": ["teapot", "ballroll"],
                                        "frame": 1, "seed": [1, 2], "width_px": 10})")),
            (Names{"scene", "seed"}));
  EXPECT_EQ(varying_parameters(parse(R"("parameters": {"kernel": ["lockstep", "repack", "sum"]})")),
            (Names{"kernel", "scene"}))
      << "not to take a parameter is no value";
  EXPECT_EQ(varying_parameters(parse(R"("parameters": {})")), Names{});
}

TEST(SweepSpec, RefusesToHaveCellsWithoutEnd) {
  std::string numbers = "1";
  for (int i = 2; i <= 400; ++i) numbers += fmt::format(", {}", i);
  const std::string members =
      fmt::format(R"("parameters": {{"seed": [{0}], "packet_capacity": [{0}]}})", numbers);
  try {
    parse(members);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "s.json:/parameters/packet_capacity: gives more than 100000 cells");
  }
}

struct Mistake {
  std::string text;
  std::string complaint;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.text; }

class SweepSpecMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(SweepSpecMistakes, AreRefusedWithTheirPlace) {
  try {
    parse_sweep_spec(GetParam().text, "s.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("s.json:" + GetParam().complaint, 0), 0u)
        << error.what();
  }
}

Mistake parameter(const std::string& member, const std::string& complaint) {
  return {spec("\"parameters\": {" + member + "}"), "/parameters/" + complaint};
}

/// Of the test program, which has kinds of its own beside those of the house.
std::string all_kernels() { return list_or(names_of(kernels())); }
std::string all_scenes() {
  Names names;
  for (const Workload* workload : workloads())
    for (const SceneInfo& scene : workload->scenes) names.emplace_back(scene.name);
  return list_or(names);
}

INSTANTIATE_TEST_SUITE_P(
    Documents, SweepSpecMistakes,
    ::testing::Values(
        Mistake{"{\n",
                "2:1: is not JSON: syntax error while parsing object key - unexpected end "
                "of input; expected string literal"},
        Mistake{"[]", "/: an array is not an object"},
        Mistake{"{}", "/: the member 'schema' is missing"},
        Mistake{R"({"schema": {"name": "lanescope-report", "version": 2}})",
                "/schema/name: \"lanescope-report\" is not \"lanescope-sweep\""},
        Mistake{R"({"schema": {"name": "lanescope-sweep", "version": 2}})",
                "/schema/version: 2 is not 1, the version that this program reads"},
        Mistake{spec(R"("include": [])"), "/: the member 'parameters' is missing"},
        Mistake{spec(R"("parameters": {}, "exlude": [])"),
                "/: unknown member 'exlude'; did you mean 'exclude'?"},
        Mistake{spec(R"("parameters": [])"), "/parameters: an array is not an object"},
        Mistake{spec(R"("parameters": {}, "include": {})"), "/include: an object is not an array"},
        Mistake{spec(R"("parameters": {}, "include": [{}])"),
                "/include/0: names no parameter; include at least one"},
        Mistake{spec(R"("parameters": {}, "exclude": [{"seed": 1}, {"sead": 1}])"),
                "/exclude/1: unknown member 'sead'; did you mean 'seed'?"},
        Mistake{spec(R"("parameters": {}, "exclude": [{"kernel": "repak"}])"),
                "/exclude/0/kernel: \"repak\" is not a kernel; use " + all_kernels() +
                    "; did you mean 'repack'?"},
        Mistake{spec(R"("parameters": {}, "exclude": [{"scene": "teapto"}])"),
                "/exclude/0/scene: \"teapto\" is not a scene; use "},
        Mistake{spec(R"("parameters": {"kernel": "lockstep"}, "include": [{"start": 1}])"),
                "/include/0/start: no cell takes it; it is a parameter of running_sum"},
        Mistake{spec(R"("parameters": {"seed": [1, 2]}, "exclude": [{"seed": [1, 2]}])"),
                "/: no cell is left; everything is excluded"},
        Mistake{spec(R"("parameters": {"seed": 1, "seed": 2})"),
                " an object has the member 'seed' twice"}));

INSTANTIATE_TEST_SUITE_P(
    Values, SweepSpecMistakes,
    ::testing::Values(
        Mistake{spec(R"("parameters": {"width": 8})"), "/parameters: unknown member 'width'"},
        parameter(R"("seed": [])", "seed: an array is not a value or a list of at least one"),
        parameter(R"("seed": -1)", "seed: -1 is not an integer from 0 to 2^64 - 1"),
        parameter(R"("seed": [1, [2]])", "seed/1: an array is not an integer from 0 to 2^64 - 1"),
        parameter(R"("kernel": ["lockstep", "repak"])",
                  "kernel/1: \"repak\" is not a kernel; use " + all_kernels() +
                      "; did you mean 'repack'?"),
        parameter(R"("kernel": 8)", "kernel: 8 is not a word"),
        parameter(
            R"("scene": "teapto")",
            "scene: \"teapto\" is not a scene; use " + all_scenes() +
                ", or name a file that ends in .obj, .vox or .numbers; did you mean 'teapot'?"),
        parameter(R"("kernel": "sum", "scene": ["rising", "teapot"])",
                  "scene/1: 'teapot' is not a scene of numbers; use scattered or rising, or name "
                  "a number list file (.numbers) (or exclude it)"),
        parameter(R"("width_lanes": [8, 65])", "width_lanes/1: 65 is not an integer from 1 to 64"),
        parameter(R"("kernel": ["lockstep", "rastmp"], "width_lanes": [1, 8])",
                  "width_lanes/1: 8 is not a width of rastmp; it is scalar, use 1 (or exclude it)"),
        Mistake{spec(R"("parameters": {"kernel": "sum", "segments": 64})"),
                "/parameters: segment_pieces is left out, and 256 pieces are too many; use at most "
                "200 in "
                "all segments (or exclude it)"},
        Mistake{spec(R"("parameters": {"width_lanes": 8}, "include": [{"kernel": "rastmp"}])"),
                "/parameters/width_lanes: 8 is not a width of rastmp; it is scalar, use 1"},
        parameter(R"("stream_load_threshold": [0, 0.5])",
                  "stream_load_threshold: no cell takes it; it is a parameter of repack"),
        parameter(R"("kernel": ["lockstep", "sum"], "start": 1)",
                  "start: no cell takes it; it is a parameter of running_sum"),
        parameter(R"("kernel": "sum", "scene": "a.numbers", "segments": 2)",
                  "segments: no cell takes it; it does not apply to their scenes"),
        parameter(R"("kernel": "sum", "segments": [1, 64], "segment_pieces": [4, 64])",
                  "segment_pieces/0: 256 pieces are too many; use at most 200 in all segments (or "
                  "exclude it)"),
        parameter(R"("micropolygon": "hexagon")",
                  "micropolygon: \"hexagon\" is not triangle or quad"),
        parameter(R"("mesh_patches": "flat")", "mesh_patches: \"flat\" is not linear, pn or phong"),
        parameter(R"("scene": ["ballroll"], "frame": [0, 48])",
                  "frame/1: 48 is not a frame of ballroll; use 0 to 47 (or exclude it)"),
        parameter(R"("frame": 2000000)", "frame: 2000000 is not an integer from 0 to 1048576"),
        parameter(R"("frame": 1.5)", "frame: 1.5 is not an integer from 0 to 1048576"),
        parameter(R"("scene": "a.obj", "frame": 1)",
                  "frame: no cell takes it; it does not apply to their scenes"),
        parameter(R"("mesh_patches": "pn")",
                  "mesh_patches: no cell takes it; it does not apply to their scenes"),
        parameter(R"("turn_degrees": 400)", "turn_degrees: 400 is not a number from -360 to 360"),
        parameter(R"("mode": "trace")", "mode: \"trace\" is not counting, checked or uncounted"),
        parameter(R"("cull_backfaces": "on")", "cull_backfaces: \"on\" is not true or false"),
        parameter(R"("edges": true)", "edges: true is not inline or precomputed"),
        parameter(R"("kernel": "repack", "stream_load_threshold": 1.5)",
                  "stream_load_threshold: 1.5 is not a number from 0 to 1"),
        parameter(R"("width_px": 0)", "width_px: 0 is not an integer from 1 to 16384"),
        parameter(R"("height_px": "60")", "height_px: \"60\" is not an integer from 1 to 16384"),
        parameter(R"("width_px": 16000, "height_px": 9)",
                  "width_px: 16000x9 is outside 1x1 to 8192x8192 at 4 samples a pixel"),
        parameter(R"("samples_per_pixel": 5)", "samples_per_pixel: 5 is not 1, 4, 9, 16 or 64"),
        parameter(R"("dice_area_px": 0)", "dice_area_px: 0 is not a number from 0.01 to 10000"),
        parameter(R"("grid_limit": 129)", "grid_limit: 129 is not an integer from 1 to 128"),
        parameter(R"("packet_capacity": 0)",
                  "packet_capacity: 0 is not an integer from 1 to 1048576"),
        parameter(R"("grid_overlap_px": -1)", "grid_overlap_px: -1 is not a number from 0 to 1"),
        parameter(R"("observe_every": -1)",
                  "observe_every: -1 is not an integer from 0 to 1048576"),
        parameter(R"("jitter": null)", "jitter: null is not true or false")));

}  // namespace
}  // namespace lanescope
