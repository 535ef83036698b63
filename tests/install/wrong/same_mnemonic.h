// SPDX-License-Identifier: MIT
// Takes the name of an instruction that exists.
#pragma once

#include "simulator/instruction_set.h"

struct SaturatingAdd {
  static constexpr lanescope::InstructionInfo kInfo{"add", "r[i] = min(a[i] + b[i], 1)",
                                                    lanescope::InstructionClass::kArithmetic};
  static float lane(float a, float b) { return a + b < 1.0f ? a + b : 1.0f; }
};
inline constexpr lanescope::Instruction<SaturatingAdd> saturating_add;
