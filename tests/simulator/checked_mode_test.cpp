// SPDX-License-Identifier: MIT
// A checked machine finds the mistakes that kernels make, and says where.
#include <gtest/gtest.h>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

using namespace isa;
using Checked = SlowMachine<8>;

/// What a program fails with, without file and line; empty if it does not fail.
template <class F>
std::string failure(F&& program) {
  Checked vm(8, 1, Mode::kChecked);
  auto site = vm.site(0);
  try {
    program(site);
  } catch (const CheckError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("checked_mode_test.cpp:"), std::string::npos) << text;
    return text.substr(text.find(": ") + 2);
  }
  return {};
}

TEST(CheckedMode, ADeadLaneMustNotBeRead) {
  EXPECT_EQ(failure([](auto& site) {
              typename Checked::Float a;
              {
                auto on = site.on(Mask<8>::first_n(3));
                a = broadcast(on, 1.0f);
              }
              auto on = site.on(Mask<8>::first_n(5));
              add(on, 1.0f, a);
            }),
            "add, lane 3: operand 2 is read, but the lane was off when it was computed");
}

TEST(CheckedMode, MergingKeepsWhatTheOthersHold) {
  EXPECT_EQ(failure([](auto& site) {
              typename Checked::Int a;
              {
                auto on = site.on(Mask<8>::all());
                a = lane_index(on);
              }
              {
                auto on = site.on(Mask<8>::first_n(2));
                a = move(on, 9, a);
              }
              auto on = site.on(Mask<8>::all());
              EXPECT_EQ(hadd(on, a), 9 + 9 + 2 + 3 + 4 + 5 + 6 + 7);
            }),
            "");
}

TEST(CheckedMode, SelectReadsOnlyWhatItChooses) {
  const auto program = [](Mask<8> chosen) {
    return [chosen](auto& site) {
      typename Checked::Int a, b;
      {
        auto on = site.on(Mask<8>::first_n(4));
        a = broadcast(on, 1);
      }
      auto on = site.on(Mask<8>::all());
      b = broadcast(on, 2);
      select(on, chosen, a, b);
    };
  };
  EXPECT_EQ(failure(program(Mask<8>::first_n(4))), "");
  EXPECT_EQ(failure(program(Mask<8>::first_n(5))),
            "select, lane 4: operand 2 is read, but the lane was off when it was computed");
}

TEST(CheckedMode, CompressDefinesTheFront) {
  EXPECT_EQ(failure([](auto& site) {
              auto on = site.on(Mask<8>::all());
              const auto packed = compress(on, Mask<8>::from_bits(0b1010), lane_index(on));
              add(on, packed, 1);
            }),
            "add, lane 2: operand 1 is read, but the lane was off when it was computed");
}

TEST(CheckedMode, PermuteMustNotReadADeadLane) {
  EXPECT_EQ(failure([](auto& site) {
              auto on = site.on(Mask<8>::first_n(4));
              const auto lanes = lane_index(on);
              permute(on, lanes, add(on, lanes, 1));
            }),
            "permute, lane 4: operand 1 is read, but the lane was off when it was computed");
}

TEST(CheckedMode, AccessesStayInBounds) {
  const float values[10] = {};
  const auto memory = read_only(values, 10, "values");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::first_n(4));
              load(on, memory, 7);
            }),
            "load, lane 3: element 10 is outside 'values', which has 10");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::first_n(4));
              gather(on, memory, sub(on, lane_index(on), 2));
            }),
            "gather, lane 0: element -2 is outside 'values', which has 10");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::all());
              gather_pair(on, memory, lane_index(on));
            }),
            "gather_pair, lane 5: element 10 is outside 'values', which has 10");
}

TEST(CheckedMode, MemoryIsWrittenBeforeItIsRead) {
  Buffer<std::int32_t> buffer(8, "scratch", true);
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::first_n(6));
              scatter(on, buffer.memory(), lane_index(on), broadcast(on, 5));
              load(on, buffer.memory(), 0);
            }),
            "");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::all());
              load(on, buffer.memory(), 0);
            }),
            "load, lane 6: element 6 of 'scratch' is read, but was never written");
}

TEST(CheckedMode, LanesMustNotStoreToOneElement) {
  Buffer<std::int32_t> buffer(16, "scratch", true);
  const auto halves = [&](auto& on) { return shr(on, lane_index(on), 1); };
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::from_bits(0b10101110));
              scatter(on, buffer.memory(), halves(on), lane_index(on));
            }),
            "scatter, lanes 2 and 3: both store to element 1 of 'scratch', in one instruction");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::first_n(2));
              scatter_pair(on, buffer.memory(), halves(on), halves(on), halves(on));
            }),
            "scatter_pair, lanes 0 and 1: both store to element 0 of 'scratch', in one "
            "instruction");
  EXPECT_EQ(failure([&](auto& site) {
              auto on = site.on(Mask<8>::all());
              scatter(on, buffer.memory(), sub(on, 7, lane_index(on)), lane_index(on));
            }),
            "");
}

TEST(CheckedMode, AtomicsReadWhatTheyStore) {
  EXPECT_EQ(failure([](auto& site) {
              Buffer<std::int32_t> buffer(16, "scratch", true);
              auto on = site.on(Mask<8>::all());
              store(on, buffer.memory(), 0, lane_index(on));
              scatter_add(on, buffer.memory(), shr(on, lane_index(on), 1), lane_index(on));
            }),
            "");
  EXPECT_EQ(failure([](auto& site) {
              Buffer<std::int32_t> buffer(16, "scratch", true);
              auto on = site.on(Mask<8>::all());
              scatter_add(on, buffer.memory(), lane_index(on), lane_index(on));
            }),
            "scatter_add, lane 0: element 0 of 'scratch' is read, but was never written");
}

TEST(CheckedMode, LanesBeyondTheWidthStayOff) {
  Checked vm(5, 1, Mode::kChecked);
  auto site = vm.site(0);
  EXPECT_NO_THROW(site.on(vm.all()));
  try {
    site.on(~Mask<8>::first_n(3));
    FAIL();
  } catch (const CheckError& e) {
    EXPECT_NE(std::string(e.what()).find("a block has lane 7 on, of a machine that is 5 wide"),
              std::string::npos)
        << e.what();
  }
}

TEST(CheckedMode, ReadsWithinTheWidth) {
  Checked vm(5, 1, Mode::kChecked);
  auto site = vm.site(0);
  auto on = site.on(vm.all());
  const auto lanes = lane_index(on);
  EXPECT_EQ(hmax(on, permute(on.allowing(Check::kLaneIndex), lanes, add(on, lanes, 1))), 4);
  EXPECT_EQ(hadd(on, shuffle_down(on, lanes, 3)), 3 + 4 + 2 + 3 + 4);
}

/// Whether an instruction on two lanes, of which the second holds the values, is reported.
template <class Op, class... T>
bool reported(const T&... values) {
  return !failure([&](auto& site) {
            auto on = site.on(Mask<8>::first_n(2));
            const auto second = cmp_eq(on, lane_index(on), 1);
            Instruction<Op>{}(on, select(on, second, values, broadcast(on, T{1}))...);
          }).empty();
}

TEST(CheckedMode, ReportsFromTheFirstValueThatIsOutOfRange) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(reported<ConvertToInt>(2147483520.0f));
  EXPECT_TRUE(reported<ConvertToInt>(2147483648.0f));
  EXPECT_FALSE(reported<ConvertToInt>(-2147483648.0f));
  EXPECT_TRUE(reported<ConvertToInt>(-2147483904.0f));
  EXPECT_TRUE(reported<ConvertToInt>(kNan));
  EXPECT_FALSE(reported<ConvertToUint>(-0.99f));
  EXPECT_TRUE(reported<ConvertToUint>(-1.0f));
  EXPECT_FALSE(reported<ConvertToUint>(4294967040.0f));
  EXPECT_TRUE(reported<ConvertToUint>(4294967296.0f));
  EXPECT_TRUE(reported<ConvertToUint>(kNan));

  EXPECT_FALSE(reported<Shl>(1, 31));
  EXPECT_TRUE(reported<Shl>(1, 32));
  EXPECT_TRUE(reported<Shr>(1, -1));
  EXPECT_TRUE(reported<Shr>(1u, 32u));
  EXPECT_FALSE(reported<Rotl>(1u, 32u));

  constexpr auto kLowest = std::numeric_limits<std::int32_t>::min();
  EXPECT_TRUE(reported<Div>(0, 0));
  EXPECT_TRUE(reported<Div>(7u, 0u));
  EXPECT_TRUE(reported<Div>(kLowest, -1));
  EXPECT_FALSE(reported<Div>(kLowest + 1, -1));
  EXPECT_FALSE(reported<Div>(0x80000000u, ~0u));
  EXPECT_FALSE(reported<Div>(1.0f, 0.0f));
}

TEST(CheckedMode, NotANumberIsReportedWhereItIsBorn) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(reported<Div>(0.0f, 0.0f));
  EXPECT_TRUE(reported<Sub>(kInfinity, kInfinity));
  EXPECT_TRUE(reported<Sqrt>(-1.0f));
  EXPECT_TRUE(reported<BitsToFloat>(0x7fc00000u));
  EXPECT_FALSE(reported<InclusiveScan>(-kInfinity));
  EXPECT_FALSE(reported<Add>(kNan, 1.0f));
  EXPECT_FALSE(reported<Fma>(0.0f, kInfinity, kNan));
  EXPECT_FALSE(reported<Hadd>(kNan));
  EXPECT_FALSE(reported<Min>(1.0f, kNan));
}

/// Neither from memory nor from another lane, and not in a lane that is off.
TEST(CheckedMode, NotANumberIsPassedOn) {
  const float values[] = {0.0f, std::numeric_limits<float>::quiet_NaN(), 2.0f, 3.0f};
  EXPECT_EQ(failure([&](auto& site) {
              typename Checked::Float v;
              {
                auto on = site.on(Mask<8>::first_n(4));
                v = load(on, read_only(values, 4, "values"), 0);
                shuffle_up(on, v, 1);
                inclusive_scan(on, v);
                compress(on, cmp_ne(on, v, v), v);
              }
              auto on = site.on(Mask<8>::from_bits(0b1100));
              sqrt(on, sub(on, v, 2.0f));
            }),
            "");
}

TEST(CheckedMode, MemoryIsAsLargeAsItSays) {
  const float value = 1.0f;
  // Only its first element is there; none of the others is touched.
  const auto memory = read_only(&value, std::size_t{1} << 33, "large");
  EXPECT_EQ(memory.size, std::size_t{1} << 33);
  EXPECT_EQ(memory.part(0, std::size_t{1} << 32).size, std::size_t{1} << 32);
}

TEST(CheckedMode, DeadLanesHoldPoison) {
  Checked vm(8, 1, Mode::kChecked);
  auto site = vm.site(0);
  auto on = site.on(Mask<8>::first_n(1));
  EXPECT_TRUE(std::isnan(broadcast(on, 1.0f).vec[1]));
  EXPECT_EQ(broadcast(on, 1u).vec[1], 0x7badbad1u);
}

}  // namespace
}  // namespace lanescope
