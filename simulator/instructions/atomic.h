// SPDX-License-Identifier: MIT
// Atomic scatters: lanes update memory one after another, in lane order, so that lanes with equal
// indices all count.
#pragma once

#include "simulator/instructions/memory.h"

namespace lanescope::isa {
namespace detail_atomic {

template <int W, class T, class F>
void update(Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index, const Vec<T, W>& v,
            F&& f) {
  for_each_lane(active, [&](int i) {
    T& element = memory.data[index[i]];
    element = f(element, v[i]);
  });
}

/// An update reads what it then stores.
template <int W, class F, class T>
void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index) {
  detail_memory::touch_indexed(active, f, memory, index, 1, Access::kUpdate);
}

}  // namespace detail_atomic

/// scatter_min(on, memory, index, v); likewise the others.
struct ScatterMin {
  static constexpr InstructionInfo kInfo{
      "scatter_min", "memory[index[i]] = minimum of itself and v[i]", InstructionClass::kMemory,
      Charge::kActiveLanes, "zeros and not-a-number as with hmin"};
  template <int W, class T>
  static void apply(Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>& v) {
    detail_atomic::update(active, memory, index, v, host::minimum_number<T>);
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&) {
    detail_atomic::touch(active, f, memory, index);
  }
};
inline constexpr Instruction<ScatterMin> scatter_min;

struct ScatterMax {
  static constexpr InstructionInfo kInfo{
      "scatter_max", "memory[index[i]] = maximum of itself and v[i]", InstructionClass::kMemory,
      Charge::kActiveLanes, "zeros and not-a-number as with hmax"};
  template <int W, class T>
  static void apply(Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>& v) {
    detail_atomic::update(active, memory, index, v, host::maximum_number<T>);
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&) {
    detail_atomic::touch(active, f, memory, index);
  }
};
inline constexpr Instruction<ScatterMax> scatter_max;

struct ScatterAdd {
  static constexpr InstructionInfo kInfo{"scatter_add", "memory[index[i]] += v[i]",
                                         InstructionClass::kMemory, Charge::kActiveLanes,
                                         "lanes with the same index in lane order"};
  template <int W, class T>
  static void apply(Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>& v) {
    detail_atomic::update(active, memory, index, v, [](T x, T y) {
      return host::wrapped<T>(host::wrapping(x) + host::wrapping(y));
    });
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&) {
    detail_atomic::touch(active, f, memory, index);
  }
};
inline constexpr Instruction<ScatterAdd> scatter_add;

struct ScatterOr {
  static constexpr InstructionInfo kInfo{"scatter_or", "memory[index[i]] |= v[i]",
                                         InstructionClass::kMemory};
  template <int W, host::Integers T>
  static void apply(Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>& v) {
    detail_atomic::update(active, memory, index, v, [](T x, T y) { return T(x | y); });
  }
  template <int W, class F, host::Integers T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&) {
    detail_atomic::touch(active, f, memory, index);
  }
};
inline constexpr Instruction<ScatterOr> scatter_or;

}  // namespace lanescope::isa
