// SPDX-License-Identifier: MIT
#include "repack_records.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_records;
const Kernel k_repack_records =
    repack_kernel("repack_records", "REPACK whose hits carry their edge values",
                  most_width_of_repack_records(), start_repack_records);

}  // namespace lanescope
