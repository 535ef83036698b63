// SPDX-License-Identifier: MIT
#include "lockstep_fused.h"

#include "examples/edge_test3/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

extern const Kernel k_lockstep_fused;
const Kernel k_lockstep_fused =
    lockstep_kernel("lockstep_fused", "LOCKSTEP with edge_test3, for triangles",
                    start_lockstep_fused, kFusedEdgeInstructions);

}  // namespace lanescope
