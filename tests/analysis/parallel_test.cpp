// SPDX-License-Identifier: MIT
#include "analysis/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lanescope {
namespace {

TEST(ParallelFor, DoesEachItemOnce) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> done(100);
    parallel_for(threads, 100, [&](int worker, int item) {
      EXPECT_LT(worker, threads);
      ++done[static_cast<std::size_t>(item)];
    });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST(StartableThreads, AreThoseAskedForAndTheCallersAtLeast) {
  EXPECT_EQ(startable_threads(1), 1);
  EXPECT_EQ(startable_threads(3), 3);
}

TEST(ParallelFor, DoesNothingForNoItems) {
  parallel_for(4, 0, [](int, int) { FAIL(); });
}

TEST(ParallelFor, RethrowsAndStops) {
  std::atomic<int> done{0};
  const auto run = [&] {
    parallel_for(2, 100000, [&](int, int item) {
      if (item == 10) throw std::runtime_error("item 10");
      ++done;
    });
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_LT(done, 100000 - 1);
}

TEST(ParallelFor, ReportsProgressInOrder) {
  int last = 0;
  parallel_for(
      1, 10, [](int, int) {},
      [&](int done) {
        EXPECT_EQ(done, last + 1);
        last = done;
      });
  EXPECT_EQ(last, 10);
}

}  // namespace
}  // namespace lanescope
