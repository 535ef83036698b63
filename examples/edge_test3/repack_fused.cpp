// SPDX-License-Identifier: MIT
#include "repack_fused.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_fused;
const Kernel k_repack_fused = repack_kernel("repack_fused", "REPACK with edge_test3, for triangles",
                                            most_width_of_repack_fused(), start_repack_fused);

}  // namespace lanescope
