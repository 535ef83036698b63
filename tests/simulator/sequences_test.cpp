// SPDX-License-Identifier: MIT
// Every sequence gives the lanes that the instruction gives which it replaces, at every number of
// lanes, at widths that are no power of two as well, under random masks.
#include "simulator/sequences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "simulator/base/random.h"

namespace lanescope {
namespace {

using namespace isa;

/// A machine of one stage that is not full, and operands.
template <int L>
struct Emulation {
  using Vm = Machine<L, Mode::kCounting>;
  using Ints = Vec<std::int32_t, L>;
  using Uints = Vec<std::uint32_t, L>;
  using Floats = Vec<float, L>;

  explicit Emulation(int width) : vm(width, 1) {}

  std::uint64_t number() { return mix64(++state); }
  template <class T>
  Vec<T, L> vec() {
    Vec<T, L> v;
    // Small numbers, so that sums and products of floats are exact.
    for (int i = 0; i < L; ++i)
      v.set(i, static_cast<T>(static_cast<std::int64_t>(number() % 2001) - 1000));
    return v;
  }
  Uints bits() {
    Uints v;
    for (int i = 0; i < L; ++i)
      v.set(i, number() % 8 == 0 ? 0 : static_cast<std::uint32_t>(number()) >> number() % 32);
    return v;
  }
  /// Distinct places of a memory of `size` elements.
  Ints places(int size) {
    Ints v;
    for (int i = 0; i < L; ++i) v.set(i, static_cast<std::int32_t>((i * 37) % size));
    return v;
  }
  Mask<L> mask() {
    const std::uint64_t kind = number() % 6;
    const std::uint64_t bits = kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : number();
    return Mask<L>::from_bits(bits) & vm.all();
  }

  Vm vm;
  std::uint64_t state = 0;
};

template <int L, class V>
void expect_same(const char* name, Mask<L> active, const V& emulated, const V& real) {
  for_each_lane(active, [&](int i) { EXPECT_EQ(emulated[i], real[i]) << name << ", lane " << i; });
}

/// Calls f(emulation, site, active) at some widths that need L lanes, under several masks.
template <int L, class F>
void at_widths(F&& f) {
  for (const int width : {L, L - 1, L / 2 + 1}) {
    SCOPED_TRACE(::testing::Message() << "W = " << width << " on " << L << " lanes");
    Emulation<L> e(width);
    for (int round = 0; round < 8; ++round) {
      auto site = e.vm.site(0);
      f(e, site, e.mask());
    }
  }
}

template <class Lanes>
class Sequences : public ::testing::Test {};
using AllLanes = ::testing::Types<std::integral_constant<int, 8>, std::integral_constant<int, 16>,
                                  std::integral_constant<int, 32>, std::integral_constant<int, 64>>;
TYPED_TEST_SUITE(Sequences, AllLanes);

TYPED_TEST(Sequences, OfArithmeticAndBits) {
  constexpr int L = TypeParam::value;
  at_widths<L>([](auto& e, auto& site, Mask<L> active) {
    auto on = site.on(active);
    const auto a = e.template vec<float>(), b = e.template vec<float>(),
               c = e.template vec<float>();
    expect_same("fma", active, sequence::fma_by_mul_add(e.vm, site, active, a, b, c),
                fma(on, a, b, c));
    expect_same("rcp", active, sequence::rcp_by_div(e.vm, site, active, a), rcp(on, a));
    const auto x = e.bits(), n = e.bits();
    expect_same("rotl", active, sequence::rotl_by_shifts(e.vm, site, active, x, n), rotl(on, x, n));
    expect_same("popcount", active, sequence::popcount_by_bits(e.vm, site, active, x),
                popcount(on, x));
    expect_same("clz", active, sequence::clz_by_popcount(e.vm, site, active, x), clz(on, x));
    expect_same("ctz", active, sequence::ctz_by_popcount(e.vm, site, active, x), ctz(on, x));
  });
}

TYPED_TEST(Sequences, OfScans) {
  constexpr int L = TypeParam::value;
  at_widths<L>([](auto& e, auto& site, Mask<L> active) {
    auto on = site.on(active);
    const Mask<L> selected = e.mask();
    expect_same("prefix_sum by shuffles", active,
                sequence::prefix_sum_by_shuffles(e.vm, site, active, selected),
                prefix_sum(on, selected));
    expect_same("prefix_sum by popcount", active,
                sequence::prefix_sum_by_popcount(e.vm, site, active, selected),
                prefix_sum(on, selected));
    const auto a = e.template vec<std::int32_t>();
    expect_same("inclusive_scan", active,
                sequence::inclusive_scan_by_shuffles(e.vm, site, active, a), inclusive_scan(on, a));
    expect_same("exclusive_scan", active,
                sequence::exclusive_scan_by_shuffles(e.vm, site, active, a), exclusive_scan(on, a));
  });
}

TYPED_TEST(Sequences, OfReductions) {
  constexpr int L = TypeParam::value;
  at_widths<L>([](auto& e, auto& site, Mask<L> active) {
    auto on = site.on(active);
    const auto a = e.template vec<std::int32_t>();
    const auto f = e.template vec<float>();
    EXPECT_EQ(sequence::hmax_by_shuffles(e.vm, site, active, a), hmax(on, a));
    EXPECT_EQ(sequence::hmin_by_shuffles(e.vm, site, active, a), hmin(on, a));
    EXPECT_EQ(sequence::hadd_by_shuffles(e.vm, site, active, a), hadd(on, a));
    EXPECT_EQ(sequence::hand_by_shuffles(e.vm, site, active, a), hand(on, a));
    EXPECT_EQ(sequence::hor_by_shuffles(e.vm, site, active, a), hor(on, a));
    EXPECT_EQ(sequence::hmax_by_shuffles(e.vm, site, active, f), hmax(on, f));
    EXPECT_EQ(sequence::hadd_by_shuffles(e.vm, site, active, f), hadd(on, f));
  });
}

TYPED_TEST(Sequences, OfLanesThatMove) {
  constexpr int L = TypeParam::value;
  static constexpr auto kTable = sequence::compaction_table();
  at_widths<L>([](auto& e, auto& site, Mask<L> active) {
    auto on = site.on(active);
    const Mask<L> selected = e.mask();
    const auto a = e.template vec<std::int32_t>();
    Buffer<std::int32_t> from(L, "from", false), to(L + 8, "to", false);
    const Mask<L> front = Mask<L>::first_n((active & selected).count());
    const auto compressed = compress(on, selected, a);
    expect_same("compress by scatter", front,
                sequence::compress_by_scatter(e.vm, site, active, selected, a, from.memory()),
                compressed);
    expect_same("compress by table", front,
                sequence::compress_by_table(e.vm, site, active, selected, a,
                                            read_only(kTable.data(), kTable.size(), "table"),
                                            from.memory(), to.memory()),
                compressed);
    expect_same("expand", active & selected,
                sequence::expand_by_permute(e.vm, site, active, selected, a),
                expand(on, selected, a));
    auto repeated = a;
    for (int i = 0; i < L; ++i) repeated.set(i, a[i] & 3);
    EXPECT_EQ(sequence::conflict_by_shuffles(e.vm, site, active, repeated), conflict(on, repeated));
  });
}

TYPED_TEST(Sequences, OfMemory) {
  constexpr int L = TypeParam::value;
  at_widths<L>([](auto& e, auto& site, Mask<L> active) {
    auto on = site.on(active);
    constexpr int kSize = 256;
    const auto index = e.places(kSize / 2);
    const auto v = e.template vec<std::int32_t>(), w = e.template vec<std::int32_t>();
    Buffer<std::int32_t> one(kSize, "one", false), other(kSize, "other", false);
    std::vector<std::int32_t> words(kSize);
    for (std::int32_t& word : words) word = static_cast<std::int32_t>(e.number() % 1000);
    one.fill(0, words.data(), kSize);
    other.fill(0, words.data(), kSize);
    const auto same_memory = [&](const char* name) {
      EXPECT_TRUE(std::equal(one.data(), one.data() + kSize, other.data())) << name;
    };

    expect_same("gather", active,
                sequence::gather_by_lanes(e.vm, site, active, one.memory(), index),
                gather(on, one.memory(), index));
    const auto pair = sequence::gather_pair_by_gathers(e.vm, site, active, one.memory(), index);
    const auto real = gather_pair(on, one.memory(), index);
    expect_same("gather_pair", active, pair.first, real.first);
    expect_same("gather_pair", active, pair.second, real.second);
    const auto loaded = sequence::load_pair_by_permutes(e.vm, site, active, one.memory(), 3);
    const auto really = load_pair(on, one.memory(), 3);
    expect_same("load_pair", active, loaded.first, really.first);
    expect_same("load_pair", active, loaded.second, really.second);

    sequence::scatter_by_lanes(e.vm, site, active, one.memory(), index, v);
    scatter(on, other.memory(), index, v);
    same_memory("scatter");
    sequence::scatter_pair_by_scatters(e.vm, site, active, one.memory(), index, v, w);
    scatter_pair(on, other.memory(), index, v, w);
    same_memory("scatter_pair");
    auto colliding = index;
    for (int i = 0; i < L; ++i) colliding.set(i, index[i] & 3);
    sequence::update_by_lanes(e.vm, site, active, one.memory(), colliding, v, add);
    scatter_add(on, other.memory(), colliding, v);
    same_memory("scatter_add");
    sequence::update_by_lanes(e.vm, site, active, one.memory(), colliding, v, min);
    scatter_min(on, other.memory(), colliding, v);
    same_memory("scatter_min");
    sequence::update_by_lanes(e.vm, site, active, one.memory(), colliding, w, max);
    scatter_max(on, other.memory(), colliding, w);
    same_memory("scatter_max");
    sequence::update_by_lanes(e.vm, site, active, one.memory(), colliding, w, bit_or);
    scatter_or(on, other.memory(), colliding, w);
    same_memory("scatter_or");
  });
}

/// Counts what a sequence issues, by mnemonic, and its lanes.
class IssueCount final : public Observer {
 public:
  void issued(const IssueEvent& event) override {
    ++by_mnemonic[std::string(event.info.mnemonic)];
    lanes.push_back(std::popcount(event.active));
  }
  std::map<std::string, int> by_mnemonic;
  std::vector<int> lanes;
};

const SequenceInfo& sequence_of(std::string_view name) {
  const auto all = sequences();
  return *std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
}

std::map<std::string, int> issues_of(std::string_view name, int width) {
  IssueCount count;
  sequence_of(name).execute(width, ~std::uint64_t{0}, count);
  return count.by_mnemonic;
}

using Issues = std::map<std::string, int>;

TEST(SequenceList, IssuesWhatCanBeCountedByHand) {
  EXPECT_EQ(issues_of("fma_by_mul_add", 16), (Issues{{"mul", 1}, {"add", 1}}));
  EXPECT_EQ(issues_of("prefix_sum_by_shuffles", 16),
            (Issues{{"broadcast", 1}, {"select", 1}, {"shift_up", 4}, {"add", 4}}));
  EXPECT_EQ(issues_of("prefix_sum_by_popcount", 32),
            (Issues{{"mask_bits", 1}, {"bit_and", 1}, {"popcount", 1}}));
  EXPECT_EQ(issues_of("prefix_sum_by_popcount", 64),
            (Issues{{"mask_bits", 1}, {"bit_and", 2}, {"popcount", 2}, {"add", 1}}));
  EXPECT_EQ(issues_of("hmax_by_shuffles", 8),
            (Issues{{"select", 1}, {"shuffle_down", 3}, {"max", 3}, {"extract_lane", 1}}));
  EXPECT_EQ(
      issues_of("hmax_by_shuffles", 6),
      (Issues{{"select", 1}, {"shuffle_down", 3}, {"max", 3}, {"move", 1}, {"extract_lane", 1}}));
  EXPECT_EQ(issues_of("gather_by_lanes", 5), (Issues{{"extract_lane", 5}, {"load", 5}}));
}

TEST(SequenceList, AReductionLeavesHalfOfTheLanesAtEachStep) {
  IssueCount count;
  sequence_of("hadd_by_shuffles").execute(16, ~std::uint64_t{0}, count);
  EXPECT_EQ(count.lanes, (std::vector<int>{16, 8, 8, 4, 4, 2, 2, 1, 1, 1}));
}

TEST(SequenceList, IsSortedAndReplacesInstructionsOfTheSet) {
  std::set<std::string_view> set;
  for (const InstructionInfo* info : instruction_set()) set.insert(info->mnemonic);
  std::string_view before;
  for (const SequenceInfo& sequence : sequences()) {
    EXPECT_LT(before, sequence.name);
    before = sequence.name;
    EXPECT_TRUE(sequence.replaces.empty() || set.contains(sequence.replaces)) << sequence.name;
    for (const int width : {1, 2, 7, 64}) {
      IssueCount count;
      sequence.execute(width, ~std::uint64_t{0}, count);
      EXPECT_TRUE(!count.lanes.empty() || width == 1) << sequence.name;
      if (sequence.lane_by_lane) {
        EXPECT_EQ(count.lanes, std::vector<int>(count.lanes.size(), 1)) << sequence.name;
      }
    }
  }
}

}  // namespace
}  // namespace lanescope
