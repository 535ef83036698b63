// SPDX-License-Identifier: MIT
// The registers of the machine: masks, one bit a lane, and vectors of W lanes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "simulator/host_memory.h"

namespace lanescope::inline LANESCOPE_HOST {

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
/// Whether a vector is few enough host registers to be held in them. If it is, instructions are in
/// line; if not, each is a call: in line it would go through memory all the same, at eight or
/// sixteen times the code and the time to compile it.
template <int W>
inline constexpr bool kInRegisters = kChunks<W> <= 4;

/// The bits 0 ... n - 1. Requires 0 <= n <= 64.
constexpr std::uint64_t low_bits(int n) {
  return n >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
}

/// Which lanes are on. A set of bits outside. Inside a mask of the host for each chunk where these
/// stay in registers; else the bits, in one register.
template <int W>
requires LaneCount<W>
class Mask {
 public:
  static constexpr int kLanes = kChunkLanes<W>;  ///< Of a chunk.
  using Chunk = host::ChunkMask<kLanes>;

  Mask() = default;

  /// Lane i is on where bit i is set; bits from W on are ignored.
  LANESCOPE_INLINE static Mask from_bits(std::uint64_t bits) {
    bits &= low_bits(W);
    Mask mask;
    if constexpr (kByChunk) {
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        mask.held_[c] = host::mask_of_bits<kLanes>(chunk_bits(bits, c));
      });
    } else {
      mask.held_ = bits;
    }
    return mask;
  }
  LANESCOPE_INLINE static Mask none() { return Mask{}; }
  LANESCOPE_INLINE static Mask all() { return first_n(W); }
  /// The first n lanes. Requires n >= 0; more than W is all.
  LANESCOPE_INLINE static Mask first_n(int n) {
    const int lanes = n < W ? n : W;
    if constexpr (kByChunk && !host::kMaskRegisters)
      return of_chunks([&](auto c) LANESCOPE_INLINE_LAMBDA {
        return host::mask_below<kLanes>(lanes - c * kLanes);
      });
    else
      return from_bits(low_bits(lanes));
  }
  /// The mask whose chunk c is f(integral_constant c). Requires that no lane from W on is on.
  template <class F>
  LANESCOPE_INLINE static Mask of_chunks(F&& f) {
    Mask mask;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      if constexpr (kByChunk)
        mask.held_[c] = f(c);
      else
        mask.held_ |= std::uint64_t{host::bits_of_mask<kLanes>(f(c))} << (c * kLanes);
    });
    return mask;
  }

  /// The lanes of chunk c of a vector, as the host takes them.
  LANESCOPE_INLINE Chunk chunk(int c) const {
    if constexpr (kByChunk)
      return held_[c];
    else
      return host::mask_of_bits<kLanes>(chunk_bits(held_, c));
  }

  LANESCOPE_INLINE std::uint64_t bits() const {
    if constexpr (!kByChunk) {
      return held_;
    } else if constexpr (host::kMaskRegisters && W == 64) {
      return host::join_halves(pair_bits<0>(), pair_bits<1>());
    } else if constexpr (host::kMaskRegisters && W == 32) {
      return pair_bits<0>();
    } else {
      std::uint64_t all = 0;
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        all |= std::uint64_t{host::bits_of_mask<kLanes>(held_[c])} << (c * kLanes);
      });
      return all;
    }
  }
  /// The bits of chunks 2 P and 2 P + 1, of 16 lanes each, joined in the host's mask registers.
  template <int P>
  LANESCOPE_INLINE std::uint32_t pair_bits() const requires(host::kMaskRegisters) {
    return host::join_chunks(held_[2 * P], held_[2 * P + 1]);
  }
  LANESCOPE_INLINE int count() const { return host::count_bits(bits()); }
  LANESCOPE_INLINE bool any() const {
    if constexpr (kByChunk) {
      Chunk seen{};
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA { seen |= held_[c]; });
      return host::any_lane<kLanes>(seen);
    } else {
      return held_ != 0;
    }
  }
  LANESCOPE_INLINE bool operator[](int lane) const { return bits() >> lane & 1; }
  bool operator==(const Mask& other) const { return bits() == other.bits(); }

  LANESCOPE_INLINE friend Mask operator&(Mask a, Mask b) {
    return combine(a, b, [](auto x, auto y) LANESCOPE_INLINE_LAMBDA { return x & y; });
  }
  LANESCOPE_INLINE friend Mask operator|(Mask a, Mask b) {
    return combine(a, b, [](auto x, auto y) LANESCOPE_INLINE_LAMBDA { return x | y; });
  }
  LANESCOPE_INLINE friend Mask operator^(Mask a, Mask b) {
    return combine(a, b, [](auto x, auto y) LANESCOPE_INLINE_LAMBDA { return x ^ y; });
  }
  LANESCOPE_INLINE friend Mask operator~(Mask a) { return a ^ all(); }

 private:
  static constexpr bool kByChunk = host::kMaskRegisters || kInRegisters<W>;

  LANESCOPE_INLINE static std::uint32_t chunk_bits(std::uint64_t bits, int c) {
    return static_cast<std::uint32_t>(bits >> (c * kLanes) & low_bits(kLanes));
  }
  template <class F>
  LANESCOPE_INLINE static Mask combine(Mask a, Mask b, F f) {
    Mask mask;
    if constexpr (kByChunk) {
      host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
        mask.held_[c] = static_cast<Chunk>(f(a.held_[c], b.held_[c]));
      });
    } else {
      mask.held_ = f(a.held_, b.held_);
    }
    return mask;
  }

  std::conditional_t<kByChunk, Chunk[kChunks<W>], std::uint64_t> held_ = {};
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
  static constexpr int kLanes = W;
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

}  // namespace lanescope::inline LANESCOPE_HOST
