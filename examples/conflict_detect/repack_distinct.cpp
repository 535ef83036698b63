// SPDX-License-Identifier: MIT
#include "repack_distinct.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_distinct;
const Kernel k_repack_distinct =
    repack_kernel("repack_distinct", "REPACK, batches of hits without conflicts",
                  most_width_of_repack_distinct(), start_repack_distinct);

}  // namespace lanescope
