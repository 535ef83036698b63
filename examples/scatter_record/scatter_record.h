// SPDX-License-Identifier: MIT
// Segment instructions for records of four words, as RVV and NEON have them: one instruction moves
// what belongs to a lane together.
#pragma once

#include <utility>

#include "simulator/instruction_set.h"

namespace lanescope {

/// scatter_record(on, memory, index, a, b, c, d); in lane order.
struct ScatterRecord {
  static constexpr InstructionInfo kInfo{"scatter_record",
                                         "record index[i] of four words = (a[i], b[i], c[i], d[i])",
                                         InstructionClass::kMemory};
  template <int L, class T, class V>
  static void apply(Mask<L> active, Memory<T> memory, const Vec<std::int32_t, L>& index, const V& a,
                    const V& b, const V& c, const V& d) {
    for_each_lane(active, [&](int i) {
      T* const record = memory.data + std::int64_t{index[i]} * 4;
      record[0] = a[i], record[1] = b[i], record[2] = c[i], record[3] = d[i];
    });
  }
  template <int L, class F, class T, class... V>
  static void touch(Mask<L> active, F&& f, Memory<T> memory, const Vec<std::int32_t, L>& index,
                    const V&...) {
    for_each_lane(active, [&](int i) {
      for (int word = 0; word < 4; ++word)
        f(i, memory, std::int64_t{index[i]} * 4 + word, Access::kStore);
    });
  }
};
inline constexpr Instruction<ScatterRecord> scatter_record;

/// ((a, b), (c, d)) = load_record(on, memory, first)
struct LoadRecord {
  static constexpr InstructionInfo kInfo{
      "load_record", "((a[i], b[i]), (c[i], d[i])) = record first + i of four words",
      InstructionClass::kMemory};
  template <int L, class T>
  static auto apply(Mask<L> active, Memory<T> memory, std::int64_t first) {
    using V = Vec<std::remove_const_t<T>, L>;
    V words[4];
    for_each_lane(active, [&](int i) {
      for (int word = 0; word < 4; ++word) words[word].set(i, memory.data[(first + i) * 4 + word]);
    });
    return std::pair(std::pair(words[0], words[1]), std::pair(words[2], words[3]));
  }
  template <int L, class F, class T>
  static void touch(Mask<L> active, F&& f, Memory<T> memory, std::int64_t first) {
    for_each_lane(active, [&](int i) {
      for (int word = 0; word < 4; ++word) f(i, memory, (first + i) * 4 + word, Access::kLoad);
    });
  }
};
inline constexpr Instruction<LoadRecord> load_record;

}  // namespace lanescope
