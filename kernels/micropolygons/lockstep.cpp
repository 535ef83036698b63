// SPDX-License-Identifier: MIT
#include "kernels/micropolygons/descriptors.h"
#include "kernels/micropolygons/starters.h"

namespace lanescope {

extern const Kernel k_lockstep;
const Kernel k_lockstep =
    lockstep_kernel("lockstep", "W micropolygons in lockstep, one in each lane (the thesis, 3.2.1)",
                    most_width_of_lockstep(), start_lockstep);

}  // namespace lanescope
