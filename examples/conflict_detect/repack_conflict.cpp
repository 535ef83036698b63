// SPDX-License-Identifier: MIT
#include "repack_conflict.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_conflict;
const Kernel k_repack_conflict = repack_kernel(
    "repack_conflict", "REPACK, hits written in parallel, conflicting ones by themselves",
    most_width_of_repack_conflict(), start_repack_conflict);

}  // namespace lanescope
