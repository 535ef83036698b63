// SPDX-License-Identifier: MIT
#include "simulator/tally.h"

#include <gtest/gtest.h>

#include <bit>

#include "simulator/base/random.h"
#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

IssueList adds(std::uint64_t times) {
  IssueList list;
  constexpr std::size_t kAdd = kInstructionIndex<isa::Add>;
  list.baseline[kAdd / 4] = times << (16 * (kAdd % 4));
  return list;
}

/// However many lists a site goes through, it has one log; and one that has ended leaves its log to
/// the next.
TEST(Tally, KeepsOneLogForEachSite) {
  Tally tally(8, 2);
  SiteLog& one = tally.open(0);
  SiteLog& other = tally.open(1);
  EXPECT_NE(&one, &other);
  for (std::uint64_t times = 1; times < 1000; ++times) {
    one.list = adds(times);
    tally.take(one);
  }
  tally.close(one);
  EXPECT_EQ(&tally.open(1), &one);
}

TEST(Tally, MultipliesExecutionsByTheList) {
  Tally tally(8, 1);
  SiteLog& log = tally.open(0);
  log.list = adds(4);
  auto* next = log.begin<LoggedMask<8>>();
  for (const int mask : {0b011, 0b011, 0b011, 0b111, 0b111})
    *next++ = static_cast<LoggedMask<8>>(mask);
  log.sum_up(next);
  tally.take(log);
  tally.take(log);  // is empty
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

template <int N>
struct Foreign {
  static constexpr InstructionInfo kInfo{"foreign", "", InstructionClass::kSpecial};
};

/// Descriptors may stand at equal distances.
TEST(Signature, TellsPairsOfForeignInstructionsApart) {
  const auto one = detail::signature_of<Foreign<1>, false>();
  const auto two = detail::signature_of<Foreign<2>, false>();
  const auto three = detail::signature_of<Foreign<3>, false>();
  EXPECT_NE(one + three, two + two);
  EXPECT_NE(one + two, three + three);
  EXPECT_NE(two + three, one + one);
  EXPECT_NE(one, (detail::signature_of<Foreign<1>, true>()));
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

template <class Word>
void check_sums() {
  std::vector<Word> masks;
  MaskSums sums, expected;
  for (std::size_t size = 0; size <= MaskSums::kMostBytes / sizeof(Word); size += 1 + size / 3) {
    masks.clear();
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t hash = mix64(size * 4096 + i);
      masks.push_back(static_cast<Word>(hash % 5 == 0   ? ~std::uint64_t{0}
                                        : hash % 5 == 1 ? 0
                                                        : mix64(hash)));
      for (int lane = 0; lane < 64; ++lane)
        expected.lanes[static_cast<std::size_t>(lane)] += std::uint64_t{masks.back()} >> lane & 1;
      ++expected.histogram[static_cast<std::size_t>(std::popcount(masks.back()))];
    }
    sums.add<Word>(masks.data(), masks.data() + masks.size());
    EXPECT_EQ(sums.lanes, expected.lanes) << size;
    EXPECT_EQ(sums.histogram, expected.histogram) << size;
  }
  // As many as there may be, all lanes on.
  masks.assign(MaskSums::kMostBytes / sizeof(Word), static_cast<Word>(~Word{0}));
  MaskSums full;
  full.add<Word>(masks.data(), masks.data() + masks.size());
  EXPECT_EQ(full.histogram[8 * sizeof(Word)], masks.size());
  EXPECT_EQ(full.lanes[8 * sizeof(Word) - 1], masks.size());
}

TEST(MaskSums, EqualALoopOverLanes) {
  check_sums<std::uint16_t>();
  check_sums<std::uint32_t>();
  check_sums<std::uint64_t>();
}

}  // namespace
}  // namespace lanescope
