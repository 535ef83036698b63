// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/frame.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "kernels/kernel.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

Frame small_frame() { return Frame(SampleGrid(4, 4, 1, false, 0)); }

TEST(Frame, TheNearestFragmentStays) {
  Frame frame = small_frame();
  frame.merge(3, 2.0f, 0xff0000aa);
  frame.merge(3, 1.0f, 0xff0000bb);
  frame.merge(3, 1.5f, 0xff0000cc);
  EXPECT_EQ(frame.samples()[3] & 0xffffffff, 0xff0000bbu);
  EXPECT_EQ(frame.covered(), 1u);
}

TEST(Frame, DoesNotDependOnTheOrderOfFragments) {
  Frame one = small_frame(), other = small_frame();
  one.merge(5, 1.0f, 7);
  one.merge(5, 1.0f, 9);
  other.merge(5, 1.0f, 9);
  other.merge(5, 1.0f, 7);
  EXPECT_EQ(one.hash(), other.hash());
}

TEST(Frame, DropsDepthsThatDoNotOrder) {
  Frame frame = small_frame();
  frame.merge(1, -1.0f, 0);
  frame.merge(1, std::numeric_limits<float>::quiet_NaN(), 0);
  EXPECT_EQ(frame.covered(), 0u);
  frame.merge(1, -0.0f, 0);
  EXPECT_EQ(frame.covered(), 1u);
}

TEST(Frame, PacksColours) {
  EXPECT_EQ(static_cast<std::uint32_t>(pack_channels(1.0f, 0.0f, 0.5f, 1.0f)), 0xff8000ffu);
  EXPECT_EQ(static_cast<std::uint32_t>(
                pack_channels(2.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f)),
            0x000000ffu);
}

TEST(Kernels, AreFoundByName) {
  EXPECT_EQ(find_kernel("repack").name, "repack");
  try {
    find_kernel("lokstep");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              fmt::format("--kernel: there is no kernel 'lokstep'; did you mean 'lockstep'? (one "
                          "of: {})",
                          fmt::join(names_of(kernels()), ", ")));
  }
}

}  // namespace
}  // namespace lanescope
