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

/// However many lists a site goes through, one is kept; and none of a site that has ended.
TEST(Tally, KeepsOneListForEachSite) {
  Tally tally(8, 2);
  const auto one = tally.keep(Tally::kNoPlace, 0, adds(1));
  const auto other = tally.keep(Tally::kNoPlace, 1, adds(1));
  EXPECT_NE(one, other);
  for (std::uint64_t times = 2; times < 1000; ++times)
    EXPECT_EQ(tally.keep(one, 0, adds(times)), one);
  tally.forget(one);
  EXPECT_EQ(tally.keep(Tally::kNoPlace, 1, adds(3)), one);
}

TEST(Tally, MultipliesExecutionsByTheList) {
  Tally tally(8, 1);
  const std::uint64_t lanes[8] = {5, 5, 2, 0, 0, 0, 0, 0};
  std::uint64_t histogram[9] = {};
  histogram[2] = 3;
  histogram[3] = 2;
  tally.add(tally.keep(Tally::kNoPlace, 0, adds(4)), lanes, histogram);
  const Counts counts = tally.counts();
  EXPECT_EQ(counts.stages[0].total().issued, 4u * 5);
  EXPECT_EQ(counts.stages[0].total().active, 4u * (3 * 2 + 2 * 3));
  EXPECT_EQ(counts.stages[0].lane_active[2], 4u * 2);
  EXPECT_EQ(counts.stages[0].histogram[3], 4u * 2);
}

TEST(Tally, ChargesWhatIsIssuedByItself) {
  Tally tally(8, 1);
  tally.charge(0, {&isa::Add::kInfo, true}, 0b10110);
  tally.charge(0, {&isa::Add::kInfo, false}, 0);
  const Counts counts = tally.counts();
  EXPECT_EQ(counts.stages[0].instructions.size(), 1u);
  EXPECT_EQ(counts.stages[0].total(), (InstructionCounts{nullptr, 2, 3, 1, 3}));
  EXPECT_EQ(counts.stages[0].lane_active, (std::vector<std::uint64_t>{0, 1, 1, 0, 1, 0, 0, 0}));
  EXPECT_EQ(counts.stages[0].histogram, (std::vector<std::uint64_t>{1, 0, 0, 1, 0, 0, 0, 0, 0}));
}

/// A signature tells what was issued, not in which order.
TEST(Signature, IsASum) {
  const auto add = detail::signature_of<isa::Add, false>();
  const auto extra_add = detail::signature_of<isa::Add, true>();
  const auto mul = detail::signature_of<isa::Mul, false>();
  EXPECT_NE(add, mul);
  EXPECT_NE(add, extra_add);
  EXPECT_NE(add + add, mul);
  EXPECT_NE(add + extra_add, add + mul);
}

}  // namespace
}  // namespace lanescope
