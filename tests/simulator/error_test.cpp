// SPDX-License-Identifier: MIT
#include "simulator/base/error.h"

#include <gtest/gtest.h>

namespace lanescope {
namespace {

TEST(Error, InputErrorsBeginWithWhere) {
  EXPECT_STREQ(InputError("--width", "{} is outside 8..64", 7).what(),
               "--width: 7 is outside 8..64");
}

TEST(Error, ChecksSayTheValues) {
  try {
    LANESCOPE_CHECK(1 > 2, "slot {} of {}", 3, 4);
    FAIL();
  } catch (const CheckError& e) {
    EXPECT_NE(std::string(e.what()).find("internal check failed: 1 > 2 slot 3 of 4"),
              std::string::npos);
  }
}

TEST(Error, SuggestsTheNearestWord) {
  const std::vector<std::string> names{"lockstep", "repack", "rastmp"};
  EXPECT_EQ(nearest("lokstep", names), "lockstep");
  EXPECT_EQ(nearest("repac", names), "repack");
  EXPECT_EQ(nearest("zbuffer", names), "");
  EXPECT_EQ(did_you_mean("rastm", names), "; did you mean 'rastmp'?");
}

}  // namespace
}  // namespace lanescope
