// SPDX-License-Identifier: MIT
#include "repack_fused.h"

#include "examples/edge_test3/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

extern const Kernel k_repack_fused;
const Kernel k_repack_fused = repack_kernel("repack_fused", "REPACK with edge_test3, for triangles",
                                            start_repack_fused, kFusedEdgeInstructions);

}  // namespace lanescope
