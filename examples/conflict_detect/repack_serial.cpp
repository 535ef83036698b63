// SPDX-License-Identifier: MIT
#include "repack_serial.h"

#include "examples/conflict_detect/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

extern const Kernel k_repack_serial;
const Kernel k_repack_serial = repack_kernel("repack_serial", "REPACK, each hit written by itself",
                                             start_repack_serial, kFrameWriteInstructions);

}  // namespace lanescope
