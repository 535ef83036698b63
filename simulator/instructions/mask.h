// SPDX-License-Identifier: MIT
// Mask logic. Results are off where the block is off. Queries give a scalar about the active lanes.
#pragma once

#include "simulator/issue.h"

namespace lanescope::isa {

struct MaskAnd {
  static constexpr InstructionInfo kInfo{"mask_and", "m = a & b", InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static Mask<W> apply(Mask<W> active, Mask<W> a, Mask<W> b) {
    return active & a & b;
  }
};
inline constexpr Instruction<MaskAnd> mask_and;

struct MaskOr {
  static constexpr InstructionInfo kInfo{"mask_or", "m = a | b", InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static Mask<W> apply(Mask<W> active, Mask<W> a, Mask<W> b) {
    return active & (a | b);
  }
};
inline constexpr Instruction<MaskOr> mask_or;

struct MaskXor {
  static constexpr InstructionInfo kInfo{"mask_xor", "m = a ^ b", InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static Mask<W> apply(Mask<W> active, Mask<W> a, Mask<W> b) {
    return active & (a ^ b);
  }
};
inline constexpr Instruction<MaskXor> mask_xor;

struct MaskAndnot {
  static constexpr InstructionInfo kInfo{"mask_andnot", "m = a & ~b", InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static Mask<W> apply(Mask<W> active, Mask<W> a, Mask<W> b) {
    return active & a & ~b;
  }
};
inline constexpr Instruction<MaskAndnot> mask_andnot;

struct MaskNot {
  static constexpr InstructionInfo kInfo{"mask_not", "m = ~a", InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static Mask<W> apply(Mask<W> active, Mask<W> a) {
    return active & ~a;
  }
};
inline constexpr Instruction<MaskNot> mask_not;

struct Any {
  static constexpr InstructionInfo kInfo{"any", "x = whether a[i] in some active lane",
                                         InstructionClass::kMask, Charge::kActiveLanes,
                                         "false if no lane is active"};
  template <int W>
  LANESCOPE_INLINE static bool apply(Mask<W> active, Mask<W> a) {
    return (active & a).any();
  }
};
inline constexpr Instruction<Any> any;

struct All {
  static constexpr InstructionInfo kInfo{"all", "x = whether a[i] in every active lane",
                                         InstructionClass::kMask, Charge::kActiveLanes,
                                         "true if no lane is active"};
  template <int W>
  LANESCOPE_INLINE static bool apply(Mask<W> active, Mask<W> a) {
    return !(active & ~a).any();
  }
};
inline constexpr Instruction<All> all;

struct None {
  static constexpr InstructionInfo kInfo{"none", "x = whether a[i] in no active lane",
                                         InstructionClass::kMask, Charge::kActiveLanes,
                                         "true if no lane is active"};
  template <int W>
  LANESCOPE_INLINE static bool apply(Mask<W> active, Mask<W> a) {
    return !(active & a).any();
  }
};
inline constexpr Instruction<None> none;

struct Count {
  static constexpr InstructionInfo kInfo{"count", "x = number of active i with a[i]",
                                         InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static int apply(Mask<W> active, Mask<W> a) {
    return (active & a).count();
  }
};
inline constexpr Instruction<Count> count;

struct First {
  static constexpr InstructionInfo kInfo{"first", "x = lowest active i with a[i], or -1",
                                         InstructionClass::kMask};
  template <int W>
  LANESCOPE_INLINE static int apply(Mask<W> active, Mask<W> a) {
    const std::uint64_t bits = (active & a).bits();
    return bits == 0 ? -1 : std::countr_zero(bits);
  }
};
inline constexpr Instruction<First> first;

}  // namespace lanescope::isa
