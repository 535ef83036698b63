// SPDX-License-Identifier: MIT
#include "lockstep_conflict.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_lockstep_conflict;
const Kernel k_lockstep_conflict = lockstep_kernel(
    "lockstep_conflict", "LOCKSTEP, hits written in parallel, conflicting ones by themselves",
    most_width_of_lockstep_conflict(), start_lockstep_conflict);

}  // namespace lanescope
