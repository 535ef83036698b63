// SPDX-License-Identifier: MIT
#include "lockstep_fused.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_lockstep_fused;
const Kernel k_lockstep_fused =
    lockstep_kernel("lockstep_fused", "LOCKSTEP with edge_test3, for triangles",
                    most_width_of_lockstep_fused(), start_lockstep_fused);

}  // namespace lanescope
