// SPDX-License-Identifier: MIT
// Masks of chunks, in the form that the host's instructions give and take: with AVX-512 a mask
// register, one bit a lane; elsewhere a vector with all bits of a lane set or none.
#pragma once

#include "simulator/host.h"

namespace lanescope::host::inline LANESCOPE_HOST {

#ifdef LANESCOPE_AVX512
/// Which lanes of a chunk of N are on.
template <int N>
using ChunkMask = std::uint16_t;
inline constexpr bool kMaskRegisters = true;
#else
template <int N>
using ChunkMask = Chunk<std::int32_t, N>;
inline constexpr bool kMaskRegisters = false;
#endif
/// The mask of a chunk like V.
template <class V>
using MaskOf = ChunkMask<kLanes<V>>;

/// Number of set bits; the compiler's own would narrow the operand and then widen the result.
LANESCOPE_INLINE int count_bits(std::uint64_t bits) {
#ifdef __SSE4_2__
  return static_cast<int>(_mm_popcnt_u64(bits));
#else
  return std::popcount(bits);
#endif
}

/// The bits of two chunks of 16 lanes as one word.
LANESCOPE_INLINE std::uint32_t join_chunks(std::uint16_t low, std::uint16_t high) {
#ifdef LANESCOPE_AVX512
  return _mm512_kunpackw(high, low);
#else
  return low | std::uint32_t{high} << 16;
#endif
}

/// Two words of 32 lanes as one.
LANESCOPE_INLINE std::uint64_t join_halves(std::uint32_t low, std::uint32_t high) {
#ifdef LANESCOPE_AVX512
  return _mm512_kunpackd(high, low);
#else
  return low | std::uint64_t{high} << 32;
#endif
}

/// -1 in the lanes of `bits`, 0 elsewhere.
template <int N>
LANESCOPE_INLINE Chunk<std::int32_t, N> expand_bits(std::uint32_t bits) {
#ifdef LANESCOPE_AVX512
  if constexpr (N == 16)
    return (Chunk<std::int32_t, N>)_mm512_movm_epi32(static_cast<__mmask16>(bits));
  if constexpr (N == 8)
    return (Chunk<std::int32_t, N>)_mm256_movm_epi32(static_cast<__mmask8>(bits));
#endif
  const auto lane = broadcast<Chunk<std::uint32_t, N>>(1u) << (Chunk<std::uint32_t, N>)iota<N>(0);
  return (Chunk<std::int32_t, N>)((lane & bits) == lane);
}

/// The sign bit of each lane.
template <int N>
LANESCOPE_INLINE std::uint32_t collect_bits(Chunk<std::int32_t, N> lanes) {
#ifdef __AVX2__
  if constexpr (N == 8) return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)lanes));
#endif
#ifdef __SSE4_2__
  if constexpr (N == 4) return static_cast<std::uint32_t>(_mm_movemask_ps((__m128)lanes));
#endif
  std::uint32_t bits = 0;
  for (int i = 0; i < N; ++i) bits |= static_cast<std::uint32_t>(lanes[i] < 0) << i;
  return bits;
}

/// The mask of the lanes whose bits are set. Requires no bits from N on.
template <int N>
LANESCOPE_INLINE ChunkMask<N> mask_of_bits(std::uint32_t bits) {
  if constexpr (kMaskRegisters)
    return static_cast<ChunkMask<N>>(bits);
  else
    return expand_bits<N>(bits);
}

/// The inverse of mask_of_bits().
template <int N>
LANESCOPE_INLINE std::uint32_t bits_of_mask(ChunkMask<N> mask) {
  if constexpr (kMaskRegisters)
    return mask;
  else
    return collect_bits<N>(mask);
}

/// The mask of the lanes below n, any number.
template <int N>
LANESCOPE_INLINE ChunkMask<N> mask_below(int n) {
  if constexpr (kMaskRegisters)
    return static_cast<ChunkMask<N>>(n >= N ? (1u << N) - 1 : n > 0 ? (1u << n) - 1 : 0u);
  else
    return (ChunkMask<N>)(iota<N>(0) < n);
}

/// Whether some lane is on.
template <int N>
LANESCOPE_INLINE bool any_lane(ChunkMask<N> mask) {
#ifdef LANESCOPE_AVX512
  return mask != 0;
#else
#ifdef __AVX2__
  if constexpr (N == 8) return !_mm256_testz_si256((__m256i)mask, (__m256i)mask);
#endif
#ifdef __SSE4_2__
  if constexpr (N == 4) return !_mm_testz_si128((__m128i)mask, (__m128i)mask);
#endif
  return collect_bits<N>(mask) != 0;
#endif
}

enum class Relation { kEqual, kNotEqual, kLess, kLessEqual };

/// Whether the relation holds; false for not-a-number except kNotEqual, as in C++.
template <Relation R, class V>
LANESCOPE_INLINE auto relate(V a, V b) {
  if constexpr (R == Relation::kEqual)
    return a == b;
  else if constexpr (R == Relation::kNotEqual)
    return a != b;
  else if constexpr (R == Relation::kLess)
    return a < b;
  else
    return a <= b;
}

/// The lanes in which the relation holds.
template <Relation R, class V>
LANESCOPE_INLINE MaskOf<V> compare(V a, V b) {
#ifdef LANESCOPE_AVX512
  constexpr int kFloat = R == Relation::kEqual      ? _CMP_EQ_OQ
                         : R == Relation::kNotEqual ? _CMP_NEQ_UQ
                         : R == Relation::kLess     ? _CMP_LT_OQ
                                                    : _CMP_LE_OQ;
  constexpr int kInteger = R == Relation::kEqual      ? _MM_CMPINT_EQ
                           : R == Relation::kNotEqual ? _MM_CMPINT_NE
                           : R == Relation::kLess     ? _MM_CMPINT_LT
                                                      : _MM_CMPINT_LE;
  using T = ElementOf<V>;
  if constexpr (sizeof(V) == 64) {
    if constexpr (Floats<V>)
      return _mm512_cmp_ps_mask(a, b, kFloat);
    else if constexpr (std::is_signed_v<T>)
      return _mm512_cmp_epi32_mask((__m512i)a, (__m512i)b, kInteger);
    else
      return _mm512_cmp_epu32_mask((__m512i)a, (__m512i)b, kInteger);
  }
  if constexpr (sizeof(V) == 32) {
    if constexpr (Floats<V>)
      return _mm256_cmp_ps_mask(a, b, kFloat);
    else if constexpr (std::is_signed_v<T>)
      return _mm256_cmp_epi32_mask((__m256i)a, (__m256i)b, kInteger);
    else
      return _mm256_cmp_epu32_mask((__m256i)a, (__m256i)b, kInteger);
  }
  return static_cast<MaskOf<V>>(
      collect_bits<kLanes<V>>((Chunk<std::int32_t, kLanes<V>>)relate<R>(a, b)));
#else
  return (MaskOf<V>)relate<R>(a, b);
#endif
}

/// a where the lane is on, b elsewhere.
template <class V>
LANESCOPE_INLINE V blend(MaskOf<V> mask, V a, V b) {
#if defined(LANESCOPE_AVX512)
  if constexpr (sizeof(V) == 64) return (V)_mm512_mask_blend_epi32(mask, (__m512i)b, (__m512i)a);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mask_blend_epi32(static_cast<__mmask8>(mask), (__m256i)b, (__m256i)a);
  return expand_bits<kLanes<V>>(mask) ? a : b;
#else
#ifdef __AVX2__
  if constexpr (sizeof(V) == 32) return (V)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)mask);
#endif
#ifdef __SSE4_2__
  if constexpr (sizeof(V) == 16) return (V)_mm_blendv_ps((__m128)b, (__m128)a, (__m128)mask);
#endif
  return mask ? a : b;
#endif
}

}  // namespace lanescope::host::inline LANESCOPE_HOST
