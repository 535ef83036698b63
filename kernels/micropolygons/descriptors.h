// SPDX-License-Identifier: MIT
// The descriptors of LOCKSTEP and REPACK, and of kernels that differ from them in some steps. What
// such a kernel issues beside their instructions is named by INSTRUCTIONS of its program.
#pragma once

#include <string_view>

#include "kernels/kernel.h"

namespace lanescope {

/// The descriptor of LOCKSTEP in the form that `start` starts, at widths up to `most_width`.
Kernel lockstep_kernel(std::string_view name, std::string_view summary, int most_width,
                       StartExecution start);

/// The descriptor of REPACK in the form that `start` starts; likewise.
Kernel repack_kernel(std::string_view name, std::string_view summary, int most_width,
                     StartExecution start);

}  // namespace lanescope
