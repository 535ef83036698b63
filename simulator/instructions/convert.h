// SPDX-License-Identifier: MIT
// Conversions, and moves within a lane.
#pragma once

#include "simulator/issue.h"

namespace lanescope::isa {

struct ConvertToFloat {
  static constexpr InstructionInfo kInfo{"convert_to_float", "r[i] = float(a[i]), nearest",
                                         InstructionClass::kConvert};
  template <host::Integers V>
  LANESCOPE_INLINE static auto lane(V a) {
    return host::to_float(a);
  }
};
inline constexpr Instruction<ConvertToFloat> convert_to_float;

struct ConvertToInt {
  static constexpr InstructionInfo kInfo{
      "convert_to_int", "r[i] = int32(a[i]), truncated; most negative where out of range",
      InstructionClass::kConvert, Charge::kActiveLanes,
      "below -2147483648, 2147483648 and above, and not-a-number are out of range"};
  template <host::Floats V>
  LANESCOPE_INLINE static auto lane(V a) {
    return host::to_int(a);
  }
  static constexpr Suspicion kSuspicion{Check::kConversion, "the value is out of range"};
  static bool suspicious(float a) { return !(a >= -2147483648.0f && a < 2147483648.0f); }
};
inline constexpr Instruction<ConvertToInt> convert_to_int;

struct ConvertToUint {
  static constexpr InstructionInfo kInfo{
      "convert_to_uint", "r[i] = uint32(a[i]), truncated; largest where out of range",
      InstructionClass::kConvert, Charge::kActiveLanes,
      "-1 and below, 4294967296 and above, and not-a-number are out of range"};
  template <host::Floats V>
  LANESCOPE_INLINE static auto lane(V a) {
    return host::to_uint(a);
  }
  static constexpr Suspicion kSuspicion{Check::kConversion, "the value is out of range"};
  static bool suspicious(float a) { return !(a > -1.0f && a < 4294967296.0f); }
};
inline constexpr Instruction<ConvertToUint> convert_to_uint;

/// The bits of a float as an integer, and back.
struct BitsToUint {
  static constexpr InstructionInfo kInfo{"bits_to_uint", "r[i] = the bits of a[i]",
                                         InstructionClass::kConvert};
  template <class V>
  LANESCOPE_INLINE static auto lane(V a) {
    return host::bits_as<std::uint32_t>(a);
  }
};
inline constexpr Instruction<BitsToUint> bits_to_uint;

struct BitsToFloat {
  static constexpr InstructionInfo kInfo{"bits_to_float", "r[i] = the float with the bits a[i]",
                                         InstructionClass::kConvert};
  template <host::Integers V>
  LANESCOPE_INLINE static auto lane(V a) {
    return host::bits_as<float>(a);
  }
};
inline constexpr Instruction<BitsToFloat> bits_to_float;

/// A vector with one value in every lane: broadcast(on, vector_of_that_type_or_scalar).
struct Broadcast {
  static constexpr InstructionInfo kInfo{"broadcast", "r[i] = s", InstructionClass::kMove};
  template <int W, class T>
  requires std::is_arithmetic_v<T> LANESCOPE_INLINE static Vec<T, W> apply(Mask<W>, T s) {
    return Vec<T, W>::broadcast(s);
  }
};
inline constexpr Instruction<Broadcast> broadcast;

struct LaneIndex {
  static constexpr InstructionInfo kInfo{"lane_index", "r[i] = i, int32", InstructionClass::kMove};
  template <int W>
  LANESCOPE_INLINE static Vec<std::int32_t, W> apply(Mask<W>) {
    Vec<std::int32_t, W> r;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      r.chunk[c] = host::iota<kChunkLanes<W>>(c * kChunkLanes<W>);
    });
    return r;
  }
};
inline constexpr Instruction<LaneIndex> lane_index;

/// Chooses by a mask: select(on, chosen, a, b). Reads only the operand that is chosen.
struct Select {
  static constexpr InstructionInfo kInfo{"select", "r[i] = chosen[i] ? a[i] : b[i]",
                                         InstructionClass::kMove};
  template <int W, class A, class B>
  requires detail::kIsVec<A> || detail::kIsVec<B> LANESCOPE_INLINE static auto apply(Mask<W>,
                                                                                     Mask<W> chosen,
                                                                                     const A& a,
                                                                                     const B& b) {
    using R = typename detail::FirstElement<A, B>::type;
    R r;
    host::unroll<kChunks<W>>([&](auto c) LANESCOPE_INLINE_LAMBDA {
      using Chunk = typename R::Chunk;
      r.chunk[c] = host::blend(chosen.chunk(c), detail::chunk_of<Chunk>(a, c),
                               detail::chunk_of<Chunk>(b, c));
    });
    return r;
  }
  template <int W, class A, class B>
  static Mask<W> reads(int operand, Mask<W> active, Mask<W> chosen, const A&, const B&) {
    return operand == 1 ? active & chosen : active & ~chosen;
  }
};
inline constexpr Instruction<Select> select;

/// A masked move: active lanes take `a`, the others keep `rest`.
struct Move {
  static constexpr InstructionInfo kInfo{"move", "r[i] = a[i]; lanes that are off keep rest[i]",
                                         InstructionClass::kMove};
  static constexpr int kRest = 1;
  template <int W, class A, class T>
  LANESCOPE_INLINE static Vec<T, W> apply(Mask<W> active, const A& a, const Vec<T, W>& rest) {
    return Select::apply(active, active, a, rest);
  }
};
inline constexpr Instruction<Move> move;

}  // namespace lanescope::isa
