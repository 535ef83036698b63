// SPDX-License-Identifier: MIT
// Loads and stores of chunks: contiguous, indexed, and packed.
#pragma once

#include "simulator/host.h"

namespace lanescope::host {

/// Loads the lanes of `bits` from base[0], base[1] ...; the others keep `rest`.
template <class V>
LANESCOPE_INLINE V load(ChunkBits bits, const ElementOf<V>* base, V rest) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) return (V)_mm512_mask_loadu_epi32((__m512i)rest, bits, base);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mask_loadu_epi32((__m256i)rest, static_cast<__mmask8>(bits), base);
#endif
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) rest[i] = base[i];
  return rest;
}

/// Stores the lanes of `bits` to base[0], base[1] ...
template <class V>
LANESCOPE_INLINE void store(ChunkBits bits, ElementOf<V>* base, V v) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) return _mm512_mask_storeu_epi32(base, bits, (__m512i)v);
  if constexpr (sizeof(V) == 32)
    return _mm256_mask_storeu_epi32(base, static_cast<__mmask8>(bits), (__m256i)v);
#endif
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) base[i] = v[i];
}

/// Loads base[Stride * index] in the lanes of `bits`; the others keep `rest`.
template <int Stride, class V>
LANESCOPE_INLINE V gather(ChunkBits bits, const ElementOf<V>* base, Rebind<V, std::int32_t> index,
                          V rest) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64)
    return (V)_mm512_mask_i32gather_epi32((__m512i)rest, bits, (__m512i)index, base, 4 * Stride);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mmask_i32gather_epi32((__m256i)rest, static_cast<__mmask8>(bits),
                                           (__m256i)index, base, 4 * Stride);
#endif
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) rest[i] = base[Stride * static_cast<std::ptrdiff_t>(index[i])];
  return rest;
}

/// Stores to base[Stride * index] the lanes of `bits`, in lane order: the last lane wins.
template <int Stride, class V>
LANESCOPE_INLINE void scatter(ChunkBits bits, ElementOf<V>* base, Rebind<V, std::int32_t> index,
                              V v) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64)
    return _mm512_mask_i32scatter_epi32(base, bits, (__m512i)index, (__m512i)v, 4 * Stride);
  if constexpr (sizeof(V) == 32)
    return _mm256_mask_i32scatter_epi32(base, static_cast<__mmask8>(bits), (__m256i)index,
                                        (__m256i)v, 4 * Stride);
#endif
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) base[Stride * static_cast<std::ptrdiff_t>(index[i])] = v[i];
}

/// Stores the lanes of `bits` side by side to base[0], base[1] ... and returns how many; what
/// follows them, up to a whole chunk, is overwritten.
template <class V>
LANESCOPE_INLINE int pack(ChunkBits bits, ElementOf<V>* base, V v) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) {
    _mm512_storeu_si512(base, _mm512_maskz_compress_epi32(bits, (__m512i)v));
    return count_bits(bits);
  }
  if constexpr (sizeof(V) == 32) {
    _mm256_storeu_si256((__m256i*)base,
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), (__m256i)v));
    return count_bits(bits);
  }
#endif
  int packed = 0;
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) base[packed++] = v[i];
  return packed;
}

}  // namespace lanescope::host
