// SPDX-License-Identifier: MIT
#include "repack_serial.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_repack_serial;
const Kernel k_repack_serial = repack_kernel("repack_serial", "REPACK, each hit written by itself",
                                             most_width_of_repack_serial(), start_repack_serial);

}  // namespace lanescope
