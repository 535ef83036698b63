// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/descriptors.h"
#include "kernels/micropolygons/starters.h"

namespace lanescope {

extern const Kernel k_repack;
const Kernel k_repack = repack_kernel(
    "repack", "work is compacted between stages to keep every lane busy (the thesis, 3.2.2)",
    most_width_of_repack(), start_repack);

}  // namespace lanescope
