// SPDX-License-Identifier: MIT
#pragma once

#include "frame_write.h"
#include "kernels/micropolygons/repack.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using RepackSerial = BasicRepack<Vm, P, E, StepsWithEachHitAlone>;

}  // namespace lanescope
