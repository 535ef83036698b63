// SPDX-License-Identifier: MIT
#pragma once

#include "workloads/work.h"

namespace lanescope {

/// Micropolygons: packets of triangles or quads about the size of a pixel, tessellated from
/// built-in scenes or from meshes.
extern const Workload w_micropolygons;

}  // namespace lanescope
