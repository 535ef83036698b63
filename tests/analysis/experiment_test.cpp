// SPDX-License-Identifier: MIT
#include "analysis/experiment/experiment.h"

#include <gtest/gtest.h>

#include "analysis/experiment/draw.h"
#include "analysis/experiment/observation.h"
#include "analysis/experiment/width_independence.h"
#include "analysis/report/report_json.h"
#include "kernels/micropolygons/frame.h"
#include "simulator/base/error.h"
#include "simulator/check.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/test_kind.h"

namespace lanescope {
namespace {

Configuration small(const std::string& kernel, unsigned width, const std::string& micropolygon) {
  return testing::configured({{"kernel", kernel},
                              {"width_lanes", width},
                              {"width_px", 96u},
                              {"height_px", 60u},
                              {"micropolygon", micropolygon}});
}

std::vector<Configuration> several() {
  return {small("lockstep", 8, "triangle"), small("repack", 8, "quad"),
          small("repack", 64, "triangle"), small("lockstep", 64, "quad")};
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

TEST(Experiment, SharingASourceChangesNothing) {
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
  EXPECT_EQ(report.runs[0].results_hash, report.runs[2].results_hash);
  EXPECT_EQ(report.runs[0].output.hash, report.runs[2].output.hash);
  EXPECT_EQ(report.runs[0].source.hash, report.runs[2].source.hash);
  EXPECT_EQ(report.runs[1].results_hash, report.runs[3].results_hash);
  EXPECT_NE(report.runs[0].source.hash, report.runs[1].source.hash);
  EXPECT_EQ(report.runs[0].output.counters.at(0).name, "samples_covered");
  EXPECT_GT(report.runs[0].output.counters.at(0).value, 0u);
}

TEST(Experiment, HandsOutEveryOutputAndCompletesItsProgress) {
  int frames = 0;
  double last = 0.0;
  ExperimentOptions options;
  options.on_output = [&](const FinishedOutput& finished) {
    ++frames;
    EXPECT_EQ(static_cast<const Frame&>(finished.output).grid().width_px(), 96);
  };
  options.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  run_experiment(several(), options);
  EXPECT_EQ(frames, 4);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

/// A count of 0 would be one.
TEST(Experiment, UncountedRunsHaveNoCounts) {
  Configuration c = small("lockstep", 8, "triangle");
  const Report counted = run_experiment({c}, {});
  c.mode = Mode::kUncounted;
  const Report uncounted = run_experiment({c}, {});
  EXPECT_TRUE(uncounted.runs[0].stages.empty());
  EXPECT_TRUE(uncounted.runs[0].counters.empty());
  EXPECT_TRUE(uncounted.runs[0].metrics.empty());
  EXPECT_TRUE(uncounted.runs[0].series.empty());
  EXPECT_EQ(uncounted.runs[0].output.counter("samples_covered"),
            counted.runs[0].output.counter("samples_covered"));
  EXPECT_EQ(uncounted.runs[0].results_hash, counted.runs[0].results_hash);
  EXPECT_EQ(uncounted.runs[0].output.hash, counted.runs[0].output.hash);
}

TEST(Experiment, ChecksThatResultsDoNotDependOnTheWidth) {
  Configuration narrow = small("repack", 7, "quad");
  narrow.mode = Mode::kChecked;
  Configuration wide = narrow;
  wide.width = 64;
  Report report = run_experiment({narrow, wide}, {});
  ++report.runs[1].results_hash;
  try {
    require_width_independence(report.runs);
    ADD_FAILURE() << "nothing was found";
  } catch (const FailedCheck& e) {
    EXPECT_EQ(e.check(), Check::kWidth);
    EXPECT_NE(std::string(e.what()).find("results at W = 64 are not those at W = 7"),
              std::string::npos)
        << e.what();
  }
  report.runs[1].configuration.arguments.set("micropolygon", std::string("triangle"));
  EXPECT_NO_THROW(require_width_independence(report.runs));
}

TEST(Experiment, ExplainsEveryInstructionThatWasIssued) {
  const Report report = run_experiment(several(), {});
  EXPECT_FALSE(report.instructions.empty());
  EXPECT_NO_THROW(parse_report(report_text(report), "report"));
}

TEST(Experiment, RefusesScenesAndKernelsThatDoNotExist) {
  Configuration c = small("lockstep", 8, "triangle");
  c.scene = "nowhere";
  EXPECT_THROW(run_experiment({c}, {}), InputError);
  c = small("lockstep", 8, "triangle");
  c.kernel = "nothing";
  EXPECT_THROW(run_experiment({c}, {}), InputError);
}

TEST(Experiment, TurningThePictureKeepsTheSurfaces) {
  Configuration c = small("lockstep", 8, "triangle");
  const Report straight = run_experiment({c}, {});
  set_value(c, "turn_degrees", 12.0f);
  const Report turned = run_experiment({c}, {});
  EXPECT_NE(turned.runs[0].source.hash, straight.runs[0].source.hash);
}

// ---- Kernels of any kind

Configuration numbers(const std::string& kernel, unsigned width = 4) {
  return testing::configured({{"kernel", kernel}, {"width_lanes", width}});
}

TEST(AnyKind, IsReportedAsItsDescriptorsSay) {
  Configuration c = testing::configured(
      {{"kernel", "running_sum"}, {"scene", "rising"}, {"start", 7u}, {"width_lanes", 8u}});
  const RunRecord run = run_experiment({c}, {}).runs.front();
  EXPECT_EQ(run.configuration, c);
  EXPECT_EQ(run.workload, "numbers");
  EXPECT_EQ(run.element.counter, "numbers");
  EXPECT_EQ(run.element.abbreviation, "num");
  EXPECT_EQ(run.elements(), 120u);
  EXPECT_EQ(run.counter("highs"), 120u) << "each is higher than all before";
  EXPECT_EQ(run.source.pieces, 12u);
  ASSERT_EQ(run.source.counters.size(), 2u);
  EXPECT_EQ(run.source.counters[0].name, "numbers_made");
  EXPECT_EQ(run.source.counters[0].value, 120u) << "a sum";
  EXPECT_EQ(run.source.counters[1].value, 10u) << "a maximum";
  ASSERT_EQ(run.output.counters.size(), 1u);
  EXPECT_EQ(run.output.counters[0].value, 12u);
  ASSERT_EQ(run.stages.size(), 2u);
  EXPECT_EQ(run.stages[1].name, "Raise");
  EXPECT_EQ(run.stages[1].total().active, 120u);
  ASSERT_EQ(run.metrics.size(), 1u);
  EXPECT_EQ(run.metrics[0].numerator, "highs");
}

TEST(AnyKind, SourceHashIsTheSumOverItsPieces) {
  const Configuration c = numbers("sum");
  std::uint64_t hash = 0;
  const auto source = open_source(c);
  for (int segment = 0; segment < source->segment_count(); ++segment)
    source->produce(segment, [&](const Work& piece) { hash += piece.hash(); });
  ExperimentOptions options;
  options.threads = 3;
  EXPECT_EQ(run_experiment({c}, options).runs[0].source.hash, hash);
  EXPECT_EQ(run_experiment({numbers("running_sum")}, options).runs[0].source.hash, hash);
}

/// Two kinds, both orders, several widths.
std::vector<Configuration> mixed() {
  return {numbers("running_sum", 4), small("lockstep", 8, "triangle"), numbers("sum", 4),
          numbers("running_sum", 7), numbers("running_sum", 64),       numbers("sum", 1)};
}

TEST(AnyKind, SequentialKernelsAreTheSameAtAnyNumberOfThreads) {
  std::vector<Configuration> all = mixed();
  for (Configuration& c : all) c.observe_every = 3;
  ExperimentOptions options;
  const std::string once = text_without_timing(run_experiment(all, options));
  for (const int threads : {2, 4, 16}) {
    options.threads = threads;
    EXPECT_EQ(text_without_timing(run_experiment(all, options)), once) << threads;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    Report part = run_experiment({all[i]}, options);
    const Report whole = run_experiment(all, {});
    Report expected = whole;
    expected.runs = {whole.runs[i]};
    expected.instructions = part.instructions;
    EXPECT_EQ(text_without_timing(part), text_without_timing(expected)) << i;
  }
}

/// The numbers higher than all before in those pieces that are observed.
std::uint64_t observed_highs(const Configuration& c) {
  std::uint64_t highs = 0;
  std::optional<std::uint64_t> highest;
  const auto source = open_source(c);
  for (int segment = 0; segment < source->segment_count(); ++segment)
    source->produce(segment, [&](const Work& piece) {
      for (const std::uint64_t number : static_cast<const Numbers&>(piece).values) {
        if (highest && number <= *highest) continue;
        highest = number;
        if (is_observed(piece, c.observe_every)) ++highs;
      }
    });
  return highs;
}

TEST(AnyKind, SequentialKernelsAreObservedOnAnOutputOfTheirOwn) {
  Configuration c = numbers("running_sum");
  c.observe_every = 0;
  const RunRecord unobserved = run_experiment({c}, {}).runs.front();
  for (const int every : {1, 2, 5}) {
    c.observe_every = every;
    const RunRecord run = run_experiment({c}, {}).runs.front();
    EXPECT_EQ(run.output.hash, unobserved.output.hash);
    EXPECT_EQ(run.results_hash, unobserved.results_hash);
    EXPECT_EQ(run.counter("highs"), unobserved.counter("highs"));
    std::uint64_t highs = 0;
    for (const SourceLineRecord& line : run.source_lines)
      if (line.stage == "Raise") highs += line.active;
    EXPECT_EQ(highs, observed_highs(c)) << every;
    if (every == 1) {
      EXPECT_EQ(highs, run.counter("highs"));
    }
    EXPECT_GT(highs, 0u);
  }
}

TEST(AnyKind, AViewIsDrawnOnAnyNumberOfThreads) {
  const Configuration c = numbers("running_sum", 8);
  const View& view = k_sum.views.front();
  const std::uint64_t expected = run_experiment({numbers("sum")}, {}).runs[0].output.hash;
  for (const int threads : {1, 3}) {
    double last = 0.0;
    EXPECT_EQ(draw(c, view, threads, [&](double fraction) { last = fraction; })->hash(), expected);
    if (threads == 1) {
      EXPECT_EQ(last, 1.0);
    }
  }
}

TEST(AnyKind, WhatAKernelThrowsIsRethrown) {
  const Configuration c = testing::configured({{"kernel", "sum"}, {"refused", 0u}});
  Configuration rising = c;
  rising.scene = "rising";
  ExperimentOptions options;
  options.threads = 2;
  EXPECT_THROW(run_experiment({rising}, options), InputError);
}

TEST(Estimates, ExtrapolateFromAFewSegments) {
  const std::vector<Configuration> all = mixed();
  EXPECT_GT(estimated_thread_ms(all, {}), 0.0);
}

}  // namespace
}  // namespace lanescope
