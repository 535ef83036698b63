// SPDX-License-Identifier: MIT
// The one mistake of a kernel that no single run shows.
#pragma once

#include <span>

#include "analysis/report/report.h"

namespace lanescope {

/// Compares the results of runs of checked mode that differ in nothing but their width. Throws
/// FailedCheck, of Check::kWidth, if they are not the same.
void require_width_independence(std::span<const RunRecord> runs);

}  // namespace lanescope
