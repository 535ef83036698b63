// SPDX-License-Identifier: MIT
// Edward Luong, Data-Parallel Rasterization of Micropolygons, honors thesis, Stanford 2010:
// LOCKSTEP and REPACK on triangles and quads.
#pragma once

#include "analysis/studies/study.h"

namespace lanescope {

/// Tables 4.1 to 4.6, figure 4.2, the claims of the text, and how far ours are from all of them.
const std::vector<const Table*>& luong_tables();
const std::vector<const Section*>& luong_sections();

extern const Study study_luong;

}  // namespace lanescope
