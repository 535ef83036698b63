// SPDX-License-Identifier: MIT
// `lanescope trace` and the pictures of `lanescope render`, as a user runs them.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/base/files.h"
#include "tests/cli/program.h"
#include "tests/scratch_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;
using testing::lanescope_program;
using testing::Outcome;

class TraceCommand : public ::testing::Test {
 protected:
  Outcome run(const std::string& arguments) const {
    return lanescope_program(arguments + " --scene tigerjump --resolution 96x60",
                             directory_.path());
  }
  std::string file(const std::string& name) const { return read_file(directory_ / name); }
  std::set<std::string> entries() const { return directory_.entries(); }

 private:
  const testing::ScratchDirectory directory_;
};

TEST_F(TraceCommand, WritesTheSameFilesTwice) {
  const std::string command = "trace --width 8 --batches 40:60";
  for (const char* name : {"a", "b"}) {
    std::string outputs;
    for (const char* output : {"png", "svg", "chrome", "listing"})
      outputs += std::string(" --") + output + " " + name + "." + output;
    const Outcome outcome = run(command + outputs);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output + outcome.errors, "");
  }
  EXPECT_EQ(entries(), (std::set<std::string>{"a.png", "a.svg", "a.chrome", "a.listing", "b.png",
                                              "b.svg", "b.chrome", "b.listing"}));
  for (const char* output : {".png", ".svg", ".chrome", ".listing"})
    EXPECT_EQ(file(std::string("a") + output), file(std::string("b") + output)) << output;
  EXPECT_EQ(run(command + " --listing -").output, file("a.listing"));
}

TEST_F(TraceCommand, ShowsKernelsInTheirOrder) {
  const std::string listing =
      run("trace --width 8 --kernel repack,lockstep --batches 40:41 --listing -").output;
  const std::size_t repack = listing.find(
      "# repack on tigerjump, micropolygon = triangle, resolution = 96x60, frame = 26, W = 8\n");
  EXPECT_EQ(repack, 0u);
  EXPECT_GT(listing.find("# lockstep on tigerjump, micropolygon = triangle, resolution = 96x60, "
                         "frame = 26, W = 8\n"),
            repack);
  EXPECT_NE(listing.find("# batch 40\n"), listing.npos);
  EXPECT_EQ(listing.find("# batch 41\n"), listing.npos);
}

TEST_F(TraceCommand, MistakesEndWithStatus2AndOneLine) {
  const auto expect_complaint = [&](const std::string& arguments, const std::string& complaint) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.errors, "lanescope: " + complaint + "\n");
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(entries(), std::set<std::string>{});
  };
  const std::string trace = "trace --width 8 --png x.png ";
  expect_complaint("trace", "trace: writes nothing; give --png, --svg, --chrome or --listing");
  expect_complaint("trace --png - --listing -", "trace: only one output can go to standard output");
  expect_complaint("trace --png missing/x.png",
                   "missing/x.png: cannot be written: No such file or directory");
  expect_complaint(trace + "--batches x", "--batches: 'x' is not of the form M:N, as 400:404");
  expect_complaint(trace + "--batches 5:3",
                   "--batches: 5:3 holds no batch; M:N is from M to N - 1");
  expect_complaint(trace + "--batches 5:5",
                   "--batches: 5:5 holds no batch; M:N is from M to N - 1");
  expect_complaint(trace + "--batches -1:5",
                   "--batches: '-1' is not an integer from 0 to 1073741824");
  const Outcome beyond = run(trace + "--batches 40:100000");
  EXPECT_EQ(beyond.status, 2);
  EXPECT_EQ(
      beyond.errors.rfind("lanescope: --batches: 40:100000 reaches beyond the last batch; the "
                          "scene has ",
                          0),
      0u)
      << beyond.errors;
  expect_complaint(trace + "--region 1,2",
                   "--region: '2' is not of the form X,Y,WxH, as 800,500,64x64");
  expect_complaint(trace + "--region 1,2,0x3", "--region: '0' is not an integer from 1 to 16384");
  expect_complaint(trace + "--region 90,2,7x3",
                   "--region: 90,2,7x3 is not inside the frame, which is 96x60");
  expect_complaint(trace + "--region 0,0,1x1", "--region: no micropolygon meets it");
  expect_complaint("trace --kernel rastmp --width 1 --png x.png",
                   "--kernel: rastmp issues no instructions that could be traced");
  const std::string one =
      "trace: shows one scene at a time; give one scene and width, and one value of what else "
      "there "
      "is";
  expect_complaint("trace --width 8,16 --png x.png", one);
  expect_complaint("trace --micropolygon triangle,quad --png x.png", one);
  expect_complaint("trace --stream-load-threshold 0,0.5 --png x.png", one);
  for (const std::string option : {"--mode", "--observe-every", "--threads"})
    expect_complaint(trace + option + " 1", option + ": is not an option of trace");
  expect_complaint(
      "render -o x.png --show test",
      "--show: 'test' is not output, frame, tests, hits, micropolygons, cubes, occlusion, ambient, "
      "lighting or cubemaps; did you mean 'tests'?");
  expect_complaint("render -o x.png --show hits --kernel repack",
                   "--kernel: does not change hits; leave it out, or use --show output");
}

TEST_F(TraceCommand, RenderShowsWhatHappensAtSamples) {
  for (const char* what : {"tests", "hits", "micropolygons"}) {
    for (const char* threads : {"1", "2"}) {
      const Outcome outcome = run(std::string("render --show ") + what + " --threads " + threads +
                                  " -o " + what + threads + ".png");
      EXPECT_EQ(outcome.status, 0) << outcome.errors;
    }
    const std::string once = file(std::string(what) + "1.png");
    EXPECT_EQ(once.substr(1, 3), "PNG");
    EXPECT_EQ(file(std::string(what) + "2.png"), once);
  }
}

TEST_F(TraceCommand, RenderDrawsTheOutputOfAnyKernel) {
  const std::string render = "render --micropolygon quad -o ";
  for (const char* asked :
       {"a.png", "b.png --show output", "c.png --show frame", "d.png --kernel repack --width 5",
        "e.png --kernel rastmp", "f.png --mode checked"}) {
    const Outcome outcome = run(render + asked);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
  }
  for (const char* name : {"b.png", "c.png", "d.png", "e.png", "f.png"})
    EXPECT_EQ(file(name), file("a.png")) << name;
}

}  // namespace
}  // namespace lanescope
