// SPDX-License-Identifier: MIT
// What a command runs if nothing is asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/configuration/configuration.h"
#include "analysis/studies/study.h"

namespace lanescope {

/// The kind of work of the program's first kernel.
const Workload& usual_workload();

/// The kernels of a kind that issue instructions; all of it, if there are none.
std::vector<const Kernel*> usual_kernels(const Workload& workload = usual_workload());

/// 8, 16, 32 and 64, as far as the kernel can; else the largest width that it can.
std::vector<std::uint64_t> usual_widths(const Kernel& kernel);

/// The studies whose word for some scenes can stand for scenes of a kind of work.
std::vector<const Study*> scene_groups(const Workload& workload);

}  // namespace lanescope
