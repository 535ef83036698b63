// SPDX-License-Identifier: MIT
// Instructions that move data between lanes: compaction, permutation, scans, conflict detection.
#pragma once

#include "simulator/instructions/convert.h"
#include "simulator/issue.h"

namespace lanescope::isa {

/// Number of active lanes of a mask up to and including lane i (the thesis, 3.2.2).
///
///   selected  1  0  1  1
///   result    1  1  2  3
///
/// Survivor i of a compaction goes to place result[i] - 1.
struct PrefixSum {
  static constexpr InstructionInfo kInfo{
      "prefix_sum", "r[i] = number of active j <= i with selected[j]", InstructionClass::kScan};
  template <int L>
  LANESCOPE_INLINE static Vec<std::int32_t, L> apply(Mask<L> active, Mask<L> selected) {
    constexpr int N = kChunkLanes<L>;
    using Uints = host::Chunk<std::uint32_t, N>;
    using Ints = host::Chunk<std::int32_t, N>;
    const Uints up_to = (host::broadcast<Uints>(2u) << (Uints)host::iota<N>(0)) - 1u;
    const std::uint64_t both = (active & selected).bits();
    Vec<std::int32_t, L> r;
    int before = 0;
    host::unroll<kChunks<L>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      const auto bits = static_cast<std::uint32_t>(both >> (c * N) & low_bits(N));
      r.chunk[c] = (Ints)host::popcount(up_to & bits) + before;
      before += host::count_bits(bits);
    });
    return r;
  }
};
inline constexpr Instruction<PrefixSum> prefix_sum;

/// Moves the lanes of v that are active and selected to the front, in lane order:
///
///   selected  1  0  1  1
///   v         a  b  c  d
///   result    a  c  d  .      '.' holds nothing to rely on
struct Compress {
  static constexpr InstructionInfo kInfo{
      "compress", "r[k] = a[i], i the k-th active lane with selected[i]", InstructionClass::kScan};
  template <int L, class T>
  LANESCOPE_INLINE static Vec<T, L> apply(Mask<L> active, Mask<L> selected, const Vec<T, L>& a) {
    const Mask<L> moved = active & selected;
    alignas(64) T to[(kChunks<L> + 1) * kChunkLanes<L>];
    T* next = to;
    host::unroll<kChunks<L>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      next += host::pack(moved.chunk(c), next, a.chunk[c]);
    });
    Vec<T, L> r;
    std::memcpy(r.chunk, to, sizeof r.chunk);
    return r;
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L> active, Mask<L> selected, const Vec<T, L>&) {
    return active & selected;
  }
  template <int L, class T>
  static Mask<L> defined(Mask<L> active, Mask<L> selected, const Vec<T, L>&) {
    return Mask<L>::first_n((active & selected).count());
  }
};
inline constexpr Instruction<Compress> compress;

/// The inverse of compress: lane k of v goes to the k-th active and selected lane.
struct Expand {
  static constexpr InstructionInfo kInfo{
      "expand", "r[i] = a[k], i the k-th active lane with selected[i]", InstructionClass::kScan};
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, Mask<L> selected, const Vec<T, L>& a) {
    const auto from = a.lanes();
    std::array<T, L> to{};
    std::size_t next = 0;
    for_each_lane(active & selected,
                  [&](int i) { to[static_cast<std::size_t>(i)] = from[next++]; });
    return Vec<T, L>::from_lanes(to);
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L> active, Mask<L> selected, const Vec<T, L>&) {
    return Mask<L>::first_n((active & selected).count());
  }
  template <int L, class T>
  static Mask<L> defined(Mask<L> active, Mask<L> selected, const Vec<T, L>&) {
    return active & selected;
  }
};
inline constexpr Instruction<Expand> expand;

namespace detail_cross_lane {

/// r[i] = a[source(i)] in active lanes.
template <int L, class T, class F>
Vec<T, L> move_lanes(Mask<L> active, const Vec<T, L>& a, F&& source) {
  const auto from = a.lanes();
  std::array<T, L> to{};
  for_each_lane(active, [&](int i) {
    to[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(source(i))];
  });
  return Vec<T, L>::from_lanes(to);
}

template <int L, class F>
Mask<L> sources(Mask<L> active, F&& source) {
  std::uint64_t bits = 0;
  for_each_lane(active, [&](int i) { bits |= std::uint64_t{1} << source(i); });
  return Mask<L>::from_bits(bits);
}

/// index modulo the width, in [0, width).
inline int wrap(std::int32_t index, Width width) {
  return (index % width.lanes + width.lanes) % width.lanes;
}

}  // namespace detail_cross_lane

/// permute(on, a, index): any lane of a, active or not, that holds a value.
struct Permute {
  static constexpr InstructionInfo kInfo{"permute", "r[i] = a[index[i] modulo W]",
                                         InstructionClass::kScan};
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, Width width, const Vec<T, L>& a,
                         const Vec<std::int32_t, L>& index) {
    return detail_cross_lane::move_lanes(
        active, a, [&](int i) { return detail_cross_lane::wrap(index[i], width); });
  }
  template <int L, class T>
  static Mask<L> reads(int operand, Mask<L> active, Width width, const Vec<T, L>&,
                       const Vec<std::int32_t, L>& index) {
    if (operand == 1) return active;
    return detail_cross_lane::sources<L>(
        active, [&](int i) { return detail_cross_lane::wrap(index[i], width); });
  }
  static constexpr Suspicion kSuspicion{Check::kLaneIndex, "the index is not from 0 to W - 1"};
  template <class T>
  static bool suspicious(Width width, T, std::int32_t index) {
    return index < 0 || index >= width.lanes;
  }
};
inline constexpr Instruction<Permute> permute;

/// shuffle_up(on, a, n): lanes below n keep their own. Requires 0 <= n.
struct ShuffleUp {
  static constexpr InstructionInfo kInfo{"shuffle_up", "r[i] = i >= n ? a[i - n] : a[i]",
                                         InstructionClass::kScan};
  static int source(int i, int n) { return i >= n ? i - n : i; }
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, const Vec<T, L>& a, int n) {
    return detail_cross_lane::move_lanes(active, a, [&](int i) { return source(i, n); });
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L> active, const Vec<T, L>&, int n) {
    return detail_cross_lane::sources<L>(active, [&](int i) { return source(i, n); });
  }
};
inline constexpr Instruction<ShuffleUp> shuffle_up;

/// shuffle_down(on, a, n): the last n lanes keep their own. Requires 0 <= n.
struct ShuffleDown {
  static constexpr InstructionInfo kInfo{"shuffle_down", "r[i] = i + n < W ? a[i + n] : a[i]",
                                         InstructionClass::kScan};
  static int source(int i, int n, Width width) { return n < width.lanes - i ? i + n : i; }
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, Width width, const Vec<T, L>& a, int n) {
    return detail_cross_lane::move_lanes(active, a, [&](int i) { return source(i, n, width); });
  }
  template <int L, class T>
  static Mask<L> reads(int, Mask<L> active, Width width, const Vec<T, L>&, int n) {
    return detail_cross_lane::sources<L>(active, [&](int i) { return source(i, n, width); });
  }
};
inline constexpr Instruction<ShuffleDown> shuffle_down;

namespace detail_cross_lane {

/// Running sums over active lanes, in lane order; integers wrap.
template <bool kInclusive, int L, class T>
Vec<T, L> scan(Mask<L> active, const Vec<T, L>& a) {
  const auto from = a.lanes();
  std::array<T, L> to{};
  T running{};
  for_each_lane(active, [&](int lane) {
    const auto i = static_cast<std::size_t>(lane);
    const T next = host::wrapped<T>(host::wrapping(running) + host::wrapping(from[i]));
    to[i] = kInclusive ? next : running;
    running = next;
  });
  return Vec<T, L>::from_lanes(to);
}

}  // namespace detail_cross_lane

struct InclusiveScan {
  static constexpr InstructionInfo kInfo{"inclusive_scan", "r[i] = sum of active a[j], j <= i",
                                         InstructionClass::kScan};
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, const Vec<T, L>& a) {
    return detail_cross_lane::scan<true>(active, a);
  }
};
inline constexpr Instruction<InclusiveScan> inclusive_scan;

struct ExclusiveScan {
  static constexpr InstructionInfo kInfo{"exclusive_scan", "r[i] = sum of active a[j], j < i",
                                         InstructionClass::kScan};
  template <int L, class T>
  static Vec<T, L> apply(Mask<L> active, const Vec<T, L>& a) {
    return detail_cross_lane::scan<false>(active, a);
  }
};
inline constexpr Instruction<ExclusiveScan> exclusive_scan;

namespace detail_cross_lane {

/// Lane by lane: for hosts that cannot look for conflicts in a whole chunk.
template <int L, class T>
[[gnu::noinline]] Mask<L> conflicts(Mask<L> active, const Vec<T, L>& a) {
  constexpr int N = kChunkLanes<L>;
  const auto lanes = a.lanes();
  const std::uint64_t bits = active.bits();
  std::uint64_t found = 0;
  for_each_lane(active, [&](int i) {
    const auto key = host::broadcast<typename Vec<T, L>::Chunk>(lanes[static_cast<std::size_t>(i)]);
    std::uint64_t equal = 0;
    for (int c = 0; c * N < i; ++c) {
      const auto mask = host::compare<host::Relation::kEqual>(a.chunk[c], key);
      equal |= std::uint64_t{host::bits_of_mask<N>(mask)} << (c * N);
    }
    found |= std::uint64_t{(equal & bits & low_bits(i)) != 0} << i;
  });
  return Mask<L>::from_bits(found);
}

}  // namespace detail_cross_lane

struct Conflict {
  static constexpr InstructionInfo kInfo{"conflict", "m[i] = some active j < i has a[j] == a[i]",
                                         InstructionClass::kScan};
  template <int L, host::Integers T>
  LANESCOPE_INLINE static Mask<L> apply(Mask<L> active, const Vec<T, L>& a) {
    if constexpr (!host::kMaskRegisters) {
      return detail_cross_lane::conflicts(active, a);
    } else {
      constexpr int N = kChunkLanes<L>;
      using Chunk = typename Vec<T, L>::Chunk;
      const auto lanes = a.lanes();
      return Mask<L>::of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
        const std::uint32_t on = host::bits_of_mask<N>(active.chunk(c));
        std::uint32_t bits = host::conflicts(on, a.chunk[c]);
        if constexpr (c > 0) {
          for (std::uint32_t left = on & ~bits; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            const auto key = host::broadcast<Chunk>(lanes[static_cast<std::size_t>(c * N + i)]);
            std::uint32_t equal = 0;
            host::unroll<c>([&](auto d) LANESCOPE_INLINE_LAMBDA {
              equal |=
                  host::bits_of_mask<N>(active.chunk(d)) &
                  host::bits_of_mask<N>(host::compare<host::Relation::kEqual>(a.chunk[d], key));
            });
            bits |= static_cast<std::uint32_t>(equal != 0) << i;
          }
        }
        return host::mask_of_bits<N>(bits);
      });
    }
  }
};
inline constexpr Instruction<Conflict> conflict;

}  // namespace lanescope::isa
