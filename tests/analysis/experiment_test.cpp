// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment.h"

#include <gtest/gtest.h>

#include "analysis/report/report_json.h"
#include "simulator/base/error.h"
#include "workloads/micropolygons/scene.h"

namespace lanescope {
namespace {

Configuration small(const std::string& kernel, int width, Micropolygon shape) {
  Configuration c;
  c.kernel = kernel;
  c.width = width;
  c.scene = scenes().front()->name;
  c.tessellation.width_px = 96;
  c.tessellation.height_px = 60;
  c.options.shape = shape;
  return c;
}

std::vector<Configuration> several() {
  return {small("lockstep", 8, Micropolygon::kTriangle), small("repack", 8, Micropolygon::kQuad),
          small("repack", 64, Micropolygon::kTriangle), small("lockstep", 64, Micropolygon::kQuad)};
}

std::string text_without_timing(Report report) {
  report.timing = {};
  report.timing.kernel_ms.resize(report.runs.size());
  return report_text(report);
}

TEST(Experiment, IsTheSameAtAnyNumberOfThreads) {
  ExperimentOptions options;
  const std::string once = text_without_timing(run_experiment(several(), options));
  for (const int threads : {1, 2, 3}) {
    options.threads = threads;
    EXPECT_EQ(text_without_timing(run_experiment(several(), options)), once) << threads;
  }
}

TEST(Experiment, SharingATessellationChangesNothing) {
  const Report together = run_experiment(several(), {});
  for (std::size_t i = 0; i < several().size(); ++i) {
    Report alone = run_experiment({several()[i]}, {});
    Report part = together;
    part.runs = {together.runs[i]};
    part.instructions = alone.instructions;  // Those of the others are listed too.
    EXPECT_EQ(text_without_timing(part), text_without_timing(alone)) << i;
  }
}

TEST(Experiment, KernelsAndWidthsAgreeOnHitsAndFrame) {
  const Report report = run_experiment(several(), {});
  EXPECT_EQ(report.runs[0].hits_hash, report.runs[2].hits_hash);
  EXPECT_EQ(report.runs[0].frame_hash, report.runs[2].frame_hash);
  EXPECT_EQ(report.runs[0].scene_hash, report.runs[2].scene_hash);
  EXPECT_EQ(report.runs[1].hits_hash, report.runs[3].hits_hash);
  EXPECT_NE(report.runs[0].scene_hash, report.runs[1].scene_hash);
  EXPECT_GT(report.runs[0].samples_covered, 0u);
}

TEST(Experiment, HandsOutEveryFrameAndCompletesItsProgress) {
  int frames = 0;
  double last = 0.0;
  ExperimentOptions options;
  options.on_frame = [&](const FinishedFrame& finished) {
    ++frames;
    EXPECT_EQ(finished.frame.grid().width_px(), 96);
  };
  options.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  run_experiment(several(), options);
  EXPECT_EQ(frames, 4);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(Experiment, UncountedRunsHaveNoStages) {
  Configuration c = small("lockstep", 8, Micropolygon::kTriangle);
  const Report counted = run_experiment({c}, {});
  c.mode = Mode::kUncounted;
  const Report uncounted = run_experiment({c}, {});
  EXPECT_TRUE(uncounted.runs[0].stages.empty());
  EXPECT_EQ(uncounted.runs[0].hits_hash, counted.runs[0].hits_hash);
  EXPECT_EQ(uncounted.runs[0].frame_hash, counted.runs[0].frame_hash);
}

TEST(Experiment, ExplainsEveryInstructionThatWasIssued) {
  const Report report = run_experiment(several(), {});
  EXPECT_FALSE(report.instructions.empty());
  EXPECT_NO_THROW(parse_report(report_text(report), "report"));
}

TEST(Experiment, RefusesScenesAndKernelsThatDoNotExist) {
  Configuration c = small("lockstep", 8, Micropolygon::kTriangle);
  c.scene = "nowhere";
  EXPECT_THROW(run_experiment({c}, {}), InputError);
  c = small("nothing", 8, Micropolygon::kTriangle);
  EXPECT_THROW(run_experiment({c}, {}), InputError);
}

TEST(Experiment, TurningThePictureKeepsTheSurfaces) {
  Configuration c = small("lockstep", 8, Micropolygon::kTriangle);
  const Report straight = run_experiment({c}, {});
  c.turn_degrees = 12.0f;
  const Report turned = run_experiment({c}, {});
  EXPECT_NE(turned.runs[0].scene_hash, straight.runs[0].scene_hash);
}

}  // namespace
}  // namespace lanescope
