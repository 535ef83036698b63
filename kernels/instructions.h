// SPDX-License-Identifier: MIT
// The instructions of a program: the machine's, its own, and those of its kernels.
#pragma once

#include <vector>

#include "simulator/instruction.h"

namespace lanescope {

/// The instruction set, then the program's own instructions, then what kernels issue beside them,
/// each once. Throws InputError, with what both are, if two have one mnemonic.
std::vector<const InstructionInfo*> all_instructions();

}  // namespace lanescope
