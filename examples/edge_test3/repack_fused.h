// SPDX-License-Identifier: MIT
#pragma once

#include "fused_edges.h"
#include "kernels/micropolygons/repack.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using RepackFused = BasicRepack<Vm, P, E, StepsWithFusedEdges>;

}  // namespace lanescope
