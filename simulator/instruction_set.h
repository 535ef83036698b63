// SPDX-License-Identifier: MIT
// The instruction set: every instruction that the machine comes with, and their descriptors. This
// is the header that programs include.
#pragma once

#include <span>

#include "simulator/instructions/arithmetic.h"
#include "simulator/instructions/atomic.h"
#include "simulator/instructions/compare.h"
#include "simulator/instructions/convert.h"
#include "simulator/instructions/cross_lane.h"
#include "simulator/instructions/integer.h"
#include "simulator/instructions/mask.h"
#include "simulator/instructions/memory.h"
#include "simulator/instructions/reduce.h"

namespace lanescope {

/// The descriptors of the instruction set, in the order of the list.
std::span<const InstructionInfo* const> instruction_set();

}  // namespace lanescope
