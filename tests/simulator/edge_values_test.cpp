// SPDX-License-Identifier: MIT
// What instructions do at the edges: not-a-number, signed zeros, shift counts, conversions out of
// range, no active lane. The right values stand here as tables, not as code, for the scalar
// definition and for the vectors of every number of lanes; they are the same on every host.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

using namespace isa;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kSignalling = std::numeric_limits<float>::signaling_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr auto kLowest = std::numeric_limits<std::int32_t>::min();
constexpr auto kHighest = std::numeric_limits<std::int32_t>::max();

/// Bits, except that all not-a-number are one.
template <class T>
bool same(T a, T b) {
  return (a != a && b != b) || std::memcmp(&a, &b, sizeof a) == 0;
}

/// Calls f(block) in a block under `active` of a machine of W lanes.
template <int W, class F>
auto issue(Mask<W> active, F&& f) {
  Machine<W, Mode::kUncounted> vm(W, 1);
  auto site = vm.site(0);
  auto on = site.on(active);
  return f(on);
}

/// Calls f.template operator()<W>() for every number of lanes.
template <class F>
void at_every_width(F&& f) {
  f.template operator()<8>();
  f.template operator()<16>();
  f.template operator()<32>();
  f.template operator()<64>();
}

/// Values repeated over the lanes, beginning with values[first].
template <int W, class T>
Vec<T, W> repeated(const std::vector<T>& values, std::size_t first = 0) {
  Vec<T, W> v;
  for (int i = 0; i < W; ++i)
    v.set(i, values[(first + static_cast<std::size_t>(i)) % values.size()]);
  return v;
}

template <class Op, class A, class R>
void expect_table(const std::vector<A>& in, const std::vector<R>& out) {
  SCOPED_TRACE(Op::kInfo.mnemonic);
  for (std::size_t i = 0; i < in.size(); ++i) {
    EXPECT_TRUE(same<R>(Op::lane(in[i]), out[i])) << in[i] << " gives " << Op::lane(in[i]);
  }
  at_every_width([&]<int W>() {
    const auto r =
        issue(Mask<W>::all(), [&](auto& on) { return Instruction<Op>{}(on, repeated<W>(in)); });
    const auto expected = repeated<W>(out);
    for (int i = 0; i < W; ++i)
      EXPECT_TRUE(same<R>(r[i], expected[i])) << "W = " << W << ", lane " << i << ": " << r[i];
  });
}

/// Of two operands, in vectors; and vector-scalar, with the scalar second.
template <class Op, class T>
void expect_table(const std::vector<T>& a, const std::vector<T>& b, const std::vector<T>& out) {
  SCOPED_TRACE(Op::kInfo.mnemonic);
  at_every_width([&]<int W>() {
    const auto r = issue(Mask<W>::all(), [&](auto& on) {
      return Instruction<Op>{}(on, repeated<W>(a), repeated<W>(b));
    });
    const auto expected = repeated<W>(out);
    for (int i = 0; i < W; ++i)
      EXPECT_TRUE(same<T>(r[i], expected[i])) << "W = " << W << ", lane " << i << ": " << r[i];
    for (std::size_t k = 0; k < b.size(); ++k) {
      const auto s = issue(
          Mask<W>::all(), [&](auto& on) { return Instruction<Op>{}(on, repeated<W>(a, k), b[k]); });
      EXPECT_TRUE(same<T>(s[0], out[k])) << "scalar " << b[k] << ": " << s[0];
    }
  });
  for (std::size_t k = 0; k < b.size(); ++k)
    EXPECT_TRUE(same<T>(Op::lane(a[k], b[k]), out[k])) << a[k] << ", " << b[k];
}

TEST(EdgeValues, MinimumAndMaximumOfLanes) {
  const std::vector<float> a{kNan, 1, kNan, -0.0f, 0.0f, kSignalling, 2, -kInfinity};
  const std::vector<float> b{1, kNan, kNan, 0.0f, -0.0f, 1, kSignalling, kInfinity};
  expect_table<Min, float>(a, b, {1, kNan, kNan, 0.0f, -0.0f, 1, kNan, -kInfinity});
  expect_table<Max, float>(a, b, {1, kNan, kNan, 0.0f, -0.0f, 1, kNan, kInfinity});
}

TEST(EdgeValues, ShiftCounts) {
  const std::vector<std::int32_t> counts{0, 31, 32, 33, 63, 64, -1, -31};
  const std::vector<std::int32_t> a(counts.size(), -8);
  expect_table<Shl, std::int32_t>(a, counts, {-8, 0, -8, -16, 0, -8, 0, -16});
  expect_table<Shr, std::int32_t>(a, counts, {-8, -1, -8, -4, -1, -8, -1, -4});
  const std::vector<std::uint32_t> unsigned_counts{0, 31, 32, 33, 63, 64, ~0u};
  const std::vector<std::uint32_t> b(unsigned_counts.size(), 0x80000001u);
  expect_table<Shr, std::uint32_t>(b, unsigned_counts, {b[0], 1, b[0], 0x40000000u, 1, b[0], 1});
  expect_table<Rotl, std::uint32_t>(b, unsigned_counts,
                                    {b[0], 0xc0000000u, b[0], 3, 0xc0000000u, b[0], 0xc0000000u});
}

TEST(EdgeValues, BitCounts) {
  expect_table<Clz, std::uint32_t, std::uint32_t>({0, 1, 0x80000000u, ~0u}, {32, 31, 0, 0});
  expect_table<Ctz, std::uint32_t, std::uint32_t>({0, 1, 0x80000000u, ~0u}, {32, 0, 31, 0});
  expect_table<Clz, std::int32_t, std::int32_t>({0, -1, kHighest, 2}, {32, 0, 1, 30});
  expect_table<Ctz, std::int32_t, std::int32_t>({0, -1, kLowest, 12}, {32, 0, 31, 2});
  expect_table<Popcount, std::int32_t, std::int32_t>({0, -1, kLowest, 12}, {0, 32, 1, 2});
}

TEST(EdgeValues, Conversions) {
  const std::vector<float> a{kNan,  2147483648.0f, -2147483904.0f, -2147483648.0f, -0.75f,
                             -1.0f, 4294967296.0f, 4294967040.0f,  -kInfinity,     kInfinity,
                             -0.0f, 1.999f,        -1.999f,        2147483520.0f};
  expect_table<ConvertToInt, float, std::int32_t>(
      a, {kLowest, kLowest, kLowest, kLowest, 0, -1, kLowest, kLowest, kLowest, kLowest, 0, 1, -1,
          2147483520});
  expect_table<ConvertToUint, float, std::uint32_t>(
      a, {~0u, 0x80000000u, ~0u, ~0u, 0, ~0u, ~0u, 4294967040u, ~0u, ~0u, 0, 1, ~0u, 2147483520u});
  expect_table<ConvertToFloat, std::int32_t, float>(
      {kLowest, kHighest, 16777217, -16777219},
      {-2147483648.0f, 2147483648.0f, 16777216.0f, -16777220.0f});
  expect_table<ConvertToFloat, std::uint32_t, float>(
      {~0u, 0x80000000u, 16777217u, 0x80000081u},
      {4294967296.0f, 2147483648.0f, 16777216.0f, 2147483904.0f});
}

TEST(EdgeValues, Integers) {
  expect_table<Div, std::int32_t>({7, -7, kLowest, -7, 0}, {0, 0, -1, 2, 0},
                                  {-1, -1, kLowest, -3, -1});
  expect_table<Div, std::uint32_t>({7, 0, 7, ~0u}, {0, 0, 2, ~0u}, {~0u, ~0u, 3, 1});
  expect_table<Neg, std::int32_t, std::int32_t>({kLowest, 5, 0}, {kLowest, -5, 0});
  expect_table<Abs, std::int32_t, std::int32_t>({kLowest, -5, 0}, {kLowest, 5, 0});
  expect_table<Add, std::int32_t>({kHighest, kLowest}, {1, -1}, {kLowest, kHighest});
}

TEST(EdgeValues, Floats) {
  expect_table<Sqrt, float, float>({-1, -0.0f, kInfinity, kNan}, {kNan, -0.0f, kInfinity, kNan});
  expect_table<Rcp, float, float>({0.0f, -0.0f, kInfinity, 3},
                                  {kInfinity, -kInfinity, 0, 1 / 3.0f});
  expect_table<Ceil, float, float>({-0.5f, -0.0f, kInfinity, kNan},
                                   {-0.0f, -0.0f, kInfinity, kNan});
  expect_table<Floor, float, float>({-0.5f, -0.0f, -kInfinity, kNan},
                                    {-1, -0.0f, -kInfinity, kNan});
  expect_table<Neg, float, float>({0.0f, kInfinity}, {-0.0f, -kInfinity});
  expect_table<Abs, float, float>({-0.0f, -kInfinity, kNan}, {0.0f, kInfinity, kNan});
}

struct Reduction {
  std::vector<bool> active;
  std::vector<float> a;
  float maximum, minimum;
};

/// Wherever the values stand: rotated through the lanes, the other lanes off.
TEST(EdgeValues, ReductionsDoNotDependOnTheOrderOfLanes) {
  const std::vector<Reduction> rows{
      {{1, 1, 1, 1}, {5, kNan, 1, 2}, 5, 1},
      {{1, 1, 1, 1}, {5, 1, 2, kNan}, 5, 1},
      {{1, 1, 1, 1}, {-5, kSignalling, 1, 2}, 2, -5},
      {{0, 0, 0, 0}, {1, 2, 3, 4}, -kInfinity, kInfinity},
      {{0, 1, 0, 1}, {kNan, -0.0f, 7, 0.0f}, 0.0f, -0.0f},
      {{1, 1, 0, 0}, {kNan, kNan, 7, 8}, kNan, kNan},
      {{1, 1, 1, 0}, {kInfinity, kNan, -kInfinity, 8}, kInfinity, -kInfinity},
  };
  at_every_width([&]<int W>() {
    for (const Reduction& row : rows)
      for (int shift = 0; shift < W; ++shift) {
        Vec<float, W> a;
        std::uint64_t active = 0;
        for (std::size_t i = 0; i < row.a.size(); ++i) {
          const int lane = (static_cast<int>(i) + shift) % W;
          a.set(lane, row.a[i]);
          active |= std::uint64_t{row.active[i]} << lane;
        }
        const auto mask = Mask<W>::from_bits(active);
        EXPECT_TRUE(same(issue(mask, [&](auto& on) { return hmax(on, a); }), row.maximum));
        EXPECT_TRUE(same(issue(mask, [&](auto& on) { return hmin(on, a); }), row.minimum));
      }
    const auto none = Mask<W>::none();
    const Vec<std::int32_t, W> v{};
    EXPECT_EQ(issue(none, [&](auto& on) { return hmax(on, v); }), kLowest);
    EXPECT_EQ(issue(none, [&](auto& on) { return hmin(on, v); }), kHighest);
    EXPECT_EQ(issue(none, [&](auto& on) { return hadd(on, v); }), 0);
    EXPECT_EQ(issue(none, [&](auto& on) { return hand(on, v); }), -1);
    EXPECT_EQ(issue(none, [&](auto& on) { return hor(on, v); }), 0);
    EXPECT_TRUE(same(issue(none, [&](auto& on) { return hadd(on, Vec<float, W>{}); }), 0.0f));
  });
}

TEST(EdgeValues, AtomicMinimumAndMaximumDoNotDependOnTheOrderOfLanes) {
  at_every_width([&]<int W>() {
    for (int shift = 0; shift < W; ++shift) {
      std::vector<float> low{3, kNan, 0.0f, kNan}, high{3, kNan, -0.0f, kNan};
      const auto index =
          repeated<W>(std::vector<std::int32_t>{0, 1, 2, 3, 0, 1}, static_cast<std::size_t>(shift));
      const auto v = repeated<W>(std::vector<float>{kNan, 4, -0.0f, kNan, 3, kNan},
                                 static_cast<std::size_t>(shift));
      issue(Mask<W>::all(), [&](auto& on) {
        scatter_min(on, Memory<float>{low.data(), 4, "low", nullptr}, index, v);
        scatter_max(on, Memory<float>{high.data(), 4, "high", nullptr}, index, neg(on, v));
        return 0;
      });
      EXPECT_TRUE(same(low[0], 3.0f));
      EXPECT_TRUE(same(low[1], 4.0f));
      EXPECT_TRUE(same(low[2], -0.0f));
      EXPECT_TRUE(same(low[3], kNan));
      EXPECT_TRUE(same(high[0], 3.0f));
      EXPECT_TRUE(same(high[1], -4.0f));
      EXPECT_TRUE(same(high[2], 0.0f));
    }
  });
}

/// The definitions for two scalars, and both orders of them.
TEST(EdgeValues, MinimumAndMaximumNumber) {
  const float in[] = {kNan, kSignalling, -kInfinity, -1, -0.0f, 0.0f, 1, kInfinity};
  for (std::size_t i = 0; i < std::size(in); ++i)
    for (std::size_t j = i; j < std::size(in); ++j) {
      const float low = i < 2 ? in[j] : in[i], high = in[j];
      EXPECT_TRUE(same(host::minimum_number(in[i], in[j]), low)) << in[i] << " " << in[j];
      EXPECT_TRUE(same(host::minimum_number(in[j], in[i]), low)) << in[i] << " " << in[j];
      EXPECT_TRUE(same(host::maximum_number(in[i], in[j]), high)) << in[i] << " " << in[j];
      EXPECT_TRUE(same(host::maximum_number(in[j], in[i]), high)) << in[i] << " " << in[j];
    }
}

}  // namespace
}  // namespace lanescope
