// SPDX-License-Identifier: MIT
#include "analysis/experiment/output_pool.h"

#include <gtest/gtest.h>

#include "kernels/micropolygons/frame.h"
#include "tests/analysis/configured.h"
#include "tests/analysis/test_kind.h"

namespace lanescope {
namespace {

/// A pool, and configurations whose outputs are frames.
class PooledFrames : public ::testing::Test {
 protected:
  static Configuration of_size(unsigned width_px, unsigned samples_per_pixel) {
    return testing::configured({{"kernel", "lockstep"},
                                {"width_px", width_px},
                                {"height_px", 2u},
                                {"samples_per_pixel", samples_per_pixel}});
  }
  std::unique_ptr<Output> take(const Configuration& c) { return pool.take(c, *open_source(c)); }
  std::unique_ptr<Frame> take_frame(const Configuration& c) {
    return std::unique_ptr<Frame>(static_cast<Frame*>(take(c).release()));
  }
  void give_back(const Configuration& c, std::unique_ptr<Output> output) {
    pool.give_back(find_kernel(c.kernel), std::move(output));
  }

  OutputPool pool;
};

TEST_F(PooledFrames, AreEmptyAgain) {
  const Configuration c = of_size(3, 4);
  auto frame = take_frame(c);
  frame->merge(5, 0.5f, 1);
  const Frame* const memory = frame.get();
  give_back(c, std::move(frame));
  frame = take_frame(c);
  EXPECT_EQ(frame.get(), memory);
  EXPECT_EQ(frame->covered(), 0u);
}

TEST_F(PooledFrames, FollowTheSampling) {
  give_back(of_size(3, 4), take(of_size(3, 4)));
  EXPECT_EQ(take_frame(of_size(3, 1))->samples().size(), 6u);
  give_back(of_size(9, 9), take(of_size(9, 9)));
  EXPECT_EQ(take_frame(of_size(3, 1))->samples().size(), 6u);
}

TEST_F(PooledFrames, AreNotTakenForOutputsOfAnotherKind) {
  const Configuration frame = of_size(3, 4);
  const Configuration numbers = testing::configured({{"kernel", "sum"}});
  auto first = take(numbers);
  const Output* const memory = first.get();
  give_back(frame, take(frame));
  give_back(numbers, std::move(first));
  const auto second = take(numbers);
  EXPECT_EQ(second.get(), memory);
  EXPECT_NE(dynamic_cast<NumberForEachPiece*>(second.get()), nullptr);
  EXPECT_NE(dynamic_cast<NumberForEachPiece*>(take(numbers).get()), nullptr);
  EXPECT_NE(dynamic_cast<Frame*>(take(frame).get()), nullptr);
}

}  // namespace
}  // namespace lanescope
