// SPDX-License-Identifier: MIT
// Instructions with a mistake each.
#pragma once

#include "simulator/instruction_set.h"

namespace wrong {

using lanescope::InstructionClass;
using lanescope::InstructionInfo;

struct Nameless {
  static float lane(float a) { return a; }
};
inline constexpr lanescope::Instruction<Nameless> nameless;

struct Shouting {
  static constexpr InstructionInfo kInfo{"SHOUT", "r[i] = a[i]", InstructionClass::kArithmetic};
  static float lane(float a) { return a; }
};
inline constexpr lanescope::Instruction<Shouting> shouting;

struct Bodiless {
  static constexpr InstructionInfo kInfo{"bodiless", "r[i] = a[i]", InstructionClass::kArithmetic};
};
inline constexpr lanescope::Instruction<Bodiless> bodiless;

struct Wide {
  static constexpr InstructionInfo kInfo{"wide", "r[i] = a[i]", InstructionClass::kArithmetic};
  static double lane(double a) { return a; }
};
inline constexpr lanescope::Instruction<Wide> wide;

struct Undecided {
  static constexpr InstructionInfo kInfo{"undecided", "a[i] < b[i]", InstructionClass::kCompare};
  static float holds(float a, float b) { return a - b; }
};
inline constexpr lanescope::Instruction<Undecided> undecided;

struct Right {
  static constexpr InstructionInfo kInfo{"right", "r[i] = a[i]", InstructionClass::kArithmetic};
  template <class V>
  static V lane(V a) {
    return a;
  }
};
inline constexpr lanescope::Instruction<Right> right;

}  // namespace wrong
