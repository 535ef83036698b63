// SPDX-License-Identifier: MIT
// What `lanescope run` prints: a few figures of each run, as tables.
#pragma once

#include <vector>

#include "analysis/tables/table.h"

namespace lanescope {

/// A table for each kernel, scene and kind of micropolygon of the report, in its order, with a
/// column for each width.
std::vector<TableData> run_summaries(const Report& report);

}  // namespace lanescope
