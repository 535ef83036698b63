// SPDX-License-Identifier: MIT
// Reductions of active lanes to a scalar: sums in lane order, so that those of floats are the same
// on every host; the others do not depend on it. They are charged the lanes they read.
#pragma once

#include <limits>

#include "simulator/issue.h"

namespace lanescope::isa {
namespace detail_reduce {

/// Folds active lanes in lane order, starting from `start`.
template <int W, class T, class F>
T fold(Mask<W> active, const Vec<T, W>& a, T start, F&& f) {
  const auto lanes = a.lanes();
  for_each_lane(active, [&](int i) { start = f(start, lanes[static_cast<std::size_t>(i)]); });
  return start;
}

/// Folds integers chunk by chunk: for operations in which order does not matter.
template <int W, class T, class F>
LANESCOPE_INLINE T fold_integers(Mask<W> active, const Vec<T, W>& a, T start, F&& f) {
  using Chunk = typename Vec<T, W>::Chunk;
  Chunk folded = host::broadcast<Chunk>(start);
  host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
    folded = f(folded, host::blend(active.chunk(c), a.chunk[c], host::broadcast<Chunk>(start)));
  });
  T result = start;
  for (int i = 0; i < kChunkLanes<W>; ++i) result = T(f(result, T(folded[i])));
  return result;
}

template <class T>
constexpr T lowest() {
  if constexpr (std::is_floating_point_v<T>)
    return -std::numeric_limits<T>::infinity();
  else
    return std::numeric_limits<T>::min();
}
template <class T>
constexpr T highest() {
  if constexpr (std::is_floating_point_v<T>)
    return std::numeric_limits<T>::infinity();
  else
    return std::numeric_limits<T>::max();
}

/// The largest (or smallest) of the active lanes, numbers before not-a-number; `none` if there are
/// none. Does not depend on the order of lanes.
template <int W, class T, class F>
LANESCOPE_INLINE T extreme(Mask<W> active, const Vec<T, W>& a, T none, F&& f) {
  if constexpr (std::is_integral_v<T>) {
    return fold_integers(active, a, none, f);
  } else {
    const Mask<W> numbers = active & Mask<W>::of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
                              return host::compare<host::Relation::kEqual>(a.chunk[c], a.chunk[c]);
                            });
    if (!numbers.any()) return active.any() ? std::numeric_limits<T>::quiet_NaN() : none;
    Vec<std::int32_t, W> ordered;
    host::unroll<kChunks<W>>(
        [&](auto c) LANESCOPE_INLINE_LAMBDA { ordered.chunk[c] = host::ordered_bits(a.chunk[c]); });
    return host::from_ordered_bits(fold_integers(numbers, ordered, host::ordered_bits(none), f));
  }
}

}  // namespace detail_reduce

/// Floats are compared as integers of the same order, in which -0 is below +0: see ordered_bits().
struct Hmax {
  static constexpr InstructionInfo kInfo{
      "hmax", "x = maximum of the active a[i]", InstructionClass::kReduce, Charge::kActiveLanes,
      "not-a-number only if every active lane is that, else they do not count; +0 is above -0; "
      "-infinity or the lowest integer if no lane is active"};
  template <int W, class T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::extreme(active, a, detail_reduce::lowest<T>(),
                                  [](auto x, auto y) { return host::max(x, y); });
  }
};
inline constexpr Instruction<Hmax> hmax;

struct Hmin {
  static constexpr InstructionInfo kInfo{
      "hmin", "x = minimum of the active a[i]", InstructionClass::kReduce, Charge::kActiveLanes,
      "not-a-number only if every active lane is that, else they do not count; -0 is below +0; "
      "infinity or the highest integer if no lane is active"};
  template <int W, class T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::extreme(active, a, detail_reduce::highest<T>(),
                                  [](auto x, auto y) { return host::min(x, y); });
  }
};
inline constexpr Instruction<Hmin> hmin;

struct Hadd {
  static constexpr InstructionInfo kInfo{"hadd", "x = sum of the active a[i], in lane order",
                                         InstructionClass::kReduce, Charge::kActiveLanes,
                                         "begins with +0, which is also the sum of no lane"};
  template <int W, class T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    if constexpr (std::is_integral_v<T>)
      return detail_reduce::fold_integers(active, a, T{}, [](auto x, auto y) {
        return host::wrapped<decltype(x)>(host::wrapping(x) + host::wrapping(y));
      });
    else
      return detail_reduce::fold(active, a, T{}, [](T x, T y) { return x + y; });
  }
};
inline constexpr Instruction<Hadd> hadd;

struct Hand {
  static constexpr InstructionInfo kInfo{"hand", "x = bitwise and of the active a[i]",
                                         InstructionClass::kReduce, Charge::kActiveLanes,
                                         "all bits set if no lane is active"};
  template <int W, host::Integers T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::fold_integers(active, a, T(~T{}), [](auto x, auto y) { return x & y; });
  }
};
inline constexpr Instruction<Hand> hand;

struct Hor {
  static constexpr InstructionInfo kInfo{"hor", "x = bitwise or of the active a[i]",
                                         InstructionClass::kReduce, Charge::kActiveLanes,
                                         "0 if no lane is active"};
  template <int W, host::Integers T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::fold_integers(active, a, T{}, [](auto x, auto y) { return x | y; });
  }
};
inline constexpr Instruction<Hor> hor;

}  // namespace lanescope::isa
