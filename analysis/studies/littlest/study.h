// SPDX-License-Identifier: MIT
// Charlie, The Littlest CPU Rasterizer, blog post 2013: one-bit cubemaps of voxels in vector
// registers, turned into spherical harmonics for the light of the sky.
#pragma once

#include "analysis/studies/study.h"

namespace lanescope {

/// Utilization and instructions, how they depend on how full the world is, which form wins, what
/// the conversion takes and misses, and the article's claims.
const std::vector<const Table*>& littlest_tables();
const std::vector<const Section*>& littlest_sections();

extern const Study study_littlest;

}  // namespace lanescope
