// SPDX-License-Identifier: MIT
#include "analysis/experiment/sample_maps.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "analysis/experiment/experiment.h"
#include "analysis/pictures/heat_map.h"
#include "analysis/pictures/palette.h"
#include "kernels/micropolygons/counters.h"

namespace lanescope {
namespace {

Configuration small() {
  Configuration c;
  c.scene = "teapot";
  c.width = 8;
  c.tessellation.width_px = 48;
  c.tessellation.height_px = 30;
  return c;
}

std::uint64_t counter(const RunRecord& run, const std::string& name) {
  for (const CounterRecord& record : run.counters)
    if (record.name == name) return record.value;
  return 0;
}

template <class Watcher, class... Args>
std::unique_ptr<Watcher> watched(const Configuration& c, int threads, Args... args) {
  auto watcher = std::make_unique<Watcher>(c.sample_grid(), args...);
  watch_samples(c, *watcher, threads, [](double) {});
  return watcher;
}

using What = SampleCounter::What;

TEST(SampleMaps, AddUpToTheCountersOfARun) {
  for (const Micropolygon shape : {Micropolygon::kTriangle, Micropolygon::kQuad}) {
    Configuration c = small();
    c.options.shape = shape;
    const RunRecord run = run_experiment({c}, {}).runs.front();
    const auto sum = [&](What what) {
      const auto counts = watched<SampleCounter>(c, 2, what)->counts();
      return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    };
    EXPECT_EQ(sum(What::kTests), counter(run, "tests"));
    EXPECT_EQ(sum(What::kHits), counter(run, "hits"));
  }
}

TEST(SampleMaps, SeeAMicropolygonWhereverTheFrameIsCovered) {
  const Configuration c = small();
  const auto visible = watched<VisibleMicropolygons>(c, 2);
  ExperimentOptions options;
  options.on_frame = [&](const FinishedFrame& finished) {
    const auto& samples = finished.frame.samples();
    for (std::size_t i = 0; i < samples.size(); ++i)
      EXPECT_EQ(visible->id(i) == VisibleMicropolygons::kNone, samples[i] == Frame::kEmpty);
  };
  run_experiment({c}, options);
}

TEST(SampleMaps, AreTheSameAtAnyNumberOfThreads) {
  const Configuration c = small();
  EXPECT_EQ(watched<SampleCounter>(c, 1, What::kTests)->counts(),
            watched<SampleCounter>(c, 3, What::kTests)->counts());
  EXPECT_EQ(micropolygon_picture(c.sample_grid(), *watched<VisibleMicropolygons>(c, 1)).pixels,
            micropolygon_picture(c.sample_grid(), *watched<VisibleMicropolygons>(c, 3)).pixels);
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

TEST(HeatMap, EndsItsScaleBelowTheFewLargestCounts) {
  HeatMap map{1001, 1, std::vector<std::uint64_t>(1001, 8), 4, "title", "axis"};
  map.counts[0] = 0;
  map.counts[1] = 800;
  EXPECT_EQ(scale_end(map), 2.0);
  map.counts.assign(1001, 0);
  EXPECT_EQ(scale_end(map), 1.0);
}

TEST(HeatMap, IsAPngWithAPixelForEachCount) {
  HeatMap map{300, 200, std::vector<std::uint64_t>(300 * 200, 0), 1, "title", "axis"};
  for (std::size_t i = 0; i < 1000; ++i) map.counts[i] = 6;
  const std::string bytes = heat_map_png(map);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  header.format = PNG_FORMAT_RGB;
  std::vector<Colour> pixels(std::size_t{header.width} * header.height);
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(std::count(pixels.begin(), pixels.end(), kNothing), 300 * 200 - 1000);
  EXPECT_EQ(std::count(pixels.begin(), pixels.end(), heat_colour(1.0)), 1000);
}

TEST(Palette, HeatGrowsLighter) {
  const auto light = [](Colour c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(light(heat_colour(i / 100.0)), light(heat_colour((i + 1) / 100.0)) + 1.0) << i;
  EXPECT_EQ(heat_colour(-1.0), heat_colour(0.0));
  EXPECT_EQ(heat_colour(2.0), heat_colour(1.0));
}

}  // namespace
}  // namespace lanescope
