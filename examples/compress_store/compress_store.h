// SPDX-License-Identifier: MIT
// Two instructions that several vector ISAs have and the thesis's machine has not: a store that
// packs the active lanes, and a load that spreads over them. Records have a word or two.
#pragma once

#include <utility>

#include "simulator/instruction_set.h"

namespace lanescope {

/// compress_store(on, memory, first, words...)
struct CompressStore {
  static constexpr InstructionInfo kInfo{"compress_store",
                                         "record first + k = words of the k-th active lane",
                                         InstructionClass::kMemory};
  template <int L, class T, class... Words>
  static void apply(Mask<L> active, Memory<T> memory, std::int64_t first, const Words&... words) {
    T* next = memory.data + first * static_cast<int>(sizeof...(Words));
    for_each_lane(active, [&](int lane) { ((*next++ = words[lane]), ...); });
  }
  template <int L, class F, class T, class... Words>
  static void touch(Mask<L> active, F&& f, Memory<T> memory, std::int64_t first, const Words&...) {
    std::int64_t next = first * static_cast<int>(sizeof...(Words));
    for_each_lane(active, [&](int lane) {
      for (std::size_t i = 0; i < sizeof...(Words); ++i) f(lane, memory, next++, Access::kStore);
    });
  }
};
inline constexpr Instruction<CompressStore> compress_store;

/// expand_load(on, memory, first, rest...): a vector, or a std::pair for records of two words.
struct ExpandLoad {
  static constexpr InstructionInfo kInfo{
      "expand_load", "k-th active lane of r (and s) = record first + k", InstructionClass::kMemory};
  static constexpr int kRest = 2;
  template <class T, int L, class U>
  static Vec<T, L> apply(Mask<L> active, Memory<U> memory, std::int64_t first, Vec<T, L> rest) {
    return expanded(active, memory.data + first, 1, rest);
  }
  template <class T, int L, class U>
  static auto apply(Mask<L> active, Memory<U> memory, std::int64_t first, Vec<T, L> rest_r,
                    Vec<T, L> rest_s) {
    return std::pair(expanded(active, memory.data + 2 * first, 2, rest_r),
                     expanded(active, memory.data + 2 * first + 1, 2, rest_s));
  }
  template <int L, class F, class T, class... Rest>
  static void touch(Mask<L> active, F&& f, Memory<T> memory, std::int64_t first, const Rest&...) {
    std::int64_t next = first * static_cast<int>(sizeof...(Rest));
    for_each_lane(active, [&](int lane) {
      for (std::size_t i = 0; i < sizeof...(Rest); ++i) f(lane, memory, next++, Access::kLoad);
    });
  }

 private:
  template <class T, int L>
  static Vec<T, L> expanded(Mask<L> active, const T* next, int stride, Vec<T, L> v) {
    for_each_lane(active, [&](int lane) {
      v.set(lane, *next);
      next += stride;
    });
    return v;
  }
};
inline constexpr Instruction<ExpandLoad> expand_load;

}  // namespace lanescope
