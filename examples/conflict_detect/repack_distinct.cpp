// SPDX-License-Identifier: MIT
#include "repack_distinct.h"

#include "examples/conflict_detect/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

extern const Kernel k_repack_distinct;
const Kernel k_repack_distinct =
    repack_kernel("repack_distinct", "REPACK, batches of hits without conflicts",
                  start_repack_distinct, kFrameWriteInstructions);

}  // namespace lanescope
