// SPDX-License-Identifier: MIT
#pragma once

#include "frame_write.h"
#include "kernels/micropolygons/lockstep.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using LockstepSerial = BasicLockstep<Vm, P, E, StepsWithEachHitAlone>;

}  // namespace lanescope
