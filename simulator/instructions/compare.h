// SPDX-License-Identifier: MIT
// Comparisons: the result is the mask of active lanes in which the relation holds.
#pragma once

#include "simulator/issue.h"

namespace lanescope::isa {

struct CmpEq {
  static constexpr InstructionInfo kInfo{"cmp_eq", "m[i] = a[i] == b[i]",
                                         InstructionClass::kCompare, Charge::kActiveLanes,
                                         "false where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a == b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kEqual>(a, b);
  }
};
inline constexpr Instruction<CmpEq> cmp_eq;

struct CmpNe {
  static constexpr InstructionInfo kInfo{"cmp_ne", "m[i] = a[i] != b[i]",
                                         InstructionClass::kCompare, Charge::kActiveLanes,
                                         "true where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a != b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kNotEqual>(a, b);
  }
};
inline constexpr Instruction<CmpNe> cmp_ne;

struct CmpLt {
  static constexpr InstructionInfo kInfo{"cmp_lt", "m[i] = a[i] < b[i]", InstructionClass::kCompare,
                                         Charge::kActiveLanes,
                                         "false where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a < b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kLess>(a, b);
  }
};
inline constexpr Instruction<CmpLt> cmp_lt;

struct CmpLe {
  static constexpr InstructionInfo kInfo{"cmp_le", "m[i] = a[i] <= b[i]",
                                         InstructionClass::kCompare, Charge::kActiveLanes,
                                         "false where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a <= b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kLessEqual>(a, b);
  }
};
inline constexpr Instruction<CmpLe> cmp_le;

struct CmpGt {
  static constexpr InstructionInfo kInfo{"cmp_gt", "m[i] = a[i] > b[i]", InstructionClass::kCompare,
                                         Charge::kActiveLanes,
                                         "false where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a > b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kLess>(b, a);
  }
};
inline constexpr Instruction<CmpGt> cmp_gt;

struct CmpGe {
  static constexpr InstructionInfo kInfo{"cmp_ge", "m[i] = a[i] >= b[i]",
                                         InstructionClass::kCompare, Charge::kActiveLanes,
                                         "false where a[i] or b[i] is not a number"};
  template <class T>
  static bool holds(T a, T b) {
    return a >= b;
  }
  template <class V>
  LANESCOPE_INLINE static host::MaskOf<V> decide(V a, V b) {
    return host::compare<host::Relation::kLessEqual>(b, a);
  }
};
inline constexpr Instruction<CmpGe> cmp_ge;

}  // namespace lanescope::isa
