// SPDX-License-Identifier: MIT
// `lanescope check`: kernels that agree with the reference, and kernels that do not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/working_directory.h"

namespace lanescope::testing {
namespace {

class Check : public InEmptyDirectory {
 protected:
  /// Checks kernels of the program with wrong ones on a small picture.
  Outcome check(const std::string& arguments, int status) const {
    Outcome outcome = shell(fmt::format("'{}' check --scene teapot --resolution 96x60 {}",
                                        LANESCOPE_WITH_WRONG, arguments),
                            directory());
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.output << outcome.errors;
    return outcome;
  }
};

TEST_F(Check, KernelsAgreeInEveryModeAndShape) {
  // Two shapes, three modes, 8 and one less.
  const std::string output = check("--kernel lockstep,repack --width 7,8 --pieces 1", 0).output;
  EXPECT_TRUE(output.starts_with("lockstep agrees with rastmp in 12 runs of at least ")) << output;
  EXPECT_NE(output.find(" pieces\nrepack agrees with rastmp in 12 runs of at least "), output.npos)
      << output;
}

TEST_F(Check, TheFirstDifferenceOfEachKernelIsSaid) {
  const std::string output =
      check(
          "--kernel lockstep,counts_too_many,hits_others,draws_more,breaks_a_rule "
          "--width 7,8 --pieces 3",
          1)
          .output;
  EXPECT_NE(output.find("lockstep agrees with rastmp in 12 runs"), std::string::npos) << output;
  for (const char* difference :
       {"counts_too_many differs from rastmp: --scene teapot --width 7 --mode counting "
        "--micropolygon triangle: piece ",
        ": micropolygons_seen is ",
        "hits_others differs from rastmp: --scene teapot --width 8 --mode counting --micropolygon "
        "triangle: piece ",
        ": its results are not those of rastmp\n",
        "draws_more differs from rastmp: --scene teapot --width 7 --mode counting --micropolygon "
        "triangle: its output is not that of lockstep\n",
        "breaks_a_rule differs from rastmp: --scene teapot --width 7 --mode checked "
        "--micropolygon triangle: piece ",
        "internal check failed"})
    EXPECT_NE(output.find(difference), std::string::npos) << difference << "\n" << output;
}

TEST_F(Check, OnlyWhatHasAReferenceIsChecked) {
  const Outcome outcome =
      shell(fmt::format("'{}' check --kernel sum", LANESCOPE_WITH_NUMBERS), directory());
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors, "lanescope: check: there is no scalar reference for numbers\n");
}

}  // namespace
}  // namespace lanescope::testing
