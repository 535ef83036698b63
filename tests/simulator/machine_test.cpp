// SPDX-License-Identifier: MIT
// Counts that can be computed by hand.
#include <gtest/gtest.h>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

using namespace isa;

/// The counts of one instruction in a stage, all zero if it was not issued.
InstructionCounts counts_of(const Counts& counts, std::string_view mnemonic,
                            std::size_t stage = 0) {
  for (const auto& c : counts.stages[stage].instructions)
    if (c.info->mnemonic == mnemonic) return c;
  return {};
}

template <int W>
using Counting = Machine<W, Mode::kCounting>;

TEST(Machine, TwentyFiveOnSixteenLanesAreTwoBatches) {
  Counting<16> vm(1);
  {
    auto site = vm.site(0);
    for (int first = 0; first < 25; first += 16) {
      auto on = site.on(Mask<16>::first_n(25 - first));
      add(on, lane_index(on), 1);
    }
  }
  const Counts counts = vm.counts();
  const InstructionCounts total = counts.stages[0].total();
  EXPECT_EQ(total.issued, 4u);
  EXPECT_EQ(total.active, 2 * 25u);
  EXPECT_EQ(counts.stages[0].histogram[16], 2u);
  EXPECT_EQ(counts.stages[0].histogram[9], 2u);
  EXPECT_EQ(counts.stages[0].lane_active[8], 4u);
  EXPECT_EQ(counts.stages[0].lane_active[9], 2u);
}

TEST(Machine, ChargesWhatInstructionsDeclare) {
  Counting<8> vm(1);
  {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::from_bits(0b101));
    mul(on, broadcast(on, 2.0f), 3.0f);
    hmax(on, lane_index(on));
  }
  EXPECT_EQ(counts_of(vm.counts(), "mul").active, 2u);
  EXPECT_EQ(counts_of(vm.counts(), "hmax").active, 2u);
}

struct OnAllLanes {
  static constexpr InstructionInfo kInfo{"on_all_lanes", "", InstructionClass::kSpecial,
                                         Charge::kAllLanes};
  template <int W>
  static void apply(Mask<W>) {}
};
struct OnOneLane {
  static constexpr InstructionInfo kInfo{"on_one_lane", "", InstructionClass::kSpecial,
                                         Charge::kOneLane};
  template <int W>
  static void apply(Mask<W>) {}
};

TEST(Machine, CountsInstructionsOfTheUser) {
  Counting<32> vm(2);
  {
    auto site = vm.site(1);
    for (int i = 0; i < 3; ++i) {
      auto on = site.on(Mask<32>::first_n(5));
      Instruction<OnAllLanes>{}(on);
      Instruction<OnOneLane>{}(on.overhead());
      Instruction<OnOneLane>{}(on);
    }
  }
  const Counts counts = vm.counts();
  EXPECT_EQ(counts_of(counts, "on_all_lanes", 1).active, 3 * 32u);
  EXPECT_EQ(counts_of(counts, "on_one_lane", 1).issued, 6u);
  EXPECT_EQ(counts_of(counts, "on_one_lane", 1).active, 6u);
  EXPECT_EQ(counts_of(counts, "on_one_lane", 1).overhead_issued, 3u);
  EXPECT_EQ(counts.stages[0].total().issued, 0u);
}

TEST(Machine, MarksOverheadWhereItIsIssued) {
  Counting<8> vm(1);
  {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::first_n(3));
    const auto a = broadcast(on, 1.0f);
    add(on, a, a);
    add(on.overhead(), a, a);
  }
  const auto adds = counts_of(vm.counts(), "add");
  EXPECT_EQ(adds.issued, 2u);
  EXPECT_EQ(adds.overhead_issued, 1u);
  EXPECT_EQ(adds.overhead_active, 3u);
}

/// The oracle of a program with branches and loops inside a block: counts kept by hand.
template <int W>
void run_branching(int rounds) {
  Counting<W> vm(1);
  std::uint64_t adds = 0, muls = 0, active_adds = 0, lanes0 = 0;
  {
    auto site = vm.site(0);
    for (int i = 0; i < rounds; ++i) {
      const auto active = Mask<W>::from_bits(static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u);
      auto on = site.on(active);
      auto a = Vec<float, W>::broadcast(1.0f);
      const auto count_add = [&] {
        ++adds;
        active_adds += static_cast<std::uint64_t>(active.count());
        lanes0 += active[0];
      };
      if (i % 3 == 0) {
        a = add(on, a, 1.0f);
        count_add();
      } else {
        a = mul(on, a, 2.0f);
        ++muls;
        lanes0 += active[0];
      }
      for (int k = 0; k < i % 5; ++k) {
        a = add(on, a, 1.0f);
        count_add();
      }
    }
  }
  const Counts counts = vm.counts();
  EXPECT_EQ(counts_of(counts, "add").issued, adds);
  EXPECT_EQ(counts_of(counts, "add").active, active_adds);
  EXPECT_EQ(counts_of(counts, "mul").issued, muls);
  EXPECT_EQ(counts.stages[0].lane_active[0], lanes0);
}

TEST(Machine, IsExactWithBranchesInsideABlock) {
  for (const int rounds : {1, 2, 7, 1000}) {
    run_branching<8>(rounds);
    run_branching<16>(rounds);
    run_branching<64>(rounds);
  }
}

TEST(Machine, IsExactWhenTwoBlocksShareASite) {
  Counting<8> vm(1);
  {
    auto site = vm.site(0);
    for (int i = 0; i < 10; ++i) {
      {
        auto on = site.on(Mask<8>::all());
        broadcast(on, 1);
      }
      auto on = site.on(Mask<8>::first_n(1));
      lane_index(on);
    }
  }
  EXPECT_EQ(counts_of(vm.counts(), "broadcast").active, 80u);
  EXPECT_EQ(counts_of(vm.counts(), "lane_index").active, 10u);
}

TEST(Machine, IsExactWhenABlockIsLeftEarly) {
  Counting<8> vm(1);
  {
    auto site = vm.site(0);
    for (int i = 0; i < 10; ++i) {
      auto on = site.on(Mask<8>::all());
      broadcast(on, 1);
      if (i % 2) continue;
      lane_index(on);
    }
  }
  EXPECT_EQ(counts_of(vm.counts(), "broadcast").issued, 10u);
  EXPECT_EQ(counts_of(vm.counts(), "lane_index").issued, 5u);
}

TEST(Machine, RefusesABlockThatOutgrowsItsList) {
  Counting<8> vm(1);
  auto site = vm.site(0);
  const auto endless = [&] {
    auto on = site.on(Mask<8>::all());
    for (int i = 0; i < 100'000; ++i) broadcast(on, i);
  };
  EXPECT_THROW(endless(), CheckError);
}

TEST(Machine, ModesIssueTheSame) {
  const auto run = [](auto& vm) {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::first_n(5));
    return hadd(on, mul(on, convert_to_float(on, lane_index(on)), 0.5f));
  };
  Machine<8, Mode::kCounting> counting(1);
  Machine<8, Mode::kChecked> checked(1);
  Machine<8, Mode::kUncounted> uncounted(1);
  EXPECT_EQ(run(counting), 5.0f);
  EXPECT_EQ(run(checked), 5.0f);
  EXPECT_EQ(run(uncounted), 5.0f);
  EXPECT_EQ(counting.counts(), checked.counts());
  EXPECT_EQ(uncounted.counts().stages[0].total().issued, 0u);
}

TEST(Counts, MergeByAddition) {
  Counting<8> a(1), b(1);
  const auto run = [](auto& vm, int lanes) {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::first_n(lanes));
    broadcast(on, 1);
  };
  run(a, 3);
  run(b, 8);
  Counts sum = a.counts();
  sum += b.counts();
  run(a, 8);
  EXPECT_EQ(sum, a.counts());
  EXPECT_THROW(sum += Counts(16, 1), CheckError);
}

}  // namespace
}  // namespace lanescope
