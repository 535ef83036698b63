// SPDX-License-Identifier: MIT
// What `lanescope run` prints: a few figures of each run, as tables.
#pragma once

#include <vector>

#include "analysis/tables/table.h"

namespace lanescope {

/// A table for each kernel, scene and facet of the report, in its order, with a column for each
/// width. Runs that differ in other parameters are in tables of their own.
std::vector<TableData> run_summaries(const Report& report);

}  // namespace lanescope
