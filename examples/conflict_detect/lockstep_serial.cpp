// SPDX-License-Identifier: MIT
#include "lockstep_serial.h"

#include "kernels/micropolygons/descriptors.h"
#include "starters.h"

namespace lanescope {

extern const Kernel k_lockstep_serial;
const Kernel k_lockstep_serial =
    lockstep_kernel("lockstep_serial", "LOCKSTEP, each hit written by itself",
                    most_width_of_lockstep_serial(), start_lockstep_serial);

}  // namespace lanescope
