// SPDX-License-Identifier: MIT
#include "analysis/experiment/frame_pool.h"

#include <gtest/gtest.h>

namespace lanescope {
namespace {

Configuration of_size(int width_px, int samples_per_pixel) {
  Configuration c;
  c.tessellation.width_px = width_px;
  c.tessellation.height_px = 2;
  c.samples_per_pixel = samples_per_pixel;
  return c;
}

TEST(FramePool, GivesEmptyFramesAgain) {
  FramePool pool;
  auto frame = pool.take(of_size(3, 4));
  frame->merge(5, 0.5f, 1);
  const Frame* const memory = frame.get();
  pool.give_back(std::move(frame));
  frame = pool.take(of_size(3, 4));
  EXPECT_EQ(frame.get(), memory);
  EXPECT_EQ(frame->covered(), 0u);
}

TEST(FramePool, FollowsTheSampling) {
  FramePool pool;
  pool.give_back(pool.take(of_size(3, 4)));
  EXPECT_EQ(pool.take(of_size(3, 1))->samples().size(), 6u);
  pool.give_back(std::make_unique<Frame>(of_size(9, 9).sample_grid()));
  EXPECT_EQ(pool.take(of_size(3, 1))->samples().size(), 6u);
}

}  // namespace
}  // namespace lanescope
