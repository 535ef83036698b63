// SPDX-License-Identifier: MIT
// The host's side of the machine: a simulated vector is an array of chunks, each a vector type of
// the compiler. Operators work on chunks as they do on scalars; what has no operator is here, for
// a scalar (the definition) and for a chunk (the same, lane by lane, as fast as the host can).
// Loads and stores are in host_memory.h.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#if defined(__SSE4_2__)
#include <immintrin.h>
#endif

#define LANESCOPE_INLINE [[gnu::always_inline]] inline
#define LANESCOPE_INLINE_LAMBDA __attribute__((always_inline))

namespace lanescope::host {

/// Lanes of a chunk for a machine of width W. What W leaves of the last chunk is never active.
template <int W>
constexpr int chunk_lanes() {
#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
  if (W >= 16) return 16;
  if (W == 8) return 8;
#elif defined(__AVX2__)
  if (W % 8 == 0) return 8;
#endif
  return 4;
}

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
#define LANESCOPE_AVX512 1
#endif

template <class T, int N>
struct ChunkOf {
  typedef T type __attribute__((vector_size(sizeof(T) * N)));
};
template <class T, int N>
using Chunk = typename ChunkOf<T, N>::type;

/// One bit a lane of a chunk: the host's mask register.
using ChunkBits = std::uint16_t;

template <class V>
struct Element {
  using type = std::remove_cvref_t<decltype(std::declval<V>()[0])>;
  static constexpr int kLanes = static_cast<int>(sizeof(V) / sizeof(type));
};
template <class V>
requires std::is_arithmetic_v<V>
struct Element<V> {
  using type = V;
  static constexpr int kLanes = 1;
};

/// float, std::int32_t or std::uint32_t: what one lane of V holds.
template <class V>
using ElementOf = typename Element<V>::type;
template <class V>
inline constexpr int kLanes = Element<V>::kLanes;
/// The vector type like V with elements of U, or U itself for a scalar.
template <class V, class U>
struct Rebound {
  using type = Chunk<U, kLanes<V>>;
};
template <class V, class U>
requires std::is_arithmetic_v<V>
struct Rebound<V, U> {
  using type = U;
};
template <class V, class U>
using Rebind = typename Rebound<V, U>::type;

template <class V>
concept Scalar = std::is_arithmetic_v<V>;
template <class V>
concept Floats = std::same_as < ElementOf<V>,
float > ;
template <class V>
concept Integers = std::integral<ElementOf<V>>;

/// Calls f(integral_constant 0) ... f(integral_constant N - 1), unrolled.
template <int N, class F>
LANESCOPE_INLINE void unroll(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) LANESCOPE_INLINE_LAMBDA {
    (f(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// Applies a scalar function lane by lane.
template <class R, class F, class... V>
LANESCOPE_INLINE R map(F f, V... v) {
  if constexpr (Scalar<R>) {
    return f(v...);
  } else {
    R r{};
    for (int i = 0; i < kLanes<R>; ++i) r[i] = f(v[i]...);
    return r;
  }
}

/// Reinterprets the bits of each lane.
template <class U, class V>
LANESCOPE_INLINE Rebind<V, U> bits_as(V v) {
  return std::bit_cast<Rebind<V, U>>(v);
}

/// A view of integers as unsigned, in which arithmetic wraps; floats stay as they are.
template <class V>
LANESCOPE_INLINE auto wrapping(V v) {
  if constexpr (Floats<V>)
    return v;
  else
    return bits_as<std::uint32_t>(v);
}
/// The inverse of wrapping().
template <class V, class U>
LANESCOPE_INLINE V wrapped(U u) {
  return std::bit_cast<V>(u);
}

template <class V>
LANESCOPE_INLINE V broadcast(ElementOf<V> s) {
  if constexpr (Scalar<V>) {
    return s;
  } else {
    return s - V{};  // a splat: s - 0 is s, also for -0 and NaN
  }
}

/// 0, 1, 2 ... plus `first`, as int32.
template <int N>
LANESCOPE_INLINE Chunk<std::int32_t, N> iota(int first) {
  return [&]<int... I>(std::integer_sequence<int, I...>) LANESCOPE_INLINE_LAMBDA {
    return Chunk<std::int32_t, N>{(first + I)...};
  }
  (std::make_integer_sequence<int, N>{});
}

// Picks the host instruction of the chunk's size; chunks of other hosts go lane by lane.
#ifdef LANESCOPE_AVX512
#define LANESCOPE_HOST_FLOAT(name, ...)        \
  if constexpr (sizeof(V) == 64)               \
    return (V)_mm512_##name##_ps(__VA_ARGS__); \
  else if constexpr (sizeof(V) == 32)          \
    return (V)_mm256_##name##_ps(__VA_ARGS__); \
  else if constexpr (sizeof(V) == 16)          \
    return (V)_mm_##name##_ps(__VA_ARGS__);    \
  else
#elif defined(__AVX2__)
#define LANESCOPE_HOST_FLOAT(name, ...)        \
  if constexpr (sizeof(V) == 32)               \
    return (V)_mm256_##name##_ps(__VA_ARGS__); \
  else if constexpr (sizeof(V) == 16)          \
    return (V)_mm_##name##_ps(__VA_ARGS__);    \
  else
#elif defined(__SSE4_2__)
#define LANESCOPE_HOST_FLOAT(name, ...)     \
  if constexpr (sizeof(V) == 16)            \
    return (V)_mm_##name##_ps(__VA_ARGS__); \
  else
#else
#define LANESCOPE_HOST_FLOAT(name, ...)
#endif

/// a < b ? a : b, so b where either is not a number.
template <class V>
LANESCOPE_INLINE V min(V a, V b) {
  if constexpr (Scalar<V>) {
    return a < b ? a : b;
  } else {
    if constexpr (Floats<V>) {
      LANESCOPE_HOST_FLOAT(min, a, b) { return a < b ? a : b; }
    } else {
      return a < b ? a : b;
    }
  }
}

/// a > b ? a : b, so b where either is not a number.
template <class V>
LANESCOPE_INLINE V max(V a, V b) {
  if constexpr (Scalar<V>) {
    return a > b ? a : b;
  } else {
    if constexpr (Floats<V>) {
      LANESCOPE_HOST_FLOAT(max, a, b) { return a > b ? a : b; }
    } else {
      return a > b ? a : b;
    }
  }
}

/// Correctly rounded square root.
template <Floats V>
LANESCOPE_INLINE V sqrt(V a) {
  const auto lane = [](float x) { return std::sqrt(x); };
  if constexpr (Scalar<V>) {
    return lane(a);
  } else {
    LANESCOPE_HOST_FLOAT(sqrt, a) { return map<V>(lane, a); }
  }
}

/// Rounds towards minus infinity.
template <Floats V>
LANESCOPE_INLINE V floor(V a) {
  const auto lane = [](float x) { return std::floor(x); };
  if constexpr (Scalar<V>) {
    return lane(a);
  } else {
    LANESCOPE_HOST_FLOAT(floor, a) { return map<V>(lane, a); }
  }
}

/// Rounds towards plus infinity.
template <Floats V>
LANESCOPE_INLINE V ceil(V a) {
  const auto lane = [](float x) { return std::ceil(x); };
  if constexpr (Scalar<V>) {
    return lane(a);
  } else {
    LANESCOPE_HOST_FLOAT(ceil, a) { return map<V>(lane, a); }
  }
}

/// a * b + c, rounded once.
template <Floats V>
LANESCOPE_INLINE V fma(V a, V b, V c) {
  const auto lane = [](float x, float y, float z) { return std::fma(x, y, z); };
  if constexpr (Scalar<V>) {
    return lane(a, b, c);
  } else {
#ifdef __FMA__
    LANESCOPE_HOST_FLOAT(fmadd, a, b, c)
#endif
    {
      return map<V>(lane, a, b, c);
    }
  }
}

/// Truncates to int32; out of range and not-a-number give the most negative int32.
template <Floats V>
LANESCOPE_INLINE Rebind<V, std::int32_t> to_int(V a) {
  using R = Rebind<V, std::int32_t>;
  const auto lane = [](float x) {
    return x >= -0x1p31f && x < 0x1p31f ? static_cast<std::int32_t>(x)
                                        : std::numeric_limits<std::int32_t>::min();
  };
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) return (R)_mm512_cvttps_epi32(a);
#endif
#ifdef __AVX2__
  if constexpr (sizeof(V) == 32) return (R)_mm256_cvttps_epi32(a);
#endif
#ifdef __SSE4_2__
  if constexpr (sizeof(V) == 16) return (R)_mm_cvttps_epi32(a);
#endif
  return map<R>(lane, a);
}

/// Truncates to uint32; out of range and not-a-number give the largest uint32.
template <Floats V>
LANESCOPE_INLINE Rebind<V, std::uint32_t> to_uint(V a) {
  using R = Rebind<V, std::uint32_t>;
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) return (R)_mm512_cvttps_epu32(a);
  if constexpr (sizeof(V) == 32) return (R)_mm256_cvttps_epu32(a);
#endif
  return map<R>(
      [](float x) {
        return x > -1.0f && x < 0x1p32f ? static_cast<std::uint32_t>(x)
                                        : std::numeric_limits<std::uint32_t>::max();
      },
      a);
}

/// Rounds an integer to the nearest float.
template <Integers V>
LANESCOPE_INLINE Rebind<V, float> to_float(V a) {
  if constexpr (Scalar<V>)
    return static_cast<float>(a);
  else
    return __builtin_convertvector(a, Rebind<V, float>);
}

template <Integers V>
LANESCOPE_INLINE V popcount(V a) {
#if defined(LANESCOPE_AVX512) && defined(__AVX512VPOPCNTDQ__)
  if constexpr (sizeof(V) == 64) return (V)_mm512_popcnt_epi32((__m512i)a);
#endif
  return map<V>([](auto x) { return decltype(x)(std::popcount(static_cast<std::uint32_t>(x))); },
                a);
}

/// Number of set bits; the compiler's own would narrow the operand and then widen the result.
LANESCOPE_INLINE int count_bits(std::uint64_t bits) {
#ifdef __SSE4_2__
  return static_cast<int>(_mm_popcnt_u64(bits));
#else
  return std::popcount(bits);
#endif
}

/// The bits of two chunks of 16 lanes as one word.
LANESCOPE_INLINE std::uint32_t join_chunks(ChunkBits low, ChunkBits high) {
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
LANESCOPE_INLINE Chunk<std::int32_t, N> expand_bits(ChunkBits bits) {
#ifdef LANESCOPE_AVX512
  if constexpr (N == 16) return (Chunk<std::int32_t, N>)_mm512_movm_epi32(bits);
  if constexpr (N == 8)
    return (Chunk<std::int32_t, N>)_mm256_movm_epi32(static_cast<__mmask8>(bits));
#endif
  const auto bit = broadcast<Chunk<std::uint32_t, N>>(1u) << (Chunk<std::uint32_t, N>)iota<N>(0);
  return (bit & std::uint32_t{bits}) != 0;
}

/// The sign bit of each lane of a comparison's result.
template <int N>
LANESCOPE_INLINE ChunkBits collect_bits(Chunk<std::int32_t, N> lanes) {
#ifdef __AVX2__
  if constexpr (N == 8) return static_cast<ChunkBits>(_mm256_movemask_ps((__m256)lanes));
#endif
#ifdef __SSE4_2__
  if constexpr (N == 4) return static_cast<ChunkBits>(_mm_movemask_ps((__m128)lanes));
#endif
  unsigned bits = 0;
  for (int i = 0; i < N; ++i) bits |= static_cast<unsigned>(lanes[i] < 0) << i;
  return static_cast<ChunkBits>(bits);
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
LANESCOPE_INLINE ChunkBits compare(V a, V b) {
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
#endif
  return collect_bits<kLanes<V>>((Chunk<std::int32_t, kLanes<V>>)relate<R>(a, b));
}

/// a where the bit is set, b elsewhere.
template <class V>
LANESCOPE_INLINE V blend(ChunkBits bits, V a, V b) {
#ifdef LANESCOPE_AVX512
  if constexpr (sizeof(V) == 64) return (V)_mm512_mask_blend_epi32(bits, (__m512i)b, (__m512i)a);
  if constexpr (sizeof(V) == 32)
    return (V)_mm256_mask_blend_epi32(static_cast<__mmask8>(bits), (__m256i)b, (__m256i)a);
#endif
  return expand_bits<kLanes<V>>(bits) ? a : b;
}

/// The lanes of `bits` that equal an earlier lane of `bits`.
template <Integers V>
LANESCOPE_INLINE ChunkBits conflicts(ChunkBits bits, V v) {
#if defined(LANESCOPE_AVX512) && defined(__AVX512CD__)
  if constexpr (sizeof(V) == 64)
    return _mm512_mask_test_epi32_mask(bits, _mm512_conflict_epi32((__m512i)v),
                                       _mm512_set1_epi32(bits));
#endif
  unsigned found = 0;
  for (int i = 1; i < kLanes<V>; ++i) {
    const unsigned earlier = bits & ((1u << i) - 1);
    const auto equal = compare<Relation::kEqual>(v, broadcast<V>(v[i]));
    found |= static_cast<unsigned>((earlier & equal) != 0) << i;
  }
  return static_cast<ChunkBits>(found & bits);
}

#undef LANESCOPE_HOST_FLOAT

}  // namespace lanescope::host
