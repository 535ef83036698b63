// SPDX-License-Identifier: MIT
#pragma once

#include "frame_write.h"
#include "kernels/micropolygons/lockstep.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using LockstepConflict = BasicLockstep<Vm, P, E, StepsWithConflictsAlone>;

}  // namespace lanescope
