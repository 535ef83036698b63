// SPDX-License-Identifier: MIT
// What the program says of meshes that it takes although something is wrong with them.
#include "analysis/report/report_json.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using testing::Outcome;

const std::string kSmall = " --resolution 64x40 --width 8 --kernel lockstep";

class MeshWarnings : public testing::InEmptyDirectory {
 protected:
  MeshWarnings() {
    write("triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nl 1 2\nf 1 2 3\n");
    write("behind.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 3 2 1\n");
  }
};

const std::string kSkipped =
    "lanescope: warning: triangle.obj: skipped 1 point, line, curve or surface (first in line 4)\n";
const std::string kBehind =
    "lanescope: warning: behind.obj: nothing faces the viewer; 1 of its triangles are seen from "
    "behind, and drawn only with --cull off\n";

TEST_F(MeshWarnings, EachIsALineOnStandardErrorOnce) {
  EXPECT_EQ(run("run --mesh triangle.obj" + kSmall).errors, kSkipped);
  EXPECT_EQ(run("run --scene triangle.obj,teapot --dice-area 1,2" + kSmall).errors, kSkipped)
      << "opened twice, said once";
  EXPECT_EQ(run("run --scene teapot" + kSmall).errors, "");
}

TEST_F(MeshWarnings, EveryCommandThatOpensAMeshHasThem) {
  EXPECT_EQ(run("render --mesh triangle.obj -o a.png --resolution 64x40").errors, kSkipped);
  EXPECT_EQ(run("render --mesh triangle.obj --show sample-tests -o b.png --resolution 64x40", 2)
                .errors.find("warning"),
            std::string::npos)
      << "nothing was opened";
  EXPECT_EQ(run("trace --mesh triangle.obj --batches 0:1 --listing l.txt" + kSmall).errors,
            kSkipped);
  EXPECT_EQ(run("annotate --mesh triangle.obj --observe-every 1" + kSmall).errors, kSkipped);
  EXPECT_NE(run("study luong --scene triangle.obj --micropolygon triangle" + kSmall)
                .errors.find(kSkipped),
            std::string::npos);
  write("spec.json", R"({"schema": {"name": "lanescope-sweep", "version": 1}, "parameters":
    {"scene": "triangle.obj", "kernel": ["lockstep", "repack"], "width_lanes": 8,
     "width_px": 64, "height_px": 40}})");
  EXPECT_NE(run("sweep spec.json --out cells").errors.find(kSkipped), std::string::npos);
}

/// Figures of nothing are n/a, and the warning says why; with --cull off there is something.
TEST_F(MeshWarnings, NothingThatFacesTheViewerIsNoMistake) {
  const Outcome outcome = run("run --mesh behind.obj --json r.json" + kSmall);
  EXPECT_EQ(outcome.errors, kBehind);
  EXPECT_NE(outcome.output.find("n/a"), std::string::npos) << outcome.output;
  run("report r.json -o r.html");
  EXPECT_NE(file("r.html").find("There is nothing to compare"), std::string::npos);
  run("csv r.json");
  const Report culled = parse_report(file("r.json"), "r.json");
  run("run --mesh behind.obj --cull off --json s.json" + kSmall);
  const Report drawn = parse_report(file("s.json"), "s.json");
  EXPECT_NE(culled.runs[0].output.hash, drawn.runs[0].output.hash);
}

TEST_F(MeshWarnings, SweepsTakeTheEndingInAnyCase) {
  const std::string mesh = file("triangle.obj");
  for (const char* name : {"a.OBJ", "a.Obj"}) {
    write(name, mesh);
    EXPECT_EQ(run("run --mesh " + std::string(name) + kSmall).errors.find("triangle"),
              std::string::npos);
    write("spec.json",
          R"({"schema": {"name": "lanescope-sweep", "version": 1}, "parameters": {"scene": ")" +
              std::string(name) +
              R"(", "kernel": "lockstep", "width_lanes": 8, "width_px": 64, "height_px": 40}})");
    run("sweep spec.json --out cells");
  }
}

}  // namespace
}  // namespace lanescope
