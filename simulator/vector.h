// SPDX-License-Identifier: MIT
// The registers of the machine: masks, one bit a lane, and vectors of W lanes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "simulator/host_memory.h"

namespace lanescope {

/// Numbers of lanes that a machine can be built with. A run uses the first `width` of them.
template <int W>
concept LaneCount = W == 8 || W == 16 || W == 32 || W == 64;

/// How many of a machine's lanes a run uses: lanes 0 ... lanes - 1. The others are never on.
struct Width {
  int lanes;
};

template <int W>
inline constexpr int kChunkLanes = host::chunk_lanes<W>();
template <int W>
inline constexpr int kChunks = (W + kChunkLanes<W> - 1) / kChunkLanes<W>;

/// The bits 0 ... n - 1. Requires 0 <= n <= 64.
constexpr std::uint64_t low_bits(int n) {
  return n >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
}

/// Which lanes are on. A set of bits outside; inside in the host's form, a register for each chunk.
template <int W>
requires LaneCount<W>
class Mask {
 public:
  Mask() = default;

  /// Lane i is on where bit i is set; bits from W on are ignored.
  LANESCOPE_INLINE static Mask from_bits(std::uint64_t bits) {
    Mask mask;
    bits &= low_bits(W);
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      mask.chunk[c] =
          static_cast<host::ChunkBits>(bits >> (c * kChunkLanes<W>)&low_bits(kChunkLanes<W>));
    });
    return mask;
  }
  LANESCOPE_INLINE static Mask none() { return Mask{}; }
  LANESCOPE_INLINE static Mask all() { return from_bits(low_bits(W)); }
  /// The first n lanes. Requires n >= 0; more than W is all.
  LANESCOPE_INLINE static Mask first_n(int n) { return from_bits(low_bits(n < W ? n : W)); }

  LANESCOPE_INLINE std::uint64_t bits() const {
    if constexpr (W == 64 && kChunks<W> == 4) {
      return host::join_halves(pair_bits<0>(), pair_bits<1>());
    } else if constexpr (W == 32 && kChunks<W> == 2) {
      return pair_bits<0>();
    } else {
      std::uint64_t all = 0;
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        all |= std::uint64_t{chunk[c]} << (c * kChunkLanes<W>);
      });
      return all;
    }
  }
  /// The bits of chunks 2 P and 2 P + 1, of 16 lanes each, joined in the host's mask registers.
  template <int P>
  LANESCOPE_INLINE std::uint32_t pair_bits() const {
    return host::join_chunks(chunk[2 * P], chunk[2 * P + 1]);
  }
  LANESCOPE_INLINE int count() const { return host::count_bits(bits()); }
  LANESCOPE_INLINE bool any() const {
    unsigned seen = 0;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA { seen |= chunk[c]; });
    return seen != 0;
  }
  LANESCOPE_INLINE bool operator[](int lane) const { return bits() >> lane & 1; }
  bool operator==(const Mask& other) const { return bits() == other.bits(); }

  LANESCOPE_INLINE friend Mask operator&(Mask a, Mask b) {
    return combine(a, b, [](unsigned x, unsigned y) { return x & y; });
  }
  LANESCOPE_INLINE friend Mask operator|(Mask a, Mask b) {
    return combine(a, b, [](unsigned x, unsigned y) { return x | y; });
  }
  LANESCOPE_INLINE friend Mask operator^(Mask a, Mask b) {
    return combine(a, b, [](unsigned x, unsigned y) { return x ^ y; });
  }
  LANESCOPE_INLINE friend Mask operator~(Mask a) { return a ^ all(); }

  host::ChunkBits chunk[kChunks<W>] = {};

 private:
  template <class F>
  LANESCOPE_INLINE static Mask combine(Mask a, Mask b, F f) {
    Mask mask;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      mask.chunk[c] = static_cast<host::ChunkBits>(f(a.chunk[c], b.chunk[c]));
    });
    return mask;
  }
};

/// Calls f(lane) for each lane that is on, in lane order.
template <int W, class F>
LANESCOPE_INLINE void for_each_lane(Mask<W> active, F&& f) {
  for (std::uint64_t left = active.bits(); left != 0; left &= left - 1) f(std::countr_zero(left));
}

/// W lanes of float, std::int32_t or std::uint32_t.
template <class T, int W>
requires LaneCount<W>
struct Vec {
  using Element = T;
  using Chunk = host::Chunk<T, kChunkLanes<W>>;

  Chunk chunk[kChunks<W>] = {};

  LANESCOPE_INLINE T operator[](int lane) const {
    return chunk[lane / kChunkLanes<W>][lane % kChunkLanes<W>];
  }
  LANESCOPE_INLINE void set(int lane, T value) {
    chunk[lane / kChunkLanes<W>][lane % kChunkLanes<W>] = value;
  }

  /// The lanes as an array; the slow way in and out of instructions that move data between lanes.
  LANESCOPE_INLINE std::array<T, W> lanes() const {
    std::array<T, W> out;
    std::memcpy(out.data(), chunk, sizeof(T) * W);
    return out;
  }
  LANESCOPE_INLINE static Vec from_lanes(const std::array<T, W>& in) {
    Vec v;
    std::memcpy(v.chunk, in.data(), sizeof(T) * W);
    return v;
  }
  LANESCOPE_INLINE static Vec broadcast(T value) {
    Vec v;
    host::unroll<kChunks<W>>(
        [&](auto c) LANESCOPE_INLINE_LAMBDA { v.chunk[c] = host::broadcast<Chunk>(value); });
    return v;
  }
};

}  // namespace lanescope
