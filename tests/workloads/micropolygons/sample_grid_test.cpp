// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/sample_grid.h"

#include <gtest/gtest.h>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

TEST(SampleGrid, CountsCellsAndSamples) {
  for (const int axis : {1, 2, 3, 4, 8}) {
    const SampleGrid grid(30, 20, axis * axis, true, 1);
    EXPECT_EQ(grid.samples_per_axis(), axis);
    EXPECT_EQ(grid.width_cells(), 30 * axis);
    EXPECT_EQ(grid.height_cells(), 20 * axis);
    EXPECT_EQ(grid.sample_count(), 600 * axis * axis);
  }
}

std::string message(int width_px, int height_px, int samples_per_pixel) {
  try {
    const SampleGrid grid(width_px, height_px, samples_per_pixel, true, 1);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(SampleGrid, ReportsWhatIsOutOfRange) {
  EXPECT_EQ(message(100, 100, 5), "--msaa: 5 is not a sample count; use 1, 4, 9, 16 or 64");
  EXPECT_EQ(message(0, 100, 4),
            "--resolution: 0x100 is outside 1x1 to 8192x8192 at 4 samples a pixel");
  EXPECT_EQ(message(100, 2049, 64),
            "--resolution: 100x2049 is outside 1x1 to 2048x2048 at 64 samples a pixel");
}

}  // namespace
}  // namespace lanescope
