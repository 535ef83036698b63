// SPDX-License-Identifier: MIT
// What if the machine had an instruction for edge functions?
#pragma once

#include "simulator/instruction_set.h"

namespace lanescope {

/// edge_function(on, ax, ay, bx, by): positive where the origin lies inside the edge from a to b.
struct EdgeFunction {
  static constexpr InstructionInfo kInfo{"edge_function", "r[i] = ax[i] * by[i] - ay[i] * bx[i]",
                                         InstructionClass::kArithmetic, Charge::kActiveLanes,
                                         "both products and the difference are rounded"};
  template <host::Floats V>
  LANESCOPE_INLINE static V lane(V ax, V ay, V bx, V by) {
    return ax * by - ay * bx;
  }
};
inline constexpr Instruction<EdgeFunction> edge_function;

}  // namespace lanescope
