// SPDX-License-Identifier: MIT
// Every instruction at every width against a scalar loop. Instructions on single lanes are found
// in the list of the instruction set and tested by themselves; the others have a test below. A
// width passes only if every instruction of the set has been issued.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>

#include "simulator/base/random.h"
#include "simulator/instruction_set.h"

namespace lanescope {
namespace {

using namespace isa;

/// Operands that are often special: zeros, limits, not-a-number, equal values.
class Operands {
 public:
  template <class T>
  T scalar() {
    const std::uint64_t hash = mix64(++state_);
    if constexpr (std::is_same_v<T, float>) {
      static constexpr float kSpecial[] = {0.0f,
                                           -0.0f,
                                           1.0f,
                                           -1.5f,
                                           3.5f,
                                           -2.0f,
                                           1e30f,
                                           -1e30f,
                                           1e-30f,
                                           2147483648.0f,
                                           std::numeric_limits<float>::infinity(),
                                           std::numeric_limits<float>::quiet_NaN()};
      if (hash % 3 == 0) return kSpecial[(hash >> 8) % std::size(kSpecial)];
      return (unit_float(mix64(hash)) - 0.5f) * 200.0f;
    } else {
      static constexpr std::uint32_t kSpecial[] = {0,  1,          2,          31,        32,
                                                   33, 0x7fffffff, 0x80000000, 0xffffffff};
      const auto bits = hash % 2 ? kSpecial[(hash >> 8) % std::size(kSpecial)]
                                 : static_cast<std::uint32_t>(hash >> 16);
      return static_cast<T>(bits);
    }
  }
  template <class T, int W>
  Vec<T, W> vector() {
    Vec<T, W> v;
    for (int i = 0; i < W; ++i) v.set(i, scalar<T>());
    return v;
  }
  template <int W>
  Mask<W> mask() {
    const std::uint64_t hash = mix64(++state_);
    const std::uint64_t bits = mix64(hash);
    return Mask<W>::from_bits(hash % 5 == 0 ? ~std::uint64_t{0} : hash % 5 == 1 ? 0 : bits);
  }
  /// Indices in [0, size).
  template <int W>
  Vec<std::int32_t, W> indices(int size) {
    Vec<std::int32_t, W> v;
    for (int i = 0; i < W; ++i)
      v.set(i, static_cast<std::int32_t>(mix64(++state_) % static_cast<std::uint64_t>(size)));
    return v;
  }

 private:
  std::uint64_t state_ = 0;
};

template <class T>
bool same(T a, T b) {
  if constexpr (std::is_floating_point_v<T>)
    if (std::isnan(a) && std::isnan(b)) return true;
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <int W, class T, class F>
void expect_lanes(Mask<W> active, const Vec<T, W>& result, F&& expected) {
  for_each_lane(active, [&](int i) {
    EXPECT_TRUE(same(result[i], T(expected(i))))
        << "lane " << i << ": " << result[i] << " instead of " << expected(i);
  });
}

template <int W, class F>
void expect_mask(Mask<W> active, Mask<W> result, F&& expected) {
  for (int i = 0; i < W; ++i) EXPECT_EQ(result[i], active[i] && expected(i)) << "lane " << i;
}

/// A machine of one stage, and the operands for it.
template <int W>
struct Bench {
  Machine<W, Mode::kCounting> vm{W, 1};
  Operands operands;

  template <class T>
  Vec<T, W> vec() {
    return operands.vector<T, W>();
  }
  /// Calls f(block) under each of a number of random masks.
  template <class F>
  void under_masks(F&& f) {
    for (int round = 0; round < 12; ++round) {
      auto site = vm.site(0);
      auto on = site.on(operands.template mask<W>());
      f(on);
    }
  }
};

template <class Op, int W, class... T>
void check_lanes(Bench<W>& bench) {
  if constexpr (requires(T... x) { Op::lane(x...); }) {
    SCOPED_TRACE(Op::kInfo.mnemonic);
    bench.under_masks([&](auto& on) {
      const std::tuple<Vec<T, W>...> v{bench.template vec<T>()...};
      std::apply(
          [&](const auto&... x) {
            expect_lanes(on.active(), Instruction<Op>{}(on, x...),
                         [&](int i) { return Op::lane(T(x[i])...); });
          },
          v);
    });
  }
  if constexpr (sizeof...(T) == 2 && requires(T... x) { Op::holds(x...); }) {
    SCOPED_TRACE(Op::kInfo.mnemonic);
    bench.under_masks([&](auto& on) {
      const std::tuple<Vec<T, W>...> v{bench.template vec<T>()...};
      std::apply(
          [&](const auto&... x) {
            expect_mask(on.active(), Instruction<Op>{}(on, x...),
                        [&](int i) { return Op::holds(T(x[i])...); });
          },
          v);
    });
  }
}

template <int W, class... Ops>
void check_all_lanes(Bench<W>& bench, InstructionList<Ops...>) {
  const auto types = [&]<class Op, class T>() {
    check_lanes<Op, W, T>(bench);
    check_lanes<Op, W, T, T>(bench);
    check_lanes<Op, W, T, T, T>(bench);
  };
  (types.template operator()<Ops, float>(), ...);
  (types.template operator()<Ops, std::int32_t>(), ...);
  (types.template operator()<Ops, std::uint32_t>(), ...);
}

template <int W>
void check_moves(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    const auto a = bench.template vec<float>(), b = bench.template vec<float>();
    const auto chosen = bench.operands.template mask<W>();
    expect_lanes(on.active(), select(on, chosen, a, b),
                 [&](int i) { return chosen[i] ? a[i] : b[i]; });
    expect_lanes(on.active(), select(on, chosen, 2.0f, b),
                 [&](int i) { return chosen[i] ? 2.0f : b[i]; });
    expect_lanes(Mask<W>::all(), move(on, a, b),
                 [&](int i) { return on.active()[i] ? a[i] : b[i]; });
    expect_lanes(on.active(), broadcast(on, 7), [](int) { return 7; });
    expect_lanes(on.active(), lane_index(on), [](int i) { return i; });
    expect_lanes(on.active(), add(on, 1.0f, a), [&](int i) { return 1.0f + a[i]; });
  });
}

template <int W>
void check_masks(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    const auto a = bench.operands.template mask<W>(), b = bench.operands.template mask<W>();
    const auto active = on.active();
    expect_mask(active, mask_and(on, a, b), [&](int i) { return a[i] && b[i]; });
    expect_mask(active, mask_or(on, a, b), [&](int i) { return a[i] || b[i]; });
    expect_mask(active, mask_xor(on, a, b), [&](int i) { return a[i] != b[i]; });
    expect_mask(active, mask_andnot(on, a, b), [&](int i) { return a[i] && !b[i]; });
    expect_mask(active, mask_not(on, a), [&](int i) { return !a[i]; });
    int lanes = 0, lowest = -1;
    for (int i = W - 1; i >= 0; --i) {
      lanes += active[i] && a[i];
      if (active[i] && a[i]) lowest = i;
    }
    EXPECT_EQ(count(on, a), lanes);
    EXPECT_EQ(first(on, a), lowest);
    EXPECT_EQ(any(on, a), lanes > 0);
    EXPECT_EQ(none(on, a), lanes == 0);
    EXPECT_EQ(all(on, a), lanes == active.count());
  });
}

/// Memory with known garbage around and between what is stored.
template <class T>
struct Ground {
  explicit Ground(std::size_t size) : elements(size) {
    for (std::size_t i = 0; i < size; ++i) elements[i] = static_cast<T>(1000 + i);
  }
  Memory<T> memory() { return {elements.data(), elements.size(), "ground", nullptr}; }
  std::vector<T> elements;
};

template <int W, class T>
void check_memory(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    const Mask<W> active = on.active();
    Ground<T> ground(3 * W + 5);
    const auto before = ground.elements;
    const auto rest = bench.template vec<T>(), v = bench.template vec<T>(),
               w = bench.template vec<T>();
    const auto at = [&](std::size_t i) { return before[i]; };
    expect_lanes(active, load(on, ground.memory(), 3),
                 [&](int i) { return at(static_cast<std::size_t>(3 + i)); });
    expect_lanes(Mask<W>::all(), load(on, ground.memory(), 3, rest),
                 [&](int i) { return active[i] ? at(static_cast<std::size_t>(3 + i)) : rest[i]; });
    const auto index = bench.operands.template indices<W>(W + 2);
    expect_lanes(Mask<W>::all(), gather(on, ground.memory(), index, rest), [&](int i) {
      return active[i] ? at(static_cast<std::size_t>(index[i])) : rest[i];
    });
    const auto pair = gather_pair(on, ground.memory(), index, rest, v);
    expect_lanes(Mask<W>::all(), pair.first, [&](int i) {
      return active[i] ? at(static_cast<std::size_t>(2 * index[i])) : rest[i];
    });
    expect_lanes(Mask<W>::all(), pair.second, [&](int i) {
      return active[i] ? at(static_cast<std::size_t>(2 * index[i] + 1)) : v[i];
    });
    const auto records = load_pair(on, ground.memory(), 1);
    expect_lanes(active, records.first,
                 [&](int i) { return at(static_cast<std::size_t>(2 + 2 * i)); });
    expect_lanes(active, records.second,
                 [&](int i) { return at(static_cast<std::size_t>(3 + 2 * i)); });

    auto expected = before;
    store(on, ground.memory(), 2, v);
    for_each_lane(active, [&](int i) { expected[static_cast<std::size_t>(2 + i)] = v[i]; });
    scatter(on, ground.memory(), index, w);
    for_each_lane(active, [&](int i) { expected[static_cast<std::size_t>(index[i])] = w[i]; });
    scatter_pair(on, ground.memory(), index, v, w);
    for_each_lane(active, [&](int i) { expected[static_cast<std::size_t>(2 * index[i])] = v[i]; });
    for_each_lane(active,
                  [&](int i) { expected[static_cast<std::size_t>(2 * index[i] + 1)] = w[i]; });
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(same(ground.elements[i], expected[i])) << "element " << i;
  });
}

template <int W>
void check_atomics(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    Ground<std::int32_t> ground(W + 4);
    const auto index = bench.operands.template indices<W>(W / 2 + 1);  // with conflicts
    const auto v = bench.operands.template indices<W>(4000);
    auto expected = ground.elements;
    const auto each = [&](auto&& f) {
      for_each_lane(on.active(), [&](int i) {
        auto& element = expected[static_cast<std::size_t>(index[i])];
        element = f(element, v[i]);
      });
    };
    scatter_add(on, ground.memory(), index, v);
    each([](int x, int y) { return x + y; });
    scatter_min(on, ground.memory(), index, v);
    each([](int x, int y) { return std::min(x, y); });
    scatter_max(on, ground.memory(), index, v);
    each([](int x, int y) { return std::max(x, y); });
    scatter_or(on, ground.memory(), index, v);
    each([](int x, int y) { return x | y; });
    EXPECT_EQ(ground.elements, expected);
  });
}

template <int W, class T>
void check_reductions(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    const auto a = bench.template vec<T>();
    const auto fold = [&](T start, auto&& f) {
      for_each_lane(on.active(), [&](int i) { start = f(start, a[i]); });
      return start;
    };
    constexpr bool kFloat = std::is_floating_point_v<T>;
    using Limits = std::numeric_limits<T>;
    const T lowest = kFloat ? -Limits::infinity() : Limits::min();
    const T highest = kFloat ? Limits::infinity() : Limits::max();
    // Numbers in order, not-a-number left out unless there is nothing else.
    std::vector<T> numbers;
    for_each_lane(on.active(), [&](int i) {
      if (a[i] == a[i]) numbers.push_back(a[i]);
    });
    std::sort(numbers.begin(), numbers.end(), [](T x, T y) {
      if constexpr (kFloat) return x < y || (x == y && std::signbit(x) > std::signbit(y));
      return x < y;
    });
    const bool nothing = numbers.empty() && on.active().any();
    EXPECT_TRUE(same(hmax(on, a), nothing           ? Limits::quiet_NaN()
                                  : numbers.empty() ? lowest
                                                    : numbers.back()));
    EXPECT_TRUE(same(hmin(on, a), nothing           ? Limits::quiet_NaN()
                                  : numbers.empty() ? highest
                                                    : numbers.front()));
    const auto sum = [](T x, T y) {
      if constexpr (kFloat)
        return x + y;
      else
        return static_cast<T>(static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(y));
    };
    EXPECT_TRUE(same(hadd(on, a), fold(T{}, sum)));
    if constexpr (!kFloat) {
      EXPECT_EQ(hand(on, a), fold(static_cast<T>(~T{}), [](T x, T y) { return T(x & y); }));
      EXPECT_EQ(hor(on, a), fold(T{}, [](T x, T y) { return T(x | y); }));
      const auto inclusive = inclusive_scan(on, a), exclusive = exclusive_scan(on, a);
      T running{};
      for_each_lane(on.active(), [&](int i) {
        EXPECT_EQ(exclusive[i], running);
        running = sum(running, a[i]);
        EXPECT_EQ(inclusive[i], running);
      });
    }
  });
}

template <int W>
void check_cross_lane(Bench<W>& bench) {
  bench.under_masks([&](auto& on) {
    const Mask<W> active = on.active();
    const auto selected = bench.operands.template mask<W>();
    const auto a = bench.template vec<float>();
    const auto ranks = prefix_sum(on, selected);
    int rank = 0;
    std::vector<float> packed;
    for (int i = 0; i < W; ++i) {
      if (active[i] && selected[i]) {
        ++rank;
        packed.push_back(a[i]);
      }
      if (active[i]) {
        EXPECT_EQ(ranks[i], rank) << "lane " << i;
      }
    }
    const auto compressed = compress(on, selected, a);
    for (std::size_t k = 0; k < packed.size(); ++k)
      EXPECT_TRUE(same(compressed[static_cast<int>(k)], packed[k]));
    expect_lanes(active & selected, expand(on, selected, compressed), [&](int i) { return a[i]; });
    Vec<std::int32_t, W> index;
    for (int i = 0; i < W; ++i) index.set(i, 3 * i - W);
    expect_lanes(active, permute(on, a, index), [&](int i) { return a[(3 * i + W) % W]; });
    expect_lanes(active, shuffle_up(on, a, 3), [&](int i) { return i >= 3 ? a[i - 3] : a[i]; });
    expect_lanes(active, shuffle_down(on, a, 3),
                 [&](int i) { return i + 3 < W ? a[i + 3] : a[i]; });
    const auto keys = bench.operands.template indices<W>(W);
    expect_mask(active, conflict(on, keys), [&](int i) {
      for (int j = 0; j < i; ++j)
        if (active[j] && keys[j] == keys[i]) return true;
      return false;
    });
  });
}

template <class Width>
class EveryInstruction : public testing::Test {};

template <int W>
using AsType = std::integral_constant<int, W>;
using Widths = testing::Types<AsType<8>, AsType<16>, AsType<32>, AsType<64>>;
struct WidthName {
  template <class T>
  static std::string GetName(int) {
    return fmt::format("W{}", T::value);
  }
};
TYPED_TEST_SUITE(EveryInstruction, Widths, WidthName);

TYPED_TEST(EveryInstruction, EqualsAScalarLoop) {
  constexpr int W = TypeParam::value;
  Bench<W> bench;
  check_all_lanes(bench, InstructionSet{});
  check_moves(bench);
  check_masks(bench);
  check_memory<W, float>(bench);
  check_memory<W, std::int32_t>(bench);
  check_memory<W, std::uint32_t>(bench);
  check_atomics(bench);
  check_reductions<W, float>(bench);
  check_reductions<W, std::int32_t>(bench);
  check_reductions<W, std::uint32_t>(bench);
  check_cross_lane(bench);

  std::set<std::string_view> issued;
  const Counts counts = bench.vm.counts();
  for (const InstructionCounts& kind : counts.stages[0].instructions)
    issued.insert(kind.info->mnemonic);
  for (const InstructionInfo* info : instruction_set())
    EXPECT_TRUE(issued.contains(info->mnemonic)) << info->mnemonic << " has no test";
}

TEST(InstructionSet, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const InstructionInfo* info : instruction_set()) {
    EXPECT_TRUE(names.insert(info->mnemonic).second) << info->mnemonic;
    EXPECT_FALSE(info->meaning.empty()) << info->mnemonic;
  }
}

/// What the definitions say where a reader might expect something else.
TEST(InstructionDefinitions, EdgeCases) {
  constexpr auto kMin = std::numeric_limits<std::int32_t>::min();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(Add::lane(std::int32_t{0x7fffffff}, 1), kMin);
  EXPECT_EQ(Div::lane(std::int32_t{7}, 0), -1);
  EXPECT_EQ(Div::lane(kMin, -1), kMin);
  EXPECT_EQ(Div::lane(std::int32_t{-7}, 2), -3);
  EXPECT_EQ(Div::lane(7u, 0u), ~0u);
  EXPECT_EQ(Abs::lane(kMin), kMin);
  EXPECT_EQ(Min::lane(nan, 1.0f), 1.0f);
  EXPECT_TRUE(std::isnan(Min::lane(1.0f, nan)));
  EXPECT_EQ(Shl::lane(1u, 33u), 2u);
  EXPECT_EQ(Shr::lane(std::int32_t{-8}, 1), -4);
  EXPECT_EQ(Rotl::lane(0x80000001u, 1u), 3u);
  EXPECT_EQ(Clz::lane(0u), 32u);
  EXPECT_EQ(Ctz::lane(std::int32_t{8}), 3);
  EXPECT_EQ(ConvertToInt::lane(-1.9f), -1);
  EXPECT_EQ(ConvertToInt::lane(nan), kMin);
  EXPECT_EQ(ConvertToInt::lane(2147483648.0f), kMin);
  EXPECT_EQ(ConvertToUint::lane(-0.9f), 0u);
  EXPECT_EQ(ConvertToUint::lane(-1.0f), ~0u);
  EXPECT_EQ(Fma::lane(1.0f + 0x1p-23f, 1.0f - 0x1p-23f, -1.0f), -0x1p-46f);
  EXPECT_FALSE(CmpEq::holds(nan, nan));
  EXPECT_TRUE(CmpNe::holds(nan, nan));
  EXPECT_EQ(Rcp::lane(3.0f), 1.0f / 3.0f);
  EXPECT_EQ(Popcount::lane(0xf0f0u), 8u);
}

}  // namespace
}  // namespace lanescope
