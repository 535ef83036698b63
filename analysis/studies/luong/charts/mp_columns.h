// SPDX-License-Identifier: MIT
// What the study's charts share.
#pragma once

#include <vector>

#include "analysis/html/section.h"

namespace lanescope::luong {

/// The columns that name a run of a mean over scenes: `kernel`, `micropolygon`, `lanes` (W).
std::vector<DataColumn> mp_columns(std::vector<DataColumn> others);

/// A pick of triangles or quads beside the chart.
Pick pick_of_mp();

}  // namespace lanescope::luong
