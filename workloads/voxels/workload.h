// SPDX-License-Identifier: MIT
// Worlds of cubes as a kind of work.
#pragma once

#include "workloads/work.h"

namespace lanescope {

extern const Workload w_voxels;

}  // namespace lanescope
