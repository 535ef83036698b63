// SPDX-License-Identifier: MIT
// Reductions of active lanes to a scalar, in lane order (so that sums of floats are the same on
// every host). They are charged the lanes they read.
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
    folded = f(folded, host::blend(active.chunk[c], a.chunk[c], host::broadcast<Chunk>(start)));
  });
  T result = start;
  for (int i = 0; i < kChunkLanes<W>; ++i) result = f(result, T(folded[i]));
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

}  // namespace detail_reduce

/// The lowest value of the type if no lane is active.
struct Hmax {
  static constexpr InstructionInfo kInfo{"hmax", "maximum of the active a[i]",
                                         InstructionClass::kReduce};
  template <int W, class T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    const auto larger = [](auto x, auto y) { return host::max(x, y); };
    if constexpr (std::is_integral_v<T>)
      return detail_reduce::fold_integers(active, a, detail_reduce::lowest<T>(), larger);
    else
      return detail_reduce::fold(active, a, detail_reduce::lowest<T>(), larger);
  }
};
inline constexpr Instruction<Hmax> hmax;

/// The highest value of the type if no lane is active.
struct Hmin {
  static constexpr InstructionInfo kInfo{"hmin", "minimum of the active a[i]",
                                         InstructionClass::kReduce};
  template <int W, class T>
  LANESCOPE_INLINE static T apply(Mask<W> active, const Vec<T, W>& a) {
    const auto smaller = [](auto x, auto y) { return host::min(x, y); };
    if constexpr (std::is_integral_v<T>)
      return detail_reduce::fold_integers(active, a, detail_reduce::highest<T>(), smaller);
    else
      return detail_reduce::fold(active, a, detail_reduce::highest<T>(), smaller);
  }
};
inline constexpr Instruction<Hmin> hmin;

/// Integers wrap.
struct Hadd {
  static constexpr InstructionInfo kInfo{"hadd", "sum of the active a[i], in lane order",
                                         InstructionClass::kReduce};
  template <int W, class T>
  static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::fold(active, a, T{}, [](T x, T y) {
      return host::wrapped<T>(host::wrapping(x) + host::wrapping(y));
    });
  }
};
inline constexpr Instruction<Hadd> hadd;

struct Hand {
  static constexpr InstructionInfo kInfo{"hand", "bitwise and of the active a[i]",
                                         InstructionClass::kReduce};
  template <int W, host::Integers T>
  static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::fold(active, a, T(~T{}), [](T x, T y) { return T(x & y); });
  }
};
inline constexpr Instruction<Hand> hand;

struct Hor {
  static constexpr InstructionInfo kInfo{"hor", "bitwise or of the active a[i]",
                                         InstructionClass::kReduce};
  template <int W, host::Integers T>
  static T apply(Mask<W> active, const Vec<T, W>& a) {
    return detail_reduce::fold(active, a, T{}, [](T x, T y) { return T(x | y); });
  }
};
inline constexpr Instruction<Hor> hor;

}  // namespace lanescope::isa
