// SPDX-License-Identifier: MIT
// Loads and stores of active lanes. Contiguous forms take an element offset for lane 0; gathers
// and scatters take an index for each lane. Pair forms move records of two words, as segment
// instructions of vector ISAs do: record r is elements 2r and 2r + 1.
#pragma once

#include <utility>

#include "simulator/issue.h"

namespace lanescope::isa {
namespace detail_memory {

template <class T, int W>
LANESCOPE_INLINE Vec<std::remove_const_t<T>, W> zero() {
  return {};
}

template <int W, class F, class T>
void touch_contiguous(Mask<W> active, F&& f, Memory<T> memory, std::int64_t offset, Access access) {
  for_each_lane(active, [&](int i) { f(i, memory, offset + i, access); });
}

template <int W, class F, class T>
void touch_indexed(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                   int words, Access access) {
  for_each_lane(active, [&](int i) {
    for (int word = 0; word < words; ++word)
      f(i, memory, std::int64_t{index[i]} * words + word, access);
  });
}

template <int Stride, int W, class T>
LANESCOPE_INLINE Vec<T, W> gather(Mask<W> active, const T* base, const Vec<std::int32_t, W>& index,
                                  Vec<T, W> rest) {
  host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
    rest.chunk[c] = host::gather<Stride>(active.chunk(c), base, index.chunk[c], rest.chunk[c]);
  });
  return rest;
}

template <int Stride, int W, class T>
LANESCOPE_INLINE void scatter(Mask<W> active, T* base, const Vec<std::int32_t, W>& index,
                              const Vec<T, W>& v) {
  host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
    host::scatter<Stride>(active.chunk(c), base, index.chunk[c], v.chunk[c]);
  });
}

}  // namespace detail_memory

/// load(on, memory, offset[, rest])
struct Load {
  static constexpr InstructionInfo kInfo{"load", "r[i] = memory[offset + i]",
                                         InstructionClass::kMemory};
  static constexpr int kRest = 2;
  template <int W, class T>
  LANESCOPE_INLINE static Vec<std::remove_const_t<T>, W> apply(
      Mask<W> active, Memory<T> memory, std::int64_t offset,
      Vec<std::remove_const_t<T>, W> rest = detail_memory::zero<T, W>()) {
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      rest.chunk[c] =
          host::load(active.chunk(c), memory.data + offset + c * kChunkLanes<W>, rest.chunk[c]);
    });
    return rest;
  }
  template <int W, class F, class T, class... Rest>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, std::int64_t offset, const Rest&...) {
    detail_memory::touch_contiguous(active, f, memory, offset, Access::kLoad);
  }
};
inline constexpr Instruction<Load> load;

/// store(on, memory, offset, v)
struct Store {
  static constexpr InstructionInfo kInfo{"store", "memory[offset + i] = v[i]",
                                         InstructionClass::kMemory};
  template <int W, class T>
  LANESCOPE_INLINE static void apply(Mask<W> active, Memory<T> memory, std::int64_t offset,
                                     const Vec<T, W>& v) {
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      host::store(active.chunk(c), memory.data + offset + c * kChunkLanes<W>, v.chunk[c]);
    });
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, std::int64_t offset,
                    const Vec<T, W>&) {
    detail_memory::touch_contiguous(active, f, memory, offset, Access::kStore);
  }
};
inline constexpr Instruction<Store> store;

/// gather(on, memory, index[, rest])
struct Gather {
  static constexpr InstructionInfo kInfo{"gather", "r[i] = memory[index[i]]",
                                         InstructionClass::kMemory};
  static constexpr int kRest = 2;
  template <int W, class T>
  LANESCOPE_INLINE static Vec<std::remove_const_t<T>, W> apply(
      Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
      Vec<std::remove_const_t<T>, W> rest = detail_memory::zero<T, W>()) {
    return detail_memory::gather<1>(active, memory.data, index, rest);
  }
  template <int W, class F, class T, class... Rest>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Rest&...) {
    detail_memory::touch_indexed(active, f, memory, index, 1, Access::kLoad);
  }
};
inline constexpr Instruction<Gather> gather;

/// scatter(on, memory, index, v); lanes with equal indices store in lane order, the last one stays.
struct Scatter {
  static constexpr InstructionInfo kInfo{"scatter", "memory[index[i]] = v[i], in lane order",
                                         InstructionClass::kMemory};
  template <int W, class T>
  LANESCOPE_INLINE static void apply(Mask<W> active, Memory<T> memory,
                                     const Vec<std::int32_t, W>& index, const Vec<T, W>& v) {
    detail_memory::scatter<1>(active, memory.data, index, v);
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&) {
    detail_memory::touch_indexed(active, f, memory, index, 1, Access::kStore);
  }
};
inline constexpr Instruction<Scatter> scatter;

/// load_pair(on, memory, record): a std::pair of vectors.
struct LoadPair {
  static constexpr InstructionInfo kInfo{
      "load_pair", "(r[i], s[i]) = memory[2 k], memory[2 k + 1], k = record + i",
      InstructionClass::kMemory};
  template <int W, class T>
  LANESCOPE_INLINE static auto apply(Mask<W> active, Memory<T> memory, std::int64_t record) {
    using V = Vec<std::remove_const_t<T>, W>;
    const auto* base = memory.data + 2 * record;
    Vec<std::int32_t, W> index;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      index.chunk[c] = host::iota<kChunkLanes<W>>(c * kChunkLanes<W>);
    });
    return std::pair<V, V>(detail_memory::gather<2>(active, base, index, V{}),
                           detail_memory::gather<2>(active, base + 1, index, V{}));
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, std::int64_t record) {
    for_each_lane(active, [&](int i) {
      f(i, memory, 2 * (record + i), Access::kLoad);
      f(i, memory, 2 * (record + i) + 1, Access::kLoad);
    });
  }
};
inline constexpr Instruction<LoadPair> load_pair;

/// gather_pair(on, memory, index[, rest_r, rest_s]): a std::pair of vectors.
struct GatherPair {
  static constexpr InstructionInfo kInfo{
      "gather_pair", "(r[i], s[i]) = memory[2 k], memory[2 k + 1], k = index[i]",
      InstructionClass::kMemory};
  static constexpr int kRest = 2;
  template <int W, class T>
  LANESCOPE_INLINE static auto apply(
      Mask<W> active, Memory<T> memory, const Vec<std::int32_t, W>& index,
      Vec<std::remove_const_t<T>, W> rest_r = detail_memory::zero<T, W>(),
      Vec<std::remove_const_t<T>, W> rest_s = detail_memory::zero<T, W>()) {
    return std::pair(detail_memory::gather<2>(active, memory.data, index, rest_r),
                     detail_memory::gather<2>(active, memory.data + 1, index, rest_s));
  }
  template <int W, class F, class T, class... Rest>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Rest&...) {
    detail_memory::touch_indexed(active, f, memory, index, 2, Access::kLoad);
  }
};
inline constexpr Instruction<GatherPair> gather_pair;

/// scatter_pair(on, memory, index, v, w); in lane order.
struct ScatterPair {
  static constexpr InstructionInfo kInfo{"scatter_pair",
                                         "memory[2 k], memory[2 k + 1] = v[i], w[i], k = index[i]",
                                         InstructionClass::kMemory};
  template <int W, class T>
  LANESCOPE_INLINE static void apply(Mask<W> active, Memory<T> memory,
                                     const Vec<std::int32_t, W>& index, const Vec<T, W>& v,
                                     const Vec<T, W>& w) {
    detail_memory::scatter<2>(active, memory.data, index, v);
    detail_memory::scatter<2>(active, memory.data + 1, index, w);
  }
  template <int W, class F, class T>
  static void touch(Mask<W> active, F&& f, Memory<T> memory, const Vec<std::int32_t, W>& index,
                    const Vec<T, W>&, const Vec<T, W>&) {
    detail_memory::touch_indexed(active, f, memory, index, 2, Access::kStore);
  }
};
inline constexpr Instruction<ScatterPair> scatter_pair;

}  // namespace lanescope::isa
