// SPDX-License-Identifier: MIT
// Loads and stores of chunks: contiguous, indexed, and packed. What the host has no instruction for
// goes lane by lane, in functions that are not inlined: there are many calls, and each would be a
// branch for every lane.
#pragma once

#include "simulator/host_mask.h"

namespace lanescope::host::inline LANESCOPE_HOST {

/// Loads base[0], base[1] ... in the lanes that have a bit; the others keep `rest`.
template <class V>
[[gnu::noinline]] V load_lanes(std::uint32_t bits, const ElementOf<V>* base, V rest) {
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) rest[i] = base[i];
  return rest;
}

template <class V>
[[gnu::noinline]] void store_lanes(std::uint32_t bits, ElementOf<V>* base, V v) {
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) base[i] = v[i];
}

template <int Stride, class V>
[[gnu::noinline]] V gather_lanes(std::uint32_t bits, const ElementOf<V>* base,
                                 Rebind<V, std::int32_t> index, V rest) {
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) rest[i] = base[Stride * static_cast<std::ptrdiff_t>(index[i])];
  return rest;
}

template <int Stride, class V>
[[gnu::noinline]] void scatter_lanes(std::uint32_t bits, ElementOf<V>* base,
                                     Rebind<V, std::int32_t> index, V v) {
  for (int i = 0; i < kLanes<V>; ++i)
    if (bits >> i & 1) base[Stride * static_cast<std::ptrdiff_t>(index[i])] = v[i];
}

template <class V>
[[gnu::noinline]] int pack_lanes(std::uint32_t bits, ElementOf<V>* base, V v) {
  int packed = 0;
  for (int i = 0; i < kLanes<V>; ++i) {
    base[packed] = v[i];
    packed += bits >> i & 1;
  }
  return packed;
}

/// Loads the lanes of the mask from base[0], base[1] ...; the others keep `rest`.
template <class V>
LANESCOPE_INLINE V load(MaskOf<V> mask, const ElementOf<V>* base, V rest) {
#if defined(LANESCOPE_AVX512)
  if constexpr (sizeof(V) == 64) return (V)_mm512_mask_loadu_epi32((__m512i)rest, mask, base);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mask_loadu_epi32((__m256i)rest, static_cast<__mmask8>(mask), base);
#elif defined(__AVX2__)
  if constexpr (sizeof(V) == 32)
    return blend(mask, (V)_mm256_maskload_epi32((const int*)base, (__m256i)mask), rest);
  if constexpr (sizeof(V) == 16)
    return blend(mask, (V)_mm_maskload_epi32((const int*)base, (__m128i)mask), rest);
#endif
  const std::uint32_t bits = bits_of_mask<kLanes<V>>(mask);
  if (bits != (1u << kLanes<V>)-1) return load_lanes(bits, base, rest);
  V v;
  std::memcpy(&v, base, sizeof v);
  return v;
}

/// Stores the lanes of the mask to base[0], base[1] ...
template <class V>
LANESCOPE_INLINE void store(MaskOf<V> mask, ElementOf<V>* base, V v) {
#if defined(LANESCOPE_AVX512)
  if constexpr (sizeof(V) == 64) return _mm512_mask_storeu_epi32(base, mask, (__m512i)v);
  if constexpr (sizeof(V) == 32)
    return _mm256_mask_storeu_epi32(base, static_cast<__mmask8>(mask), (__m256i)v);
#endif
  const std::uint32_t bits = bits_of_mask<kLanes<V>>(mask);
  if (bits != (1u << kLanes<V>)-1) return store_lanes(bits, base, v);
  std::memcpy(base, &v, sizeof v);
}

/// Loads base[Stride * index] in the lanes of the mask; the others keep `rest`.
template <int Stride, class V>
LANESCOPE_INLINE V gather(MaskOf<V> mask, const ElementOf<V>* base, Rebind<V, std::int32_t> index,
                          V rest) {
#if defined(LANESCOPE_AVX512)
  if constexpr (sizeof(V) == 64)
    return (V)_mm512_mask_i32gather_epi32((__m512i)rest, mask, (__m512i)index, base, 4 * Stride);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mmask_i32gather_epi32((__m256i)rest, static_cast<__mmask8>(mask),
                                           (__m256i)index, base, 4 * Stride);
#elif defined(__AVX2__)
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mask_i32gather_epi32((__m256i)rest, (const int*)base, (__m256i)index,
                                          (__m256i)mask, 4 * Stride);
#endif
  return gather_lanes<Stride>(bits_of_mask<kLanes<V>>(mask), base, index, rest);
}

/// Stores to base[Stride * index] the lanes of the mask, in lane order: the last lane wins.
template <int Stride, class V>
LANESCOPE_INLINE void scatter(MaskOf<V> mask, ElementOf<V>* base, Rebind<V, std::int32_t> index,
                              V v) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64)
    return _mm512_mask_i32scatter_epi32(base, mask, (__m512i)index, (__m512i)v, 4 * Stride);
  if constexpr (sizeof(V) == 32)
    return _mm256_mask_i32scatter_epi32(base, static_cast<__mmask8>(mask), (__m256i)index,
                                        (__m256i)v, 4 * Stride);
#endif
  scatter_lanes<Stride>(bits_of_mask<kLanes<V>>(mask), base, index, v);
}

/// Stores the lanes of the mask side by side to base[0], base[1] ... and returns how many; what
/// follows them, up to a whole chunk, is overwritten.
template <class V>
LANESCOPE_INLINE int pack(MaskOf<V> mask, ElementOf<V>* base, V v) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) {
    _mm512_storeu_si512(base, _mm512_maskz_compress_epi32(mask, (__m512i)v));
    return count_bits(mask);
  }
  if constexpr (sizeof(V) == 32) {
    _mm256_storeu_si256((__m256i*)base,
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(mask), (__m256i)v));
    return count_bits(mask);
  }
#endif
  return pack_lanes(bits_of_mask<kLanes<V>>(mask), base, v);
}

/// The lanes of the mask that equal an earlier lane of the mask, as bits.
template <Integers V>
LANESCOPE_INLINE std::uint32_t conflicts(std::uint32_t bits, V v) {
#if defined(LANESCOPE_AVX512) && defined(__AVX512CD__)
  if constexpr (sizeof(V) == 64)
    return _mm512_mask_test_epi32_mask(static_cast<__mmask16>(bits),
                                       _mm512_conflict_epi32((__m512i)v),
                                       _mm512_set1_epi32(static_cast<int>(bits)));
#endif
  std::uint32_t found = 0;
  for (int i = 1; i < kLanes<V>; ++i) {
    const std::uint32_t earlier = bits & ((1u << i) - 1);
    const auto equal = bits_of_mask<kLanes<V>>(compare<Relation::kEqual>(v, broadcast<V>(v[i])));
    found |= static_cast<std::uint32_t>((earlier & equal) != 0) << i;
  }
  return found & bits;
}

}  // namespace lanescope::host::inline LANESCOPE_HOST
