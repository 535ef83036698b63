// SPDX-License-Identifier: MIT
#pragma once

#include "fused_edges.h"
#include "kernels/micropolygons/lockstep.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using LockstepFused = BasicLockstep<Vm, P, E, StepsWithFusedEdges>;

}  // namespace lanescope
