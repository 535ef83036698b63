// SPDX-License-Identifier: MIT
// The host's side of the machine: a simulated vector is an array of chunks, each a vector type of
// the compiler. Operators work on chunks as they do on scalars; what has no operator is here, for
// a scalar (the definition) and for a chunk (the same, lane by lane, as fast as the host can).
// Masks are in host_mask.h, loads and stores in host_memory.h.
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

// The kind of host that this translation unit is compiled for. Layouts of vectors and masks follow
// it, so whatever they are part of is declared in an inline namespace of this name: parts compiled
// for other kinds of host do not link with each other, where they would miscount.
#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__AVX512BW__)
#define LANESCOPE_AVX512 1
#define LANESCOPE_HOST avx512
#elif defined(__AVX2__)
#define LANESCOPE_HOST avx2
#elif defined(__SSE4_2__)
#define LANESCOPE_HOST sse4
#else
#define LANESCOPE_HOST generic
#endif

namespace lanescope::host::inline LANESCOPE_HOST {

/// Does nothing. A machine calls it, so that a program compiled for another kind of host than the
/// library does not link.
void require_same_host();

/// Lanes of a chunk for a machine of W lanes. What W leaves of the last chunk is never active.
template <int W>
constexpr int chunk_lanes() {
#if defined(LANESCOPE_AVX512)
  if (W >= 16) return 16;
  if (W == 8) return 8;
#elif defined(__AVX2__)
  if (W % 8 == 0) return 8;
#endif
  return 4;
}

template <class T, int N>
struct ChunkOf {
  typedef T type __attribute__((vector_size(sizeof(T) * N)));
};
template <class T, int N>
using Chunk = typename ChunkOf<T, N>::type;

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

/// The bits of floats as int32 that are ordered as the floats are, with -0 below +0.
template <Floats V>
LANESCOPE_INLINE Rebind<V, std::int32_t> ordered_bits(V a) {
  const auto bits = bits_as<std::int32_t>(a);
  return bits ^ (bits >> 31 & 0x7fffffff);
}
/// The inverse of ordered_bits().
LANESCOPE_INLINE float from_ordered_bits(std::int32_t bits) {
  return bits_as<float>(bits ^ (bits >> 31 & 0x7fffffff));
}

/// maximumNumber of IEEE 754-2019 of two scalars: a number before not-a-number, +0 before -0, so
/// that it does not depend on their order.
template <Scalar T>
T maximum_number(T a, T b) {
  if constexpr (std::is_integral_v<T>) {
    return max(a, b);
  } else {
    if (a != a && b != b) return std::numeric_limits<T>::quiet_NaN();
    if (a != a || b != b) return a != a ? b : a;
    return ordered_bits(a) < ordered_bits(b) ? b : a;
  }
}

/// minimumNumber of IEEE 754-2019: a number before not-a-number, -0 before +0.
template <Scalar T>
T minimum_number(T a, T b) {
  if constexpr (std::is_integral_v<T>) {
    return min(a, b);
  } else {
    if (a != a && b != b) return std::numeric_limits<T>::quiet_NaN();
    if (a != a || b != b) return a != a ? b : a;
    return ordered_bits(a) < ordered_bits(b) ? a : b;
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

/// Number of set bits of each lane.
template <Integers V>
LANESCOPE_INLINE V popcount(V a) {
  const auto lane = [](auto x) {
    return decltype(x)(std::popcount(static_cast<std::uint32_t>(x)));
  };
#if defined(LANESCOPE_AVX512) && defined(__AVX512VPOPCNTDQ__)
  if constexpr (sizeof(V) == 64) return (V)_mm512_popcnt_epi32((__m512i)a);
#endif
  if constexpr (Scalar<V>) {
    return lane(a);
  } else {
    // Adds neighbours: bits, pairs, nibbles, and then the four bytes of a lane.
    auto x = bits_as<std::uint32_t>(a);
    x -= x >> 1 & 0x55555555u;
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    x = (x + (x >> 4)) & 0x0f0f0f0fu;
    return wrapped<V>(x * 0x01010101u >> 24);
  }
}

#undef LANESCOPE_HOST_FLOAT

}  // namespace lanescope::host::inline LANESCOPE_HOST
