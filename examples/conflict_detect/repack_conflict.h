// SPDX-License-Identifier: MIT
#pragma once

#include "frame_write.h"
#include "kernels/micropolygons/repack.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using RepackConflict = BasicRepack<Vm, P, E, StepsWithConflictsAlone>;

}  // namespace lanescope
