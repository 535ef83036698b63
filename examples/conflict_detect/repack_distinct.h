// SPDX-License-Identifier: MIT
#pragma once

#include "distinct_hits.h"
#include "kernels/micropolygons/repack.h"

namespace lanescope {

template <class Vm, Micropolygon P, Edges E>
using RepackDistinct = BasicRepack<Vm, P, E, StepsWithDistinctHits>;

}  // namespace lanescope
