// SPDX-License-Identifier: MIT
// The page docs/instructions.md.
#pragma once

#include <span>
#include <string>

#include "simulator/instruction.h"

namespace lanescope {

/// A reference of instructions in Markdown, made from their descriptors.
std::string instruction_reference(std::span<const InstructionInfo* const> instructions);

}  // namespace lanescope
