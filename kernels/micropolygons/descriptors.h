// SPDX-License-Identifier: MIT
// The descriptors of LOCKSTEP and REPACK, and of kernels that differ from them in some steps.
#pragma once

#include <span>
#include <string_view>

#include "kernels/kernel.h"
#include "kernels/micropolygons/frame_merge.h"

namespace lanescope {

/// The descriptor of LOCKSTEP in the form that `start` starts, at widths up to `most_width`.
/// `instructions` are those that it may issue beside the instruction set.
Kernel lockstep_kernel(
    std::string_view name, std::string_view summary, int most_width, StartExecution start,
    std::span<const InstructionInfo* const> instructions = kRasterizerInstructions);

/// The descriptor of REPACK in the form that `start` starts; likewise.
Kernel repack_kernel(
    std::string_view name, std::string_view summary, int most_width, StartExecution start,
    std::span<const InstructionInfo* const> instructions = kRasterizerInstructions);

}  // namespace lanescope
