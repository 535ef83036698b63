// SPDX-License-Identifier: MIT
#include "simulator/tally.h"

#include <gtest/gtest.h>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

IssueList adds(std::uint64_t times) {
  IssueList list;
  constexpr std::size_t kAdd = kInstructionIndex<isa::Add>;
  list.baseline[kAdd / 4] = times << (16 * (kAdd % 4));
  return list;
}

TEST(Tally, EqualListsHaveOneHandle) {
  Tally tally(8, 1);
  const auto one = tally.intern(0, 7, adds(1));
  EXPECT_EQ(tally.intern(0, 7, adds(1)), one);
}

TEST(Tally, ListsWithOneSignatureAreToldApart) {
  Tally tally(8, 1);
  EXPECT_NE(tally.intern(0, 7, adds(1)), tally.intern(0, 7, adds(2)));
}

TEST(Tally, MultipliesExecutionsByTheList) {
  Tally tally(8, 1);
  const std::uint16_t lanes[8] = {5, 5, 2, 0, 0, 0, 0, 0};
  std::uint64_t histogram[9] = {};
  histogram[2] = 3;
  histogram[3] = 2;
  tally.add(0, tally.intern(0, 1, adds(4)), lanes, histogram);
  const Counts counts = tally.counts();
  EXPECT_EQ(counts.stages[0].total().issued, 4u * 5);
  EXPECT_EQ(counts.stages[0].total().active, 4u * (3 * 2 + 2 * 3));
  EXPECT_EQ(counts.stages[0].lane_active[2], 4u * 2);
  EXPECT_EQ(counts.stages[0].histogram[3], 4u * 2);
}

}  // namespace
}  // namespace lanescope
