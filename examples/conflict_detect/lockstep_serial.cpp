// SPDX-License-Identifier: MIT
#include "lockstep_serial.h"

#include "examples/conflict_detect/starters.h"
#include "kernels/micropolygons/descriptors.h"

namespace lanescope {

extern const Kernel k_lockstep_serial;
const Kernel k_lockstep_serial =
    lockstep_kernel("lockstep_serial", "LOCKSTEP, each hit written by itself",
                    start_lockstep_serial, kFrameWriteInstructions);

}  // namespace lanescope
