// SPDX-License-Identifier: MIT
// Arithmetic on each lane. Floats round to nearest, each operation by itself; integers wrap.
#pragma once

#include <limits>

#include "simulator/issue.h"

namespace lanescope::isa {

struct Add {
  static constexpr InstructionInfo kInfo{"add", "r[i] = a[i] + b[i]",
                                         InstructionClass::kArithmetic};
  template <class V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::wrapped<V>(host::wrapping(a) + host::wrapping(b));
  }
};
inline constexpr Instruction<Add> add;

struct Sub {
  static constexpr InstructionInfo kInfo{"sub", "r[i] = a[i] - b[i]",
                                         InstructionClass::kArithmetic};
  template <class V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::wrapped<V>(host::wrapping(a) - host::wrapping(b));
  }
};
inline constexpr Instruction<Sub> sub;

struct Mul {
  static constexpr InstructionInfo kInfo{"mul", "r[i] = a[i] * b[i], low half for integers",
                                         InstructionClass::kArithmetic};
  template <class V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::wrapped<V>(host::wrapping(a) * host::wrapping(b));
  }
};
inline constexpr Instruction<Mul> mul;

/// Integers as in RISC-V.
struct Div {
  static constexpr InstructionInfo kInfo{
      "div", "r[i] = a[i] / b[i]", InstructionClass::kArithmetic, Charge::kActiveLanes,
      "integers truncate; x / 0 has all bits set; the most negative int32 / -1 is itself"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return a / b;
  }
  static std::uint32_t lane(std::uint32_t a, std::uint32_t b) { return b == 0 ? ~0u : a / b; }
  static std::int32_t lane(std::int32_t a, std::int32_t b) {
    if (b == 0) return -1;
    return b == -1 ? host::wrapped<std::int32_t>(0u - host::wrapping(a)) : a / b;
  }
  static constexpr Suspicion kSuspicion{Check::kDivision,
                                        "the divisor is 0, or int32 does not hold the quotient"};
  template <host::Integers A, host::Integers B>
  static bool suspicious(A a, B b) {
    if constexpr (std::is_signed_v<A> && std::is_signed_v<B>)
      if (a == std::numeric_limits<A>::min() && b == -1) return true;
    return b == 0;
  }
};
inline constexpr Instruction<Div> div;

struct Fma {
  static constexpr InstructionInfo kInfo{"fma", "r[i] = a[i] * b[i] + c[i], rounded once",
                                         InstructionClass::kArithmetic};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a, V b, V c) {
    return host::fma(a, b, c);
  }
};
inline constexpr Instruction<Fma> fma;

struct Neg {
  static constexpr InstructionInfo kInfo{"neg", "r[i] = -a[i]", InstructionClass::kArithmetic,
                                         Charge::kActiveLanes,
                                         "the most negative int32 is its own negative"};
  template <class V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::wrapped<V>(-host::wrapping(a));
  }
};
inline constexpr Instruction<Neg> neg;

struct Abs {
  static constexpr InstructionInfo kInfo{"abs", "r[i] = |a[i]|", InstructionClass::kArithmetic,
                                         Charge::kActiveLanes,
                                         "the most negative int32 is its own absolute value"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::bits_as<float>(host::bits_as<std::uint32_t>(a) & 0x7fffffffu);
  }
  template <class V>
  requires std::same_as<host::ElementOf<V>, std::int32_t> LANESCOPE_INLINE static V lane(V a) {
    return host::max(a, host::wrapped<V>(-host::wrapping(a)));
  }
};
inline constexpr Instruction<Abs> abs;

/// One host instruction, and the same lane by lane in any order of lanes. The rule of hmin and
/// scatter_min, for which order matters, would cost five where there is no AVX-512, and there
/// treats signalling not-a-number otherwise.
struct Min {
  static constexpr InstructionInfo kInfo{
      "min", "r[i] = a[i] < b[i] ? a[i] : b[i]", InstructionClass::kArithmetic,
      Charge::kActiveLanes, "b[i] where a[i] or b[i] is not a number, and where both are zero"};
  template <class V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::min(a, b);
  }
};
inline constexpr Instruction<Min> min;

/// See Min.
struct Max {
  static constexpr InstructionInfo kInfo{
      "max", "r[i] = a[i] > b[i] ? a[i] : b[i]", InstructionClass::kArithmetic,
      Charge::kActiveLanes, "b[i] where a[i] or b[i] is not a number, and where both are zero"};
  template <class V>
  LANESCOPE_INLINE static V lane(V a, V b) {
    return host::max(a, b);
  }
};
inline constexpr Instruction<Max> max;

struct Sqrt {
  static constexpr InstructionInfo kInfo{"sqrt", "r[i] = square root of a[i]",
                                         InstructionClass::kArithmetic, Charge::kActiveLanes,
                                         "not-a-number below 0; -0 for -0"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::sqrt(a);
  }
};
inline constexpr Instruction<Sqrt> sqrt;

struct Rcp {
  static constexpr InstructionInfo kInfo{"rcp", "r[i] = 1 / a[i], correctly rounded",
                                         InstructionClass::kArithmetic, Charge::kActiveLanes,
                                         "infinity, with the sign of a[i], for a zero"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::broadcast<V>(1.0f) / a;
  }
};
inline constexpr Instruction<Rcp> rcp;

struct Floor {
  static constexpr InstructionInfo kInfo{"floor", "r[i] = largest integer not above a[i]",
                                         InstructionClass::kArithmetic, Charge::kActiveLanes,
                                         "-0, infinities and not-a-number stay"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::floor(a);
  }
};
inline constexpr Instruction<Floor> floor;

struct Ceil {
  static constexpr InstructionInfo kInfo{
      "ceil", "r[i] = smallest integer not below a[i]", InstructionClass::kArithmetic,
      Charge::kActiveLanes, "-0 between -1 and 0; -0, infinities and not-a-number stay"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V a) {
    return host::ceil(a);
  }
};
inline constexpr Instruction<Ceil> ceil;

}  // namespace lanescope::isa
