// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/sample_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "analysis/experiment/draw.h"
#include "analysis/experiment/experiment.h"
#include "kernels/micropolygons/frame.h"
#include "tests/analysis/configured.h"

namespace lanescope {
namespace {

Configuration small(const char* micropolygon = "triangle") {
  return testing::configured({{"kernel", "lockstep"},
                              {"micropolygon", micropolygon},
                              {"scene", "teapot"},
                              {"width_lanes", 8u},
                              {"width_px", 48u},
                              {"height_px", 30u}});
}

/// What a view of the rasterizers shows.
template <class Shown>
std::unique_ptr<Shown> drawn(std::string_view view, const Configuration& c, int threads) {
  const auto found = std::find_if(kSampleViews.begin(), kSampleViews.end(),
                                  [&](const View& v) { return v.name == view; });
  std::unique_ptr<Output> output = draw(c, *found, threads, [](double) {});
  return std::unique_ptr<Shown>(static_cast<Shown*>(output.release()));
}

TEST(SampleViews, AddUpToTheCountersOfARun) {
  for (const char* micropolygon : {"triangle", "quad"}) {
    const Configuration c = small(micropolygon);
    const RunRecord run = run_experiment({c}, {}).runs.front();
    for (const char* view : {"tests", "hits"}) {
      const auto shown = drawn<SampleCounter>(view, c, 2);
      EXPECT_EQ(std::accumulate(shown->counts().begin(), shown->counts().end(), std::uint64_t{0}),
                run.counter(view));
      const std::vector<std::uint64_t> pixels = shown->picture()->counts;
      EXPECT_EQ(pixels.size(), 48u * 30u);
      EXPECT_EQ(std::accumulate(pixels.begin(), pixels.end(), std::uint64_t{0}), run.counter(view));
    }
  }
}

TEST(SampleViews, SeeAMicropolygonWhereverTheFrameIsCovered) {
  const Configuration c = small();
  const auto visible = drawn<VisibleMicropolygons>("micropolygons", c, 2);
  ExperimentOptions options;
  options.on_output = [&](const FinishedOutput& finished) {
    const auto& samples = static_cast<const Frame&>(finished.output).samples();
    for (std::size_t i = 0; i < samples.size(); ++i)
      EXPECT_EQ(visible->id(i) == VisibleMicropolygons::kNone, samples[i] == Frame::kEmpty);
  };
  run_experiment({c}, options);
}

TEST(SampleViews, AreTheSameAtAnyNumberOfThreads) {
  const Configuration c = small();
  EXPECT_EQ(drawn<SampleCounter>("tests", c, 1)->counts(),
            drawn<SampleCounter>("tests", c, 3)->counts());
  EXPECT_EQ(drawn<VisibleMicropolygons>("micropolygons", c, 1)->picture()->pixels,
            drawn<VisibleMicropolygons>("micropolygons", c, 3)->picture()->pixels);
}

TEST(VisibleMicropolygons, AreTheNearestThenOfTheSmallerColourThenOfTheSmallerId) {
  VisibleMicropolygons visible(SampleGrid(2, 1, 1, false, 0));
  const auto expect_after_hit = [&](std::uint64_t id, float depth, std::uint32_t colour,
                                    std::uint64_t expected) {
    visible.hit(id, 1, depth, colour);
    EXPECT_EQ(visible.id(1), expected);
  };
  expect_after_hit(5, 2.0f, 7, 5);
  expect_after_hit(6, 3.0f, 1, 5);
  expect_after_hit(8, 2.0f, 6, 8);
  expect_after_hit(9, 2.0f, 6, 8);
  expect_after_hit(4, 2.0f, 6, 4);
  expect_after_hit(3, -1.0f, 0, 4);
  EXPECT_EQ(visible.id(0), VisibleMicropolygons::kNone);
}

TEST(PixelSums, AddTheSamplesOfAPixel) {
  const SampleGrid grid(2, 2, 4, false, 0);  // 4 x 4 cells.
  EXPECT_EQ(pixel_sums(grid, {1, 2, 3, 4, 10, 20, 30, 40, 0, 0, 0, 5, 0, 1, 0, 0}),
            (std::vector<std::uint64_t>{33, 77, 1, 5}));
}

}  // namespace
}  // namespace lanescope
