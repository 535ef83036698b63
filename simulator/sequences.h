// SPDX-License-Identifier: MIT
// What a machine issues in place of an instruction that it lacks, written in the instructions of
// this machine: each function gives the lanes that the instruction gives. A description of a
// machine (docs/machines.md) names a sequence by its entry in sequences(), and what the sequence
// issues is found by executing it.
//
// Sums of floats are in another order than those of the instruction, products are rounded by
// themselves, and extremes of floats treat zeros and not-a-number as `min` and `max` do; in all
// else the lanes are the same.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "simulator/instruction_set.h"
#include "simulator/observer.h"

namespace lanescope {
namespace isa {

/// Between vector and scalar registers. Sequences need these beside the instruction set.
struct ExtractLane {
  static constexpr InstructionInfo kInfo{"extract_lane", "lane n of a, as a scalar",
                                         InstructionClass::kMove};
  template <int L, class T>
  static T apply(Mask<L>, const Vec<T, L>& a, int lane) {
    return a[lane];
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L>, const Vec<T, L>&, int lane) {
    return Mask<L>::from_bits(std::uint64_t{1} << lane);
  }
};
inline constexpr Instruction<ExtractLane> extract_lane;

struct MaskBits {
  static constexpr InstructionInfo kInfo{"mask_bits", "bit i of a scalar = active lane i of a",
                                         InstructionClass::kMask};
  template <int L>
  static std::uint64_t apply(Mask<L> active, Mask<L> a) {
    return (active & a).bits();
  }
};
inline constexpr Instruction<MaskBits> mask_bits;

/// shift_up(on, a, n): shuffle_up that brings in zeros. Requires 0 <= n.
struct ShiftUp {
  static constexpr InstructionInfo kInfo{"shift_up", "r[i] = i >= n ? a[i - n] : 0",
                                         InstructionClass::kMove};
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, const Vec<T, L>& a, int n) {
    Vec<T, L> r;
    for_each_lane(active, [&](int i) {
      if (i >= n) r.set(i, a[i - n]);
    });
    return r;
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L> active, const Vec<T, L>&, int n) {
    return Mask<L>::from_bits(n < 64 ? active.bits() >> n : 0);
  }
};
inline constexpr Instruction<ShiftUp> shift_up;

}  // namespace isa

/// A sequence that can stand for an instruction.
struct SequenceInfo {
  std::string_view name;
  std::string_view replaces;  ///< A mnemonic; empty: any instruction from outside the set.
  std::string_view meaning;
  /// It takes the lanes that are on one after another: what it issues is for each of them, and
  /// nothing for others.
  bool lane_by_lane;
  /// Executes it once with these lanes on, on a machine of that width that tells the observer.
  void (*execute)(int width, std::uint64_t active, Observer& observer);
};

/// Every sequence, by name.
std::span<const SequenceInfo> sequences();

/// The instructions beside the set that sequences issue.
std::span<const InstructionInfo* const> sequence_instructions();

/// Each takes a machine, a site in which it opens blocks of its own, the lanes that are on, and the
/// operands of the instruction; memory that it needs follows.
namespace sequence {

/// A constant, which a program holds in a register: lane i holds f(i).
template <class Vm, class F>
auto constant(F&& f) {
  Vec<std::int32_t, Vm::kLanes> v;
  for (int i = 0; i < Vm::kLanes; ++i) v.set(i, static_cast<std::int32_t>(f(i)));
  return v;
}

template <class Vm>
typename Vm::Lanes only(int lane) {
  return Vm::Lanes::from_bits(std::uint64_t{1} << lane);
}

// -- Arithmetic --------------------------------------------------------------------------------

template <class Vm, class A, class B, class C>
auto fma_by_mul_add(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a, const B& b,
                    const C& c) {
  auto on = site.on(active);
  return isa::add(on, isa::mul(on, a, b), c);
}

template <class Vm, class A>
auto rcp_by_div(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  auto on = site.on(active);
  return isa::div(on, 1.0f, a);
}

// -- Bits of uint32 ----------------------------------------------------------------------------

/// A shift by n and one by 32 - n; shifts take counts modulo 32.
template <class Vm, class A, class N>
auto rotl_by_shifts(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a,
                    const N& n) {
  auto on = site.on(active);
  return isa::bit_or(on, isa::shl(on, a, n), isa::shr(on, a, isa::neg(on, n)));
}

/// Sums of 2, 4 and 8 bits, then of four bytes by a product.
template <class Vm, class A>
auto popcount_by_bits(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  auto on = site.on(active);
  const auto every = [&](const auto& v, int n, std::uint32_t bits) {
    return isa::bit_and(on, isa::shr(on, v, n), bits);
  };
  const auto twos = isa::sub(on, a, every(a, 1, 0x55555555u));
  const auto fours = isa::add(on, isa::bit_and(on, twos, 0x33333333u), every(twos, 2, 0x33333333u));
  const auto bytes = isa::bit_and(on, isa::add(on, fours, isa::shr(on, fours, 4)), 0x0f0f0f0fu);
  return isa::shr(on, isa::mul(on, bytes, 0x01010101u), 24);
}

/// The zeros above the highest bit are those that stay when all below it are set.
template <class Vm, class A>
auto clz_by_popcount(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  auto on = site.on(active);
  auto filled = isa::bit_or(on, a, isa::shr(on, a, 1));
  for (int n = 2; n < 32; n *= 2) filled = isa::bit_or(on, filled, isa::shr(on, filled, n));
  return isa::popcount(on, isa::bit_not(on, filled));
}

/// The zeros below the lowest bit are those that a subtraction of 1 sets.
template <class Vm, class A>
auto ctz_by_popcount(Vm&, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  auto on = site.on(active);
  return isa::popcount(on, isa::bit_andnot(on, isa::sub(on, a, 1), a));
}

// -- Scans -------------------------------------------------------------------------------------

/// Sums over 2, 4, 8, ... lanes of all lanes.
template <class Vm, class A>
A running_sums(Vm& vm, typename Vm::Site& site, A sums) {
  auto on = site.on(vm.all());
  for (int n = 1; n < vm.width(); n *= 2) sums = isa::add(on, sums, isa::shift_up(on, sums, n));
  return sums;
}

template <class Vm, class A>
auto inclusive_scan_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                                const A& a) {
  return running_sums(vm, site, isa::select(site.on(vm.all()), active, a, typename A::Element{}));
}

template <class Vm, class A>
auto exclusive_scan_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                                const A& a) {
  const auto sums = inclusive_scan_by_shuffles(vm, site, active, a);
  return isa::shift_up(site.on(vm.all()), sums, 1);
}

template <class Vm>
auto prefix_sum_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                            typename Vm::Lanes selected) {
  const auto zeros = isa::broadcast(site.on(vm.all()), 0);
  return running_sums(vm, site, isa::select(site.on(vm.all()), active & selected, 1, zeros));
}

/// The mask as a scalar, in each lane the bits up to its own, counted: 32 lanes at a time.
template <class Vm>
auto prefix_sum_by_popcount(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                            typename Vm::Lanes selected) {
  auto on = site.on(vm.all());
  const std::uint64_t bits = isa::mask_bits(on, active & selected);
  const auto counted = [&](int first) {
    const auto up_to = constant<Vm>(
        [&](int i) { return i < first ? 0 : static_cast<std::int64_t>(low_bits(i - first + 1)); });
    return isa::popcount(on, isa::bit_and(on, up_to, static_cast<std::int32_t>(bits >> first)));
  };
  auto ranks = counted(0);
  if (vm.width() > 32) ranks = isa::add(on, ranks, counted(32));
  return ranks;
}

// -- Reductions --------------------------------------------------------------------------------

/// Combines the upper half of the lanes with the lower, until one is left.
template <class Vm, class A, class Combine>
typename A::Element reduced(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a,
                            typename A::Element none, Combine&& combine) {
  auto values = isa::select(site.on(vm.all()), active, a, none);
  for (int left = vm.width(); left > 1;) {
    const int half = (left + 1) / 2;
    const int pairs = left - half;
    auto on = site.on(vm.first_n(pairs));
    auto combined = combine(on, values, isa::shuffle_down(on, values, half));
    if (pairs < half) combined = isa::move(on, combined, values);  // A lane without a partner.
    values = combined;
    left = half;
  }
  return isa::extract_lane(site.on(vm.first_n(1)), values, 0);
}

template <class Vm, class A>
auto hmax_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  return reduced(vm, site, active, a, isa::detail_reduce::lowest<typename A::Element>(), isa::max);
}
template <class Vm, class A>
auto hmin_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  return reduced(vm, site, active, a, isa::detail_reduce::highest<typename A::Element>(), isa::min);
}
template <class Vm, class A>
auto hadd_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  return reduced(vm, site, active, a, typename A::Element{}, isa::add);
}
template <class Vm, class A>
auto hand_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  return reduced(vm, site, active, a, static_cast<typename A::Element>(-1), isa::bit_and);
}
template <class Vm, class A>
auto hor_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  return reduced(vm, site, active, a, typename A::Element{}, isa::bit_or);
}

// -- Lanes that move ---------------------------------------------------------------------------

/// Each survivor is stored at its rank; `scratch` has room for a vector.
template <class Vm, class A>
auto compress_by_scatter(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                         typename Vm::Lanes selected, const A& a,
                         Memory<typename A::Element> scratch) {
  auto on = site.on(active);
  const auto place = isa::sub(on, isa::prefix_sum(on, selected), 1);
  isa::scatter(site.on(active & selected), scratch, place, a);
  return isa::load(site.on(vm.all()), scratch, 0);
}

/// The places of the lanes of a byte that are set, then zeros: what `compress_by_table` looks up.
constexpr std::array<std::int32_t, 8 * 256> compaction_table() {
  std::array<std::int32_t, 8 * 256> table{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    std::size_t next = 8 * byte;
    for (int lane = 0; lane < 8; ++lane)
      if ((byte >> lane & 1) != 0) table[next++] = lane;
  }
  return table;
}

/// Eight lanes at a time, each permuted as a table says for its part of the mask and stored behind
/// the one before. `from` has room for a vector, `to` for 8 lanes more.
template <class Vm, class A>
auto compress_by_table(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                       typename Vm::Lanes selected, const A& a, Memory<const std::int32_t> table,
                       Memory<typename A::Element> from, Memory<typename A::Element> to) {
  auto whole = site.on(vm.all());
  isa::store(whole, from, 0, a);
  const std::uint64_t bits = isa::mask_bits(whole, active & selected);
  int next = 0;
  for (int first = 0; first < vm.width(); first += 8) {
    const auto byte = static_cast<int>(bits >> first & 0xff);
    auto on = site.on(vm.first_n(std::min(8, vm.width() - first)));
    const auto places = isa::load(on, table, 8 * byte);
    isa::store(on, to, next, isa::permute(on, isa::load(on, from, first), places));
    next += std::popcount(static_cast<unsigned>(byte));
  }
  return isa::load(whole, to, 0);
}

template <class Vm, class A>
auto expand_by_permute(Vm&, typename Vm::Site& site, typename Vm::Lanes active,
                       typename Vm::Lanes selected, const A& a) {
  auto on = site.on(active);
  const auto rank = isa::sub(on, isa::prefix_sum(on, selected), 1);
  return isa::permute(site.on(active & selected), a, rank);
}

/// Compares each lane with every one before it, by their distance.
template <class Vm, class A>
auto conflict_by_shuffles(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active, const A& a) {
  auto found = Vm::Lanes::none();
  for (int n = 1; n < vm.width(); ++n) {
    const auto earlier = Vm::Lanes::from_bits(active.bits() << n) & vm.all();
    auto on = site.on(active & earlier);
    found = isa::mask_or(site.on(active), found, isa::cmp_eq(on, a, isa::shuffle_up(on, a, n)));
  }
  return found;
}

// -- Memory ------------------------------------------------------------------------------------

template <class Vm, class T, class I>
auto gather_by_lanes(Vm&, typename Vm::Site& site, typename Vm::Lanes active, Memory<T> memory,
                     const I& index) {
  decltype(isa::load(site.on(active), memory, 0)) result{};
  for_each_lane(active, [&](int lane) {
    auto on = site.on(only<Vm>(lane));
    result = isa::load(on, memory, isa::extract_lane(on, index, lane) - lane, result);
  });
  return result;
}

template <class Vm, class T, class I, class V>
void scatter_by_lanes(Vm&, typename Vm::Site& site, typename Vm::Lanes active, Memory<T> memory,
                      const I& index, const V& v) {
  for_each_lane(active, [&](int lane) {
    auto on = site.on(only<Vm>(lane));
    isa::store(on, memory, isa::extract_lane(on, index, lane) - lane, v);
  });
}

/// Reads an element, combines it with the lane and writes it, one lane after another.
template <class Vm, class T, class I, class V, class Combine>
void update_by_lanes(Vm&, typename Vm::Site& site, typename Vm::Lanes active, Memory<T> memory,
                     const I& index, const V& v, Combine&& combine) {
  for_each_lane(active, [&](int lane) {
    auto on = site.on(only<Vm>(lane));
    const std::int64_t offset = isa::extract_lane(on, index, lane) - lane;
    isa::store(on, memory, offset, combine(on, isa::load(on, memory, offset), v));
  });
}

/// Each word by itself.
template <class Vm, class T, class I>
auto gather_pair_by_gathers(Vm&, typename Vm::Site& site, typename Vm::Lanes active,
                            Memory<T> memory, const I& index) {
  auto on = site.on(active);
  const auto first = isa::shl(on, index, 1);
  const auto r = isa::gather(on, memory, first);
  return std::pair(r, isa::gather(on, memory.part(1, memory.size - 1), first));
}

template <class Vm, class T, class I, class V>
void scatter_pair_by_scatters(Vm&, typename Vm::Site& site, typename Vm::Lanes active,
                              Memory<T> memory, const I& index, const V& v, const V& w) {
  auto on = site.on(active);
  const auto first = isa::shl(on, index, 1);
  isa::scatter(on, memory, first, v);
  isa::scatter(on, memory.part(1, memory.size - 1), first, w);
}

/// Two vectors of words, taken apart. Reads the records of all lanes.
template <class Vm, class T>
auto load_pair_by_permutes(Vm& vm, typename Vm::Site& site, typename Vm::Lanes active,
                           Memory<T> memory, std::int64_t record) {
  const int width = vm.width();
  auto whole = site.on(vm.all());
  const auto low = isa::load(whole, memory, 2 * record);
  const auto high = isa::load(whole, memory, 2 * record + width);
  auto on = site.on(active);
  const auto words = [&](int word) {
    const auto place = constant<Vm>([&](int i) { return 2 * i + word; });
    return isa::select(on, vm.first_n((width - word + 1) / 2), isa::permute(on, low, place),
                       isa::permute(on, high, place));
  };
  return std::pair(words(0), words(1));
}

}  // namespace sequence
}  // namespace lanescope
