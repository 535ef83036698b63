// SPDX-License-Identifier: MIT
// Integer and bit instructions on each lane.
#pragma once

#include "simulator/issue.h"

namespace lanescope::isa {

struct BitAnd {
  static constexpr InstructionInfo kInfo{"bit_and", "r[i] = a[i] & b[i]",
                                         InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a & b;
  }
};
inline constexpr Instruction<BitAnd> bit_and;

struct BitOr {
  static constexpr InstructionInfo kInfo{"bit_or", "r[i] = a[i] | b[i]",
                                         InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a | b;
  }
};
inline constexpr Instruction<BitOr> bit_or;

struct BitXor {
  static constexpr InstructionInfo kInfo{"bit_xor", "r[i] = a[i] ^ b[i]",
                                         InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a ^ b;
  }
};
inline constexpr Instruction<BitXor> bit_xor;

struct BitAndnot {
  static constexpr InstructionInfo kInfo{"bit_andnot", "r[i] = a[i] & ~b[i]",
                                         InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a & ~b;
  }
};
inline constexpr Instruction<BitAndnot> bit_andnot;

struct BitNot {
  static constexpr InstructionInfo kInfo{"bit_not", "r[i] = ~a[i]", InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a) {
    return ~a;
  }
};
inline constexpr Instruction<BitNot> bit_not;

namespace detail_integer {

inline constexpr Suspicion kShiftCount{Check::kShiftCount, "the count is not from 0 to 31"};

/// A rotation is periodic, so that no count is out of its range; a shift is not.
template <class T>
constexpr bool is_no_shift_count(T count) {
  return static_cast<std::uint32_t>(count) > 31;
}

}  // namespace detail_integer

struct Shl {
  static constexpr InstructionInfo kInfo{"shl", "r[i] = a[i] << b[i]", InstructionClass::kInteger,
                                         Charge::kActiveLanes,
                                         "b[i] is taken modulo 32: 32 is 0, -1 is 31"};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::wrapped<V>(host::wrapping(a) << (host::wrapping(b) & 31u));
  }
  static constexpr Suspicion kSuspicion = detail_integer::kShiftCount;
  template <class A, class B>
  static bool suspicious(A, B count) {
    return detail_integer::is_no_shift_count(count);
  }
};
inline constexpr Instruction<Shl> shl;

struct Shr {
  static constexpr InstructionInfo kInfo{"shr", "r[i] = a[i] >> b[i], keeping the sign of int32",
                                         InstructionClass::kInteger, Charge::kActiveLanes,
                                         "b[i] is taken modulo 32: 32 is 0, -1 is 31"};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a >> (b & 31);
  }
  static constexpr Suspicion kSuspicion = detail_integer::kShiftCount;
  template <class A, class B>
  static bool suspicious(A, B count) {
    return detail_integer::is_no_shift_count(count);
  }
};
inline constexpr Instruction<Shr> shr;

struct Rotl {
  static constexpr InstructionInfo kInfo{"rotl", "r[i] = a[i] rotated left by b[i]",
                                         InstructionClass::kInteger, Charge::kActiveLanes,
                                         "b[i] is taken modulo 32: 32 is 0, -1 is 31"};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    const auto left = host::wrapping(b) & 31u;
    const auto right = (32u - left) & 31u;
    return host::wrapped<V>(host::wrapping(a) << left | host::wrapping(a) >> right);
  }
};
inline constexpr Instruction<Rotl> rotl;

struct Popcount {
  static constexpr InstructionInfo kInfo{"popcount", "r[i] = number of set bits of a[i]",
                                         InstructionClass::kInteger};
  template <host::Integers V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::popcount(a);
  }
};
inline constexpr Instruction<Popcount> popcount;

struct Clz {
  static constexpr InstructionInfo kInfo{"clz", "r[i] = number of leading zero bits of a[i]",
                                         InstructionClass::kInteger, Charge::kActiveLanes,
                                         "32 for 0"};
  static std::uint32_t lane(std::uint32_t a) {
    return static_cast<std::uint32_t>(std::countl_zero(a));
  }
  static std::int32_t lane(std::int32_t a) { return std::countl_zero(host::wrapping(a)); }
};
inline constexpr Instruction<Clz> clz;

struct Ctz {
  static constexpr InstructionInfo kInfo{"ctz", "r[i] = number of trailing zero bits of a[i]",
                                         InstructionClass::kInteger, Charge::kActiveLanes,
                                         "32 for 0"};
  static std::uint32_t lane(std::uint32_t a) {
    return static_cast<std::uint32_t>(std::countr_zero(a));
  }
  static std::int32_t lane(std::int32_t a) { return std::countr_zero(host::wrapping(a)); }
};
inline constexpr Instruction<Ctz> ctz;

}  // namespace lanescope::isa
