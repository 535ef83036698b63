// SPDX-License-Identifier: MIT
// What the study's charts share.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "analysis/html/data_frame.h"
#include "analysis/report/report.h"

namespace lanescope::luong {

/// The columns that name a run of a mean over scenes: `kernel`, `micropolygon`, `lanes` (W).
std::vector<DataColumn> mp_columns(std::vector<DataColumn> others);

/// A choice of triangles or quads beside the chart, `pick_mp`.
nlohmann::ordered_json choice_of_mp(const Report& report);

}  // namespace lanescope::luong
