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
  Counting<16> vm(16, 1);
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
  Counting<8> vm(8, 1);
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
  Counting<32> vm(32, 2);
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
  Counting<8> vm(8, 1);
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
template <int W, class Vm>
void run_branching(Vm&& vm, int rounds) {
  std::uint64_t broadcasts = 0, adds = 0, muls = 0, active_adds = 0, lanes0 = 0;
  {
    auto site = vm.site(0);
    for (int i = 0; i < rounds; ++i) {
      const auto active = Mask<W>::from_bits(static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u);
      auto on = site.on(active);
      auto a = broadcast(on, 1.0f);
      ++broadcasts;
      lanes0 += active[0];
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
  EXPECT_EQ(counts_of(counts, "broadcast").issued, broadcasts);
  EXPECT_EQ(counts.stages[0].lane_active[0], lanes0);
}

TEST(Machine, IsExactWithBranchesInsideABlock) {
  for (const int rounds : {1, 2, 7, 1000}) {
    run_branching<8>(Counting<8>(8, 1), rounds);
    run_branching<16>(Counting<16>(16, 1), rounds);
    run_branching<64>(Counting<64>(64, 1), rounds);
    run_branching<64>(SlowMachine<64>(64, 1, Mode::kChecked), rounds);
  }
}

TEST(Machine, IsExactWhenTwoBlocksShareASite) {
  Counting<8> vm(8, 1);
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
  Counting<8> vm(8, 1);
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

TEST(Machine, CountsABlockThatOutgrowsItsList) {
  Counting<8> vm(8, 1);
  {
    auto site = vm.site(0);
    for (int round = 0; round < 2; ++round) {
      auto on = site.on(Mask<8>::first_n(3));
      for (int i = 0; i < 100'000; ++i) broadcast(on, i);
      lane_index(on);
    }
  }
  const Counts counts = vm.counts();
  EXPECT_EQ(counts_of(counts, "broadcast").issued, 200'000u);
  EXPECT_EQ(counts_of(counts, "broadcast").active, 600'000u);
  EXPECT_EQ(counts_of(counts, "lane_index").issued, 2u);
  EXPECT_EQ(counts.stages[0].histogram[3], 200'002u);
  EXPECT_EQ(counts.stages[0].lane_active[2], 200'002u);
}

TEST(Machine, CountsAnyNumberOfInstructionsOfTheUserInABlock) {
  Counting<8> vm(8, 1);
  {
    auto site = vm.site(0);
    for (int i = 0; i < 5; ++i) {
      auto on = site.on(Mask<8>::first_n(2));
      for (int k = 0; k < 20; ++k) Instruction<OnAllLanes>{}(on);
      for (int k = 0; k < 20; ++k) Instruction<OnOneLane>{}(on.overhead());
    }
  }
  const Counts counts = vm.counts();
  EXPECT_EQ(counts_of(counts, "on_all_lanes").active, 100 * 8u);
  EXPECT_EQ(counts_of(counts, "on_one_lane").overhead_issued, 100u);
  EXPECT_EQ(counts.stages[0].lane_active[1], 200u);
}

struct OneOfTwo {
  static constexpr InstructionInfo kInfo{"twin", "", InstructionClass::kSpecial};
  template <int L>
  static void apply(Mask<L>) {}
};
struct OtherOfTwo {
  static constexpr InstructionInfo kInfo{"twin", "", InstructionClass::kSpecial, Charge::kAllLanes};
  template <int L>
  static void apply(Mask<L>) {}
};
struct SecondAdd {
  static constexpr InstructionInfo kInfo{"add", "", InstructionClass::kSpecial};
  template <int L>
  static void apply(Mask<L>) {}
};

/// Two instructions of one name cannot be told apart in a report, wherever they are issued.
TEST(Machine, RefusesTwoInstructionsOfOneName) {
  const auto counts_with = [](auto&& program) {
    Counting<8> vm(8, 1);
    {
      auto site = vm.site(0);
      program(site);
    }
    return vm.counts();
  };
  EXPECT_THROW(counts_with([](auto& site) {
                 for (int i = 0; i < 2; ++i) {
                   auto on = site.on(Mask<8>::all());
                   if (i == 0)
                     Instruction<OneOfTwo>{}(on);
                   else
                     Instruction<OtherOfTwo>{}(on);
                 }
               }),
               CheckError);
  EXPECT_THROW(counts_with([](auto& site) {
                 auto on = site.on(Mask<8>::all());
                 add(on, lane_index(on), 1);
                 Instruction<SecondAdd>{}(on);
               }),
               CheckError);
}

TEST(Machine, RefusesAWrongStage) {
  Counting<8> vm(8, 2);
  EXPECT_NO_THROW(vm.site(1));
  try {
    vm.site(2);
    FAIL();
  } catch (const CheckError& e) {
    EXPECT_STREQ(e.what(), "a site of stage 2, in a program that has 2 stages");
  }
}

TEST(Machine, RefusesAWrongWidth) {
  EXPECT_THROW(Counting<8>(0, 1), CheckError);
  EXPECT_THROW(Counting<8>(9, 1), CheckError);
}

TEST(Machine, RefusesLanesBeyondItsWidth) {
  Counting<8> vm(5, 1);
  {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::all());
    lane_index(on);
  }
  EXPECT_THROW(vm.counts(), CheckError);
}

/// A program whose counts depend on where the vector ends.
template <class Vm>
void to_the_end(Vm& vm) {
  auto site = vm.site(0);
  auto other = vm.site(1);
  for (int first = 0; first < 100; first += vm.width()) {
    auto on = site.on(vm.first_n(100 - first));
    const auto lanes = lane_index(on);
    const auto busy = cmp_lt(on, lanes, 3);
    Instruction<OnAllLanes>{}(on);
    auto rest = other.on(vm.all() & ~busy);
    mask_not(rest, busy);
    add(rest.overhead(), broadcast(rest, 2), 1);
  }
}

/// What a machine of just this width must count, by arithmetic.
void expect_counts_of_width(const Counts& counts, int width) {
  const auto w = static_cast<std::uint64_t>(width);
  const std::uint64_t batches = (100 + w - 1) / w;
  EXPECT_EQ(counts.width, width);
  ASSERT_EQ(counts.stages[0].histogram.size(), w + 1);
  EXPECT_EQ(counts.stages[0].total().issued, 3 * batches);
  EXPECT_EQ(counts_of(counts, "lane_index").active, 100u);
  EXPECT_EQ(counts_of(counts, "on_all_lanes").active, w * batches);
  EXPECT_EQ(counts_of(counts, "add", 1).overhead_issued, batches);
  EXPECT_EQ(counts.stages[0].lane_active[w - 1], 3 * (100 / w));
}

TEST(Machine, CountsAsOneOfJustItsWidth) {
  for (const int width : {1, 3, 4, 5, 7, 8, 15, 16, 17, 31, 32, 33, 47, 63, 64}) {
    SCOPED_TRACE(width);
    Counting<64> widest(width, 2);
    to_the_end(widest);
    expect_counts_of_width(widest.counts(), width);
    const auto expect_same = [&]<int L>() {
      if (width > L) return;
      Counting<L> vm(width, 2);
      to_the_end(vm);
      EXPECT_EQ(vm.counts(), widest.counts());
      SlowMachine<L> slow(width, 2, Mode::kChecked);
      to_the_end(slow);
      EXPECT_EQ(slow.counts(), widest.counts());
    };
    expect_same.operator()<8>();
    expect_same.operator()<16>();
    expect_same.operator()<32>();
    expect_same.operator()<64>();
  }
}

TEST(Machine, MovesDataWithinItsWidth) {
  for (const int width : {1, 3, 7, 8, 15, 16, 17, 33, 63, 64}) {
    Counting<64> vm(width, 1);
    auto site = vm.site(0);
    auto on = site.on(vm.all());
    const auto lanes = lane_index(on);
    const auto turned = permute(on, lanes, add(on, lanes, 1));
    const auto back = permute(on, lanes, sub(on, lanes, 1));
    const auto down = shuffle_down(on, lanes, 2);
    for (int i = 0; i < width; ++i) {
      EXPECT_EQ(turned[i], (i + 1) % width);
      EXPECT_EQ(back[i], (i + width - 1) % width);
      EXPECT_EQ(down[i], i + 2 < width ? i + 2 : i);
    }
    EXPECT_TRUE(all(on, vm.all()));
    EXPECT_FALSE(any(on, mask_not(on, vm.all())));
    EXPECT_EQ(count(on, vm.all()), width);
  }
}

TEST(Machine, ModesIssueTheSame) {
  const auto run = [](auto& vm) {
    auto site = vm.site(0);
    auto on = site.on(Mask<8>::first_n(5));
    return hadd(on, mul(on, convert_to_float(on, lane_index(on)), 0.5f));
  };
  Machine<8, Mode::kCounting> counting(8, 1);
  SlowMachine<8> checked(8, 1, Mode::kChecked);
  Machine<8, Mode::kUncounted> uncounted(8, 1);
  EXPECT_EQ(run(counting), 5.0f);
  EXPECT_EQ(run(checked), 5.0f);
  EXPECT_EQ(run(uncounted), 5.0f);
  EXPECT_EQ(counting.counts(), checked.counts());
  EXPECT_EQ(uncounted.counts().stages[0].total().issued, 0u);
}

TEST(Counts, MergeByAddition) {
  Counting<8> a(8, 1), b(8, 1);
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
